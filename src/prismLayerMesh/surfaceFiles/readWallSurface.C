/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readWallSurface.H"
#include "bitSet.H"
#include "boundBox.H"
#include "cadSurface.H"
#include "ListOps.H"
#include "surfaceFile.H"
#include "surfacePart.H"
#include "wallChanges.H"
#include "wallDefects.H"
#include "wallPredicates.H"
#include "wallSides.H"

namespace Foam
{

//- For each point its representative: a point within the tolerance, or the
//  point itself. The representative of points at one place is the first.
//  some: the other points are their own representatives
static labelList findRepresentatives
(
    const pointField& points,
    const labelUList& some,
    const scalar tolerance
)
{
    // In the order of their places along a direction that no plane of a
    // surface is likely to be normal to, near points are near
    const vector direction(0.48712, 0.60539, 0.62962);
    const scalarField place(points & direction);
    const scalar reach = 1.01*mag(direction)*tolerance;

    labelList order(sortedOrder(scalarField(place, some)));
    inplaceRenumber(some, order);
    labelList representatives(identity(points.size()));
    UIndirectList<label>(representatives, some) = -1;
    forAll(order, i)
    {
        const label p = order[i];

        if (representatives[p] >= 0)
        {
            continue;
        }

        representatives[p] = p;

        for
        (
            label j = i + 1;
            j < order.size() && place[order[j]] - place[p] <= reach;
            ++j
        )
        {
            const label q = order[j];

            if
            (
                representatives[q] < 0
             && magSqr(points[q] - points[p]) <= sqr(tolerance)
            )
            {
                representatives[q] = p;
            }
        }
    }

    return representatives;
}


//- Remove faces with neighbouring corners that have become one point. Returns
//  the number of faces removed.
static label removeCollapsedFaces(wallSurface& wall)
{
    bitSet kept(wall.faces.size());
    forAll(wall.faces, i)
    {
        kept.set(i, !hasRepeatedPoint(wall.faces[i]));
    }

    inplaceSubset(kept, wall.faces);
    inplaceSubset(kept, wall.patchIDs);

    return kept.size() - wall.faces.size();
}


//- Number of points that have another one as representative
static label nRepresented(const labelUList& representatives)
{
    label n = 0;
    forAll(representatives, p)
    {
        n += representatives[p] != p;
    }

    return n;
}


//- The points on edges with one face, ascending
static labelList openPoints(const wallSurface& wall)
{
    bitSet open(wall.points.size());
    for (const edge& e : outline(wall.faces))
    {
        open.set(e.start());
        open.set(e.end());
    }

    return open.sortedToc();
}


void mergeNearPoints
(
    wallSurface& wall,
    const scalar tolerance,
    wallReading& reading,
    const bool onlyOpen
)
{
    const scalar diagonal = boundBox(wall.points, false).mag();
    const labelList some
    (
        onlyOpen ? openPoints(wall) : identity(wall.points.size())
    );
    const auto within = [&](const scalar share)
    {
        return findRepresentatives(wall.points, some, share*diagonal);
    };
    const labelList representatives(within(tolerance));
    const label nNear = nRepresented(within(wallReading::nearTolerance));

    reading.mergedPoints = nRepresented(representatives);
    reading.nearPoints = max(nNear - reading.mergedPoints, label(0));

    for (face& f : wall.faces)
    {
        inplaceRenumber(representatives, f);
    }

    reading.collapsedFaces = removeCollapsedFaces(wall);
}


// * * * * * * * * * * * * *  Orient Wall Surface  * * * * * * * * * * * * * //

//- A closed oriented manifold, by its labels alone
static bool isOrientable(const wallSurface& wall, const wallSides& sides)
{
    for (const face& f : wall.faces)
    {
        if (f.size() < 3 || hasRepeatedPoint(f))
        {
            return false;
        }
    }

    defectList defects(wall);
    const bool oriented = findBadEdges(sides, defects);
    findNonManifoldPoints(wall, sides, defects);

    return oriented && defects.empty();
}


//- Turns the faces that are not oriented as most of their component: the faces
//  of one file need not be oriented as the faces of another file
static void orientAlike(wallSurface& wall)
{
    const wallSides sides(makeWallSides(wall));

    for (const label facei : findTurnedFaces(sides, wall.faces.size()))
    {
        wall.faces[facei].flip();
    }
}


label orientWallSurface(wallSurface& wall, const bool fluidOutside)
{
    const wallSides sides(makeWallSides(wall));

    if (wall.faces.empty() || !isOrientable(wall, sides))
    {
        return 0;
    }

    labelList componentOfFace;
    const label n = findComponents(sides, wall.faces.size(), componentOfFace);
    const bitSet inward(findInwardComponents(wall, componentOfFace, n));
    label nFlipped = 0;

    forAll(wall.faces, facei)
    {
        if (inward.test(componentOfFace[facei]) == fluidOutside)
        {
            wall.faces[facei].flip();
            ++nFlipped;
        }
    }

    return nFlipped;
}


// * * * * * * * * * * * * * *  Read Wall Surface  * * * * * * * * * * * * * //

static void checkFinite(const fileName& file, const pointField& points)
{
    forAll(points, i)
    {
        for (direction d = 0; d < 3; ++d)
        {
            // Larger ones overflow in areas and volumes; isless because < on
            // NaN ends the process where floating-point exceptions do
            if (!std::isless(mag(points[i][d]), 1e90))
            {
                FatalErrorInFunction
                    << "Cannot use the surface " << file << ": point " << i
                    << " at " << points[i] << " is not finite"
                    << exit(FatalError);
            }
        }
    }
}


//- Give patches valid names. If there is but one and the file has not named it,
//  it is named after the file.
static void namePatches(wallSurface& wall, const fileName& file)
{
    for (word& name : wall.patchNames)
    {
        name = word::validate(name, true);
    }

    const wordList unnamed({"", "zone0", "solid", "solid0", "patch0"});

    if (wall.patchNames.size() == 1 && unnamed.found(wall.patchNames[0]))
    {
        const fileName plain(file.ext() == "gz" ? file.lessExt() : file);
        const word stem(word::validate(plain.nameLessExt(), true));
        wall.patchNames[0] = (stem.empty() ? word("wall") : stem);
    }
}


//- A file as it is, scaled
static wallSurface readPart
(
    const fileName& file,
    const wallSurfaceControls& controls,
    bool& separateFaces,
    wallReading& reading
)
{
    wallSurface part;

    if (cadType(file).size())
    {
        string remark;
        typedef surfaceRepairControls::method method;
        const bool unite =
            controls.fluidOutside && controls.repair.repair == method::stitch;
        const scalar scale = controls.scale;
        part = readCadSurface(file, controls.cad, unite, scale, remark);
        reading.cadFiles.append(file.name() + ": " + remark);
    }
    else
    {
        part = readSurfaceFile(file, separateFaces);
    }
    part.points *= controls.scale;
    checkFinite(file, part.points);
    mergePatches(part);
    namePatches(part, file);

    return part;
}


wallSurface readWallSurface
(
    const UList<fileName>& files,
    const wallSurfaceControls& controls,
    wallReading& reading
)
{
    reading = wallReading();
    bool separateFaces = files.size() > 1;
    wallSurface wall;

    for (const fileName& file : files)
    {
        bool separate = false;
        wallSurface part(readPart(file, controls, separate, reading));
        separateFaces = separateFaces || separate;

        if (files.size() == 1)
        {
            wall = std::move(part);
        }
        else
        {
            appendSurface(part, labelList(), wall);
        }
    }

    mergeNearPoints(wall, controls.mergeTolerance, reading, !separateFaces);
    removeUnusedPoints(wall.faces, wall.points);
    mergePatches(wall);
    reading.cutFaces = cutReflexFaces(wall);
    if (files.size() > 1 || reading.cadFiles.size())
    {
        orientAlike(wall);
    }
    reading.flippedFaces = orientWallSurface(wall, controls.fluidOutside);

    return wall;
}

} // End namespace Foam

// ************************************************************************* //
