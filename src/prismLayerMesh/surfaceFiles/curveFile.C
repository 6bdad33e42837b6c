/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "curveFile.H"
#include "DynamicList.H"
#include "error.H"
#include "IFstream.H"
#include "unitConversion.H"

#include <Eigen/Core>
#include <unsupported/Eigen/Splines>

#include <algorithm>
#include <sstream>

namespace Foam
{

scalar planeCurve::area2() const
{
    scalar sum = 0;
    forAll(points, i)
    {
        const vector2D& a = points[i];
        const vector2D& b = points[points.fcIndex(i)];
        sum += a.x()*b.y() - a.y()*b.x();
    }

    return sum;
}


bool isCurveFile(const fileName& file)
{
    const word extension(file.ext());

    return extension == "dat" || extension == "csv" || extension == "txt";
}


// * * * * * * * * * * * * * * Read Curve File * * * * * * * * * * * * * * * //

//- The numbers of a line; none if it has anything else
static DynamicList<scalar> numbersOf(std::string line)
{
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream is(line);
    DynamicList<scalar> numbers;
    std::string text;
    while (is >> text)
    {
        scalar number = 0;
        if (!readScalar(text.c_str(), number))
        {
            return DynamicList<scalar>();
        }
        numbers.append(number);
    }

    return numbers;
}


//- Whether a line of a file of aerofoils parts two elements: 999 999
static bool isSeparator(const UList<scalar>& numbers)
{
    return numbers[0] == 999 && numbers[1] == 999;
}


//- The runs of points between other lines
static List<DynamicList<vector2D>> readRuns
(
    const fileName& file,
    const bool isAerofoil
)
{
    IFstream is(file);
    if (!is.good())
    {
        FatalErrorInFunction
            << "Cannot read the curve " << file << ": there is no such file"
            << exit(FatalError);
    }

    DynamicList<DynamicList<vector2D>> runs(1);
    runs.append(DynamicList<vector2D>());
    std::string line;
    while (std::getline(is.stdStream(), line))
    {
        const DynamicList<scalar> n(numbersOf(line));
        const bool isPoint =
            (n.size() == 2 || n.size() == 3)
         && !(isAerofoil && isSeparator(n));
        if (isPoint)
        {
            const vector2D x(n[0], n[1]);
            DynamicList<vector2D>& run = runs.last();
            if (run.empty() || mag(run.last() - x) > 0)
            {
                run.append(x);
            }
        }
        else if (runs.last().size())
        {
            runs.append(DynamicList<vector2D>());
        }
    }

    return List<DynamicList<vector2D>>(std::move(runs));
}


//- The upper curve backwards, then the lower curve: both begin at the leading
//  edge
static DynamicList<vector2D> joinedAtNose
(
    const UList<vector2D>& upper,
    const UList<vector2D>& lower
)
{
    DynamicList<vector2D> all(upper.size() + lower.size());
    for (label i = upper.size() - 1; i >= 0; --i)
    {
        all.append(upper[i]);
    }
    for (label i = mag(lower[0] - upper[0]) > 0 ? 0 : 1; i < lower.size(); ++i)
    {
        all.append(lower[i]);
    }

    return all;
}


//- Joins pairs of halves if the runs begin with numbers of points, as
//  Lednicer's do
static void joinHalves(List<DynamicList<vector2D>>& runs)
{
    if (runs.size() < 2 || runs[0].empty() || cmptMin(runs[0][0]) <= 1.5)
    {
        return;
    }

    DynamicList<DynamicList<vector2D>> halves;
    for (DynamicList<vector2D>& run : runs)
    {
        const label first = &run == &runs[0] ? 1 : 0;
        if (run.size() > first + 1)
        {
            halves.append
            (
                DynamicList<vector2D>
                (
                    SubList<vector2D>(run, run.size() - first, first)
                )
            );
        }
    }
    runs.clear();
    for (label i = 0; i + 1 < halves.size(); i += 2)
    {
        runs.append(joinedAtNose(halves[i], halves[i + 1]));
    }
}


List<planeCurve> readCurveFile(const fileName& file)
{
    const bool isAerofoil = file.ext() == "dat";
    List<DynamicList<vector2D>> runs(readRuns(file, isAerofoil));
    if (isAerofoil)
    {
        joinHalves(runs);
    }

    DynamicList<planeCurve> curves;
    for (const DynamicList<vector2D>& run : runs)
    {
        if (run.empty())
        {
            continue;
        }
        planeCurve curve;
        const bool repeats =
            run.size() > 1 && mag(run.last() - run[0]) == 0;
        curve.isClosed = isAerofoil || repeats;
        curve.points = SubList<vector2D>(run, run.size() - repeats);
        if (curve.points.size() < (curve.isClosed ? 3 : 2))
        {
            FatalErrorInFunction
                << "Cannot use the curve " << file << ": one of its curves has "
                << curve.points.size() << " points, at " << curve.points[0]
                << nl << "An open curve needs two points, a closed one three"
                << exit(FatalError);
        }
        curves.append(curve);
    }
    if (curves.empty())
    {
        FatalErrorInFunction
            << "Cannot use the curve " << file << ": there are no points in it"
            << exit(FatalError);
    }

    return List<planeCurve>(std::move(curves));
}


// * * * * * * * * * * * * * * * * Resampled * * * * * * * * * * * * * * * * //

namespace
{

//- Constants that were chosen
const struct
{
    //- A corner turns by more [rad]
    scalar corner = degToRad(30.0);

    //- Edges at corners over the longest ones; growth from edge to edge
    scalar cornerShare = 0.1;
    scalar growth = 1.15;

    //- Samples of a spline, on which sizes are known: between two of its
    //  points, and on a longest edge, at least
    label nBetween = 16;
    label nOnEdge = 40;

} tunedCurves;


} // End anonymous namespace


bool isCorner
(
    const vector2D& before,
    const vector2D& x,
    const vector2D& after
)
{
    const vector2D a(x - before);
    const vector2D b(after - x);

    return std::atan2(mag(a.x()*b.y() - a.y()*b.x()), a & b)
        > tunedCurves.corner;
}


namespace
{

//- A smooth part of a curve between two corners
class smoothPart
{
    //- Points on the spline, close to each other, and the lengths up to them
    DynamicList<vector2D> samples_;
    DynamicList<scalar> lengths_;

    //- Length of edges at each sample
    scalarList sizes_;

    //  nBeside: points at both ends that only shape the spline
    void sample
    (
        const UList<vector2D>& points,
        const scalar maxEdge,
        const label nBeside
    )
    {
        const label n = points.size();
        typedef Eigen::Spline<double, 2> spline;
        Eigen::Matrix<double, 2, Eigen::Dynamic> x(2, n);
        forAll(points, i)
        {
            x(0, i) = points[i].x();
            x(1, i) = points[i].y();
        }
        spline::KnotVectorType chords;
        Eigen::ChordLengths(x, chords);
        const spline curve
        (
            Eigen::SplineFitting<spline>::Interpolate
            (
                x, min(3, n - 1), chords
            )
        );

        samples_.append(points[nBeside]);
        lengths_.append(0);
        for (label i = nBeside; i + 1 + nBeside < n; ++i)
        {
            const scalar chord = mag(points[i + 1] - points[i]);
            const label nSamples = max
            (
                tunedCurves.nBetween,
                label(std::ceil(tunedCurves.nOnEdge*chord/maxEdge))
            );
            for (label k = 1; k <= nSamples; ++k)
            {
                const scalar share = scalar(k)/nSamples;
                const Eigen::Vector2d y
                (
                    curve(chords(i) + share*(chords(i + 1) - chords(i)))
                );
                const vector2D next
                (
                    k == nSamples
                  ? points[i + 1] : vector2D(y(0), y(1))
                );
                lengths_.append(lengths_.last() + mag(next - samples_.last()));
                samples_.append(next);
            }
        }
    }

    //  goesOn: for both ends, whether the end is no corner
    void setSizes
    (
        const scalar maxEdge,
        const scalar maxTurn,
        const bool isLoop,
        const FixedList<bool, 2>& goesOn
    )
    {
        const label n = samples_.size();
        sizes_ = scalarList(n, maxEdge);
        for (label i = 1; i + 1 < n; ++i)
        {
            const vector2D a(samples_[i] - samples_[i - 1]);
            const vector2D b(samples_[i + 1] - samples_[i]);
            const scalar turn =
                std::atan2(mag(a.x()*b.y() - a.y()*b.x()), a & b);
            const scalar length = 0.5*(mag(a) + mag(b));
            sizes_[i] = min(maxEdge, maxTurn*length/max(turn, VSMALL));
        }
        if (isLoop)
        {
            sizes_[0] = sizes_[n - 1] = min(sizes_[1], sizes_[n - 2]);
        }
        else
        {
            const scalar atCorner = tunedCurves.cornerShare*maxEdge;
            sizes_[0] = goesOn[0] ? sizes_[1] : atCorner;
            sizes_[n - 1] = goesOn[1] ? sizes_[n - 2] : atCorner;
        }

        // Edges that grow by a factor have lengths that are linear along them
        const scalar slope = std::log(tunedCurves.growth);
        for (label pass = 0; pass < (isLoop ? 2 : 1); ++pass)
        {
            for (label i = 1; i < n; ++i)
            {
                sizes_[i] = min
                (
                    sizes_[i],
                    sizes_[i - 1] + slope*(lengths_[i] - lengths_[i - 1])
                );
            }
            for (label i = n - 2; i >= 0; --i)
            {
                sizes_[i] = min
                (
                    sizes_[i],
                    sizes_[i + 1] + slope*(lengths_[i + 1] - lengths_[i])
                );
            }
            if (isLoop)
            {
                sizes_[0] = sizes_[n - 1] = min(sizes_[0], sizes_[n - 1]);
            }
        }
    }

public:

    //- nBeside: points at both ends that only shape the spline, of a loop
    //  goesOn: for both ends of another part, whether the end is no corner
    smoothPart
    (
        const UList<vector2D>& points,
        const scalar maxEdge,
        const scalar maxTurn,
        const label nBeside,
        const FixedList<bool, 2>& goesOn
    )
    {
        sample(points, maxEdge, nBeside);
        setSizes(maxEdge, maxTurn, nBeside > 0, goesOn);
    }

    //- Appends the points, without the last one
    void append(DynamicList<vector2D>& points) const
    {
        // Edges up to each sample
        scalarList edges(samples_.size(), Zero);
        for (label i = 1; i < samples_.size(); ++i)
        {
            edges[i] = edges[i - 1]
              + (lengths_[i] - lengths_[i - 1])*0.5
               *(1/sizes_[i - 1] + 1/sizes_[i]);
        }
        const label n = max(label(std::ceil(edges.last())), label(1));
        label i = 1;
        points.append(samples_[0]);
        for (label k = 1; k < n; ++k)
        {
            const scalar at = edges.last()*k/n;
            while (edges[i] < at)
            {
                ++i;
            }
            const scalar share = (at - edges[i - 1])/(edges[i] - edges[i - 1]);
            points.append
            (
                samples_[i - 1] + share*(samples_[i] - samples_[i - 1])
            );
        }
    }
};

} // End anonymous namespace


//- A closed curve without corners
static DynamicList<vector2D> resampledLoop
(
    const UList<vector2D>& points,
    const scalar maxEdge,
    const scalar maxTurn
)
{
    const label n = points.size();
    const label nBeside = min(n - 1, label(3));
    DynamicList<vector2D> loop(n + 1 + 2*nBeside);
    for (label i = n - nBeside; i <= 2*n + nBeside; ++i)
    {
        loop.append(points[i % n]);
    }
    DynamicList<vector2D> made;
    const FixedList<bool, 2> goesOn(true);
    smoothPart(loop, maxEdge, maxTurn, nBeside, goesOn).append(made);

    return made;
}


//- The parts between corners of an open curve
static DynamicList<vector2D> resampledBetween
(
    const UList<vector2D>& points,
    const scalar maxEdge,
    const scalar maxTurn,
    const FixedList<bool, 2>& goesOn
)
{
    DynamicList<vector2D> made;
    label begin = 0;
    for (label i = 1; i < points.size(); ++i)
    {
        const bool isLast = i + 1 == points.size();
        if (isLast || isCorner(points[i - 1], points[i], points[i + 1]))
        {
            FixedList<bool, 2> partGoesOn;
            partGoesOn[0] = begin == 0 && goesOn[0];
            partGoesOn[1] = isLast && goesOn[1];
            smoothPart
            (
                SubList<vector2D>(points, i + 1 - begin, begin),
                maxEdge, maxTurn, 0, partGoesOn
            ).append(made);
            begin = i;
        }
    }
    made.append(points.last());

    return made;
}


planeCurve resampled
(
    const planeCurve& curve,
    const scalar maxEdge,
    const scalar maxTurn
)
{
    const label n = curve.points.size();
    const auto turnsAt = [&](const label i)
    {
        return isCorner
        (
            curve.points[(i + n - 1) % n], curve.points[i],
            curve.points[(i + 1) % n]
        );
    };
    label first = 0;
    while (curve.isClosed && first < n && !turnsAt(first))
    {
        ++first;
    }
    planeCurve result;
    result.isClosed = curve.isClosed;
    if (curve.isClosed && first == n)
    {
        result.points = resampledLoop(curve.points, maxEdge, maxTurn);

        return result;
    }

    // From the first corner on, to the first corner
    List<vector2D> points(curve.points);
    if (curve.isClosed)
    {
        std::rotate(points.begin(), points.begin() + first, points.end());
        points.append(vector2D(points[0]));
    }

    result.points = resampledBetween(points, maxEdge, maxTurn, curve.goesOn);
    result.points.setSize(result.points.size() - curve.isClosed);

    return result;
}

} // End namespace Foam

// ************************************************************************* //
