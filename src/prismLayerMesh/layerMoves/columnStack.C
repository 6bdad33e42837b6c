/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnStack.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void setHeights(columnStack& s)
{
    s.thickness = 0;

    forAll(s.volumes3, i)
    {
        const scalar height =
            layerHeight(s.levels[i], s.levels[i + 1], s.volumes3[i]);
        s.thickness += height;
        s.firstHeight = i == 0 ? height : s.firstHeight;
    }
}


void setGradients
(
    const prismLayers& layers,
    const UList<columnSide>& sides,
    const label column,
    columnStack& s
)
{
    const label k = s.columns.find(column);
    const label before = s.columns.rcIndex(k);
    s.gradients.setSize(layers.nLayers);
    s.gradients = Zero;

    // Three times the volume changes by three times the area of each face times
    // the mean displacement of its points
    const scalar share = 3.0/s.columns.size();
    vector areaBelow(Zero);

    forAll(s.volumes3, i)
    {
        const faceGeometry& lower = s.levels[i];
        const faceGeometry& upper = s.levels[i + 1];
        const vector across
        (
            layers(s.columns[before], i + 1)
          - layers(s.columns[s.columns.fcIndex(k)], i + 1)
        );
        const vector along(normalised(upper.area));
        const vector area(0.5*(along ^ across));
        vector ofSides(Zero);
        for (const label j : {before, k})
        {
            ofSides += (s.outwards[j] ? 0.75 : -0.75)
               *sides[s.sides[j]].faces[i].area;
        }

        const scalar height = layerHeight(lower, upper, s.volumes3[i]);
        const scalar areas = max(mag(lower.area) + mag(upper.area), VSMALL);
        s.gradients[i] +=
            (2.0/3.0*(ofSides + share*upper.area) - height*area)/areas;

        if (i == 0)
        {
            s.firstGradient = s.gradients[0];
        }
        else
        {
            s.gradients[i - 1] +=
                (2.0/3.0*(ofSides - share*lower.area) - height*areaBelow)/areas;
        }
        areaBelow = area;
    }
}


scalar gainOf
(
    const UList<columnStack>& stacks,
    const UList<columnSide>& sides,
    const labelPair& cell
)
{
    const columnStack& s = stacks[cell.first()];
    const label i = cell.second();
    const point& own = s.centres[i - 1];
    DynamicList<schemeFace, 8> seen;
    const auto add = [&](const faceGeometry& f, scalar sign, const point* other)
    {
        seen.append(seenFace(sign*f.area, f.centre, own, other));
    };
    add(s.levels[i - 1], -1, i > 1 ? &s.centres[i - 2] : nullptr);
    add(s.levels[i], 1, i < s.centres.size() ? &s.centres[i] : nullptr);
    forAll(s.sides, k)
    {
        const columnSide& t = sides[s.sides[k]];
        const UList<point>& other =
            !s.outwards[k] ? stacks[t.first].centres
          : t.second < 0 ? t.fixedCentres : stacks[t.second].centres;
        add
        (
            t.faces[i - 1], s.outwards[k] ? 1 : -1,
            other.size() ? &other[i - 1] : nullptr
        );
    }

    return cellGain(seen, s.volumes3[i - 1]/3);
}

} // End namespace Foam

// ************************************************************************* //
