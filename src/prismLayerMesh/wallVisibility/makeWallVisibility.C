/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallVisibility.H"
#include "DynamicField.H"
#include "mathematicalConstants.H"
#include "sideCurve.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Add the reflections in the side patches of a point, in order of rotation: in
//  the one on which the last edge is, then of all in the one of the first
static void addReflections
(
    const wallSurface& wall,
    const labelUList& sides,
    const label p,
    DynamicField<vector>& normals,
    DynamicField<scalar>& angles,
    DynamicField<vector>& others
)
{
    for (label k = sides.size() - 1; k >= 0; --k)
    {
        const sidePlane side
        (
            wall.border.sides[sides[k]].planeAt(wall.points[p])
        );

        for (label i = normals.size() - 1; i >= 0; --i)
        {
            normals.append(side.reflected(normals[i]));
            angles.append(scalar(angles[i]));
        }
        for (label i = others.size() - 1; i >= 0; --i)
        {
            others.append(side.reflected(others[i]));
        }
    }
}


//- Along the line or curve of two side patches; zero if they are in one plane
static vector commonLine
(
    const sidePatch& first,
    const sidePatch& second,
    const point& x,
    const UList<vector>& normals
)
{
    if (first.isCurved() || second.isCurved())
    {
        return sideCurve(first, second, x).tangent();
    }

    const vector line = first.normal ^ second.normal;

    return (line & sum(normals)) < 0 ? -line : line;
}


//- Set the line of a point on two side patches that are not in one plane
static void setSideLine
(
    const wallSurface& wall,
    const labelUList& sides,
    const label p,
    const UList<vector>& normals,
    wallVisibility& visibility
)
{
    if (sides.size() < 2)
    {
        return;
    }

    const List<sidePatch>& all = wall.border.sides;
    const vector line
    (
        commonLine(all[sides[0]], all[sides[1]], wall.points[p], normals)
    );

    if (magSqr(line) > visibilityControls::rounding)
    {
        visibility.sideLines.setSize(wall.points.size(), vector::zero);
        visibility.sideLines[p] = normalised(line);
    }
}


//- Set the normals and the cone of point p
static void setPoint
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const vectorField& faceNormals,
    const label p,
    wallVisibility& visibility
)
{
    DynamicField<vector> normals;
    DynamicField<scalar> angles;
    DynamicField<vector> others;

    for (const label facei : addressing.pointFaces[p])
    {
        // Faces between columns have no area
        if (wall.patchIDs[facei] < 0)
        {
            continue;
        }

        const face& f = wall.faces[facei];
        const label corner = f.find(p);
        const vector next = wall.points[f.nextLabel(corner)] - wall.points[p];
        const vector prev = wall.points[f.prevLabel(corner)] - wall.points[p];
        const vector n = next ^ prev;
        const scalar angle = ::atan2(mag(n), next & prev);

        // At a reflex corner of a polygon the edges span the outside
        const vector& faceNormal = faceNormals[facei];
        const bool reflex = (n & faceNormal) < 0;

        normals.append(normalised((n & faceNormal) > 0 ? n : faceNormal));
        angles.append(reflex ? constant::mathematical::twoPi - angle : angle);
        others.append(polygonNormals(wall, facei, p));
    }

    const labelList sides(addressing.sidesOf(p));
    addReflections(wall, sides, p, normals, angles, others);
    setSideLine(wall, sides, p, normals, visibility);
    visibility.polygonNormals[p] = others;
    visibility.cornerNormals[p] = normals;
    visibility.meanNormals[p] = sum(angles*normals)/max(sum(angles), VSMALL);
    visibility.setCone(p);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

vectorField polygonNormals
(
    const wallSurface& wall,
    const label facei,
    const label p
)
{
    const face& f = wall.faces[facei];
    const point& a = wall.points[f[0]];
    DynamicField<vector> normals;

    if (f.size() == 3)
    {
        return vectorField(std::move(normals));
    }

    normals.append(f.unitNormal(wall.points));

    for (label k = 2; k < f.size(); ++k)
    {
        if (p != f[0] && p != f[k - 1] && p != f[k])
        {
            continue;
        }

        // Three points in a line have none
        const vector n = normalised
        (
            (wall.points[f[k - 1]] - a) ^ (wall.points[f[k]] - a)
        );
        if (mag(n) > 0)
        {
            normals.append(n);
        }
    }

    return vectorField(std::move(normals));
}


wallVisibility makeWallVisibility
(
    const wallSurface& wall,
    const wallAddressing& addressing
)
{
    const label nPoints = wall.points.size();
    const vectorField faceNormals(wall.faceNormals());

    wallVisibility visibility;
    visibility.cornerNormals.setSize(nPoints);
    visibility.meanNormals.setSize(nPoints);
    visibility.polygonNormals.setSize(nPoints);
    visibility.cones.setSize(nPoints);

    // The first point on two side patches makes the lines of all
    const bool isClosed = addressing.pointSides.empty();

    #pragma omp parallel for schedule(static, 256) if (isClosed)
    for (label p = 0; p < nPoints; ++p)
    {
        if (addressing.pointFaces[p].size())
        {
            setPoint(wall, addressing, faceNormals, p, visibility);
        }
    }

    return visibility;
}


labelList pointsWithEmptyCones(const wallSurface& wall)
{
    return makeWallVisibility(wall, makeWallAddressing(wall)).emptyCones();
}

} // End namespace Foam

// ************************************************************************* //
