/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "curveEnds.H"
#include "boundBox.H"
#include "sidePair.H"

namespace Foam
{

//- An end is on a side that is nearer than this share of the size of the curves
static constexpr scalar onSide = 1e-4;


namespace
{

//- The last point of an open curve, and the point before it
struct curveEnd
{
    planeCurve* curve;
    label end;
    point x;
    point before;
};


class curveEnds
{
    const planarControls& controls_;
    const List<sidePair> pairs_;
    DynamicList<curveEnd> ends_;
    scalar tolerance_;

    point inSpace(const vector2D& x) const
    {
        point p(Zero);
        p[controls_.directions().first()] = x.x();
        p[controls_.directions().second()] = x.y();

        return p;
    }

    vector2D inPlane(const point& x) const
    {
        const labelPair in(controls_.directions());

        return vector2D(x[in.first()], x[in.second()]);
    }

    //- The point of the end at a place that is before that end; x itself if no
    //  end is there
    point pointBefore(const point& x) const
    {
        for (const curveEnd& end : ends_)
        {
            if (mag(end.x - x) < tolerance_)
            {
                return end.before;
            }
        }

        return x;
    }

    //- The point that follows an end beyond a side
    point pointBeyond(const label s, const curveEnd& end) const
    {
        for (const sidePair& pair : pairs_)
        {
            if (s == pair.first || s == pair.second)
            {
                const rigidMotion back(pair.toSecond.inverse());
                const bool isFirst = s == pair.first;
                const point other((isFirst ? pair.toSecond : back)(end.x));

                return (isFirst ? back : pair.toSecond)(pointBefore(other));
            }
        }

        return controls_.sides[s].reflectedPoint(end.before);
    }

    bool goesOn(const curveEnd& end) const
    {
        bool isOn = false;
        forAll(controls_.sides, s)
        {
            const sidePatch& side = controls_.sides[s];
            if
            (
                mag(side.normal & controls_.normal) > 0.5
             || mag(side.distance(end.x)) > tolerance_
            )
            {
                continue;
            }
            const vector2D next(inPlane(pointBeyond(s, end)));
            if (isCorner(inPlane(end.before), inPlane(end.x), next))
            {
                return false;
            }
            isOn = true;
        }

        return isOn;
    }

public:

    curveEnds(List<planeCurve>& curves, const planarControls& controls)
    :
        controls_(controls),
        pairs_(pairsOf(controls.sides))
    {
        boundBox box(boundBox::invertedBox);
        for (planeCurve& curve : curves)
        {
            const List<vector2D>& x = curve.points;
            const label n = x.size();
            for (const vector2D& at : x)
            {
                box.add(inSpace(at));
            }
            if (!curve.isClosed)
            {
                ends_.append({&curve, 0, inSpace(x[0]), inSpace(x[1])});
                ends_.append
                (
                    {&curve, 1, inSpace(x[n - 1]), inSpace(x[n - 2])}
                );
            }
        }
        tolerance_ = onSide*box.mag();
    }

    void set()
    {
        for (curveEnd& end : ends_)
        {
            end.curve->goesOn[end.end] = goesOn(end);
        }
    }
};

} // End anonymous namespace


void setCurveEnds(List<planeCurve>& curves, const planarControls& controls)
{
    curveEnds(curves, controls).set();
}

} // End namespace Foam

// ************************************************************************* //
