/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerBorder.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The curve from a point on two side patches; null if both are plane
static std::shared_ptr<const sideCurve> curveOf
(
    const prismLayers& layers,
    const labelPair& sides,
    const point& root
)
{
    const sidePatch& first = layers.border.sides[sides.first()];
    const sidePatch& second = layers.border.sides[sides.second()];

    return first.isCurved() || second.isCurved()
      ? std::make_shared<const sideCurve>(first, second, root)
      : nullptr;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

scalar layerBorder::shareAt(const corner& c, const point& x) const
{
    const point& end = outerPoints_[c.outerPoint];

    if (c.curve)
    {
        return mag(x - c.curve->nearest(x)) < tolerance_
          ? c.curve->lengthTo(x)/c.curve->lengthTo(end) : -1;
    }

    const vector up(end - c.root);
    const scalar share = ((x - c.root) & up)/magSqr(up);
    const bool onLine = mag(x - c.root - share*up) < tolerance_;

    return onLine && share*mag(up) > -tolerance_
      ? max(share, scalar(0)) : -1;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

layerBorder::layerBorder(const prismLayers& layers, const scalar tolerance)
:
    tolerance_(tolerance)
{
    const Map<labelPair> sidesOf(layers.border.pointSides());
    columns_ = sidesOf.sortedToc();
    outerPoints_.setSize(columns_.size());
    Map<label> outerPointOf;

    forAll(columns_, i)
    {
        const label c = columns_[i];
        const labelPair& sides = sidesOf[c];
        const label rootColumn = layers.root(c);
        const point& root = layers(rootColumn, 0);
        outerPoints_[i] = layers(c, layers.nLayers);
        outerPointOf.insert(c, i);
        roots_.insert(root, rootColumn);

        if (sides.first() != sides.second())
        {
            corners_.append({sides, root, i, curveOf(layers, sides, root)});
        }
    }

    outerEdges_.setSize(layers.border.edges.size());
    forAll(outerEdges_, i)
    {
        const edge& e = layers.border.edges[i];
        wallEdges_.insert
        (
            edge(layers.root(e.start()), layers.root(e.end())), i
        );
        outerEdges_[i] = edge(outerPointOf[e.end()], outerPointOf[e.start()]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool layerBorder::covers
(
    const point& a,
    const point& b,
    labelPair& ends
) const
{
    ends = labelPair(-1, -1);
    const edge columns(roots_.find(a), roots_.find(b));

    if
    (
        columns.start() >= 0 && columns.end() >= 0
     && wallEdges_.found(columns)
    )
    {
        return true;
    }

    for (const corner& c : corners_)
    {
        const scalar shareA = shareAt(c, a);
        const scalar shareB = shareAt(c, b);

        if (shareA >= 0 && shareB >= 0)
        {
            if (shareA < 1 && shareB < 1)
            {
                return true;
            }

            ends.first() = shareA < 1 ? c.outerPoint : ends.first();
            ends.second() = shareB < 1 ? c.outerPoint : ends.second();
        }
    }

    return false;
}


labelList layerBorder::outerPointsOn(const label side) const
{
    DynamicList<label> outerPoints;

    for (const corner& c : corners_)
    {
        if (c.sides.found(side))
        {
            outerPoints.append(c.outerPoint);
        }
    }

    return labelList(std::move(outerPoints));
}

} // End namespace Foam

// ************************************************************************* //
