/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readWallSurface.H"
#include "cadSurface.H"
#include "cutReflexFaces.H"
#include "orientWallSurface.H"
#include "removeUnused.H"
#include "surfaceFile.H"
#include "wallSides.H"
#include "boundBox.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


//- For each point its representative: a point within the tolerance, or the
//  point itself. The representative of points at one place is the first.
static labelList findRepresentatives
(
    const pointField& points,
    const scalar tolerance
)
{
    // In the order of their places along a direction that no plane of a
    // surface is likely to be normal to, near points are near
    const vector direction(0.48712, 0.60539, 0.62962);
    const scalarField place(points & direction);
    const scalar reach = 1.01*mag(direction)*tolerance;

    const labelList order(sortedOrder(place));
    labelList representatives(points.size(), -1);

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


static void mergePoints
(
    wallSurface& wall,
    const scalar mergeTolerance,
    wallReading& reading
)
{
    const scalar diagonal = boundBox(wall.points, false).mag();
    const auto within = [&](const scalar tolerance)
    {
        return findRepresentatives(wall.points, tolerance*diagonal);
    };
    const labelList representatives(within(mergeTolerance));
    const label nNear = nRepresented(within(wallReading::nearTolerance));

    reading.mergedPoints = nRepresented(representatives);
    reading.nearPoints = max(nNear - reading.mergedPoints, label(0));

    for (face& f : wall.faces)
    {
        inplaceRenumber(representatives, f);
    }

    reading.collapsedFaces = removeCollapsedFaces(wall);
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


static void append(const wallSurface& part, wallSurface& wall)
{
    const label nPoints = wall.points.size();
    const label nPatches = wall.patchNames.size();
    const label nFaces = wall.faces.size();

    wall.points.append(part.points);
    wall.patchNames.append(part.patchNames);
    wall.faces.append(part.faces);
    wall.patchIDs.append(part.patchIDs);

    for (label facei = nFaces; facei < wall.faces.size(); ++facei)
    {
        for (label& p : wall.faces[facei])
        {
            p += nPoints;
        }
        wall.patchIDs[facei] += nPatches;
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
            append(part, wall);
        }
    }

    if (separateFaces)
    {
        mergePoints(wall, controls.mergeTolerance, reading);
    }

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
