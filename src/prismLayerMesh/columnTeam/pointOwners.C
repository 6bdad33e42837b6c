/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointOwners.H"
#include "labelRange.H"
#include "DynamicList.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A range that begins elsewhere has to be better by this share of the hard
//  points: the copies of columns at its further border take time, too
static const scalar leastGain = 0.02;


//- Where a range of some length has to begin to have a share of the hard
//  points. Beyond the end of the points the range goes on at their beginning.
static label startOfRange
(
    const labelUList& points,
    const UList<bool>& isHard,
    const label length,
    const scalar share
)
{
    const label n = points.size();
    label nHard = 0, inRange = 0;
    for (label i = 0; i < n; ++i)
    {
        nHard += isHard[points[i]];
        inRange += i < length && isHard[points[i]];
    }

    const scalar wanted = share*nHard;
    label best = 0;
    scalar least = mag(inRange - wanted) - leastGain*wanted;
    for (label start = 1; start < n; ++start)
    {
        inRange += isHard[points[(start + length - 1) % n]];
        inRange -= isHard[points[start - 1]];
        if (mag(inRange - wanted) < least)
        {
            least = mag(inRange - wanted);
            best = start;
        }
    }

    return best;
}


//- Divides points between processes
static void divide
(
    const labelUList& points,
    const UList<bool>& isHard,
    const labelRange& processes,
    labelList& processOfPoint
)
{
    if (processes.size() == 1)
    {
        for (const label p : points)
        {
            processOfPoint[p] = processes.start();
        }
        return;
    }

    const label nFirst = processes.size()/2;
    const scalar share = scalar(nFirst)/processes.size();
    const label n = points.size();

    // Rounded up: if there are points, the master has some
    const label length =
        (std::int64_t(n)*nFirst + processes.size() - 1)/processes.size();
    const label start = startOfRange(points, isHard, length, share);
    const label end = start + length;

    DynamicList<label> first(length), second(n - length);
    forAll(points, i)
    {
        const bool isIn =
            (i >= start && i < end) || (i + n >= start && i + n < end);
        (isIn ? first : second).append(points[i]);
    }
    divide
    (
        first, isHard, labelRange(processes.start(), nFirst), processOfPoint
    );
    divide
    (
        second, isHard,
        labelRange(processes.start() + nFirst, processes.size() - nFirst),
        processOfPoint
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

pointOwners::pointOwners(const labelUList& processOfPoint)
{
    DynamicList<label> starts, processes;
    forAll(processOfPoint, p)
    {
        if (processes.empty() || processes.last() != processOfPoint[p])
        {
            starts.append(p);
            processes.append(processOfPoint[p]);
        }
    }
    starts_ = std::move(starts);
    processes_ = std::move(processes);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label pointOwners::operator()(const label pointi) const
{
    return processes_
    [
        std::upper_bound(starts_.begin(), starts_.end(), pointi)
      - starts_.begin() - 1
    ];
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList ownersByRange(const label nPoints, const label nProcesses)
{
    labelList owners(nPoints);
    forAll(owners, p)
    {
        owners[p] = std::int64_t(p)*nProcesses/nPoints;
    }

    return owners;
}


pointOwners balancedOwners
(
    const UList<bool>& isHard,
    const label nProcesses
)
{
    labelList processOfPoint(isHard.size(), 0);
    divide
    (
        identity(isHard.size()), isHard, labelRange(0, nProcesses),
        processOfPoint
    );

    return pointOwners(processOfPoint);
}

} // End namespace Foam

// ************************************************************************* //
