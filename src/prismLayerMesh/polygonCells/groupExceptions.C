/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "groupExceptions.H"

#include "disjointSets.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

boolList bisect(const UList<vector>& x)
{
    labelPair furthest(0, 0);
    scalar most = -1;
    forAll(x, i)
    {
        for (label j = 0; j < i; ++j)
        {
            const scalar distance = magSqr(x[i] - x[j]);
            if (distance > most)
            {
                most = distance;
                furthest = labelPair(j, i);
            }
        }
    }
    boolList isNearSecond(x.size());
    forAll(x, i)
    {
        isNearSecond[i] =
            magSqr(x[i] - x[furthest.second()])
          < magSqr(x[i] - x[furthest.first()]);
    }

    return isNearSecond;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void groupExceptions::divide
(
    const labelUList& corners,
    const UList<vector>& places,
    const UList<labelPair>& beside
)
{
    const boolList isNearSecond(bisect(places));
    disjointSets sets(corners.size());
    for (const labelPair& pair : beside)
    {
        if (isNearSecond[pair.first()] == isNearSecond[pair.second()])
        {
            sets.join(pair.first(), pair.second());
        }
    }
    bool isDivided = false;
    forAll(corners, i)
    {
        isDivided = isDivided || sets.find(i) > 0;
    }
    forAll(corners, i)
    {
        parts_.set(corners[i], nParts_ + (isDivided ? sets.find(i) : i));
    }
    nParts_ += corners.size();
}


label groupExceptions::nPartsInUse() const
{
    bitSet parts(nParts_);
    forAllConstIters(parts_, iter)
    {
        parts.set(iter.val());
    }

    return parts.count();
}

} // End namespace Foam

// ************************************************************************* //
