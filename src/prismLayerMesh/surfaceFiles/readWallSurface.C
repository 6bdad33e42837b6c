/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readWallSurface.H"
#include "bitSet.H"
#include "boundBox.H"
#include "cadSurface.H"
#include "ListOps.H"
#include "planarWall.H"
#include "ranges.H"
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
    findNonManifoldPoints(wall, defects);

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


//- Whether an exporter has named a solid, for want of a name
static bool isUnnamed(const word& name)
{
    static const wordRe pattern
    (
        "(ascii|default|mesh|object|patch|region|solid|stl|surface|zone)?"
        "_?[0-9]*",
        wordRe::REGEX_ICASE
    );

    return pattern.match(name);
}


//- The names of a file's patches, as words. A solid without a name has the name
//  of the file, with its own behind it if the file has several solids. Solids
//  of one file alone keep such names if there are several.
static wordList patchNamesOf
(
    const wallSurface& wall,
    const fileName& file,
    const bool isAlone
)
{
    const fileName plain(file.ext() == "gz" ? file.lessExt() : file);
    const word stem(word::validate(plain.nameLessExt(), true));
    const word ofFile(stem.empty() ? word("wall") : stem);
    wordList names(wall.patchNames);
    for (word& name : names)
    {
        name = word::validate(name, true);
        if (isUnnamed(name) && (names.size() == 1 || !isAlone))
        {
            name = names.size() == 1 ? ofFile : word(ofFile + '_' + name);
        }
    }

    return names;
}


//- Gives the patches of a file the names of entries that match them.
//  isUsed: is set for the entries that match
static void renamePatches
(
    const List<surfacePatchName>& entries,
    const fileName& file,
    const wordList& solids,
    wordList& names,
    boolList& isUsed
)
{
    const wordList given(names);
    forAll(names, patchi)
    {
        forAll(entries, i)
        {
            const surfacePatchName& entry = entries[i];
            if
            (
                entry.file.match(file.name())
             && (entry.solid.match(solids[patchi])
              || entry.solid.match(given[patchi]))
            )
            {
                names[patchi] = entry.name;
                isUsed[i] = true;
            }
        }
    }
}


//- Errors: FatalError with an entry that matches no solid, and all solids
static void requireUsed
(
    const List<surfacePatchName>& entries,
    const boolList& isUsed,
    const UList<string>& solids
)
{
    const label i = isUsed.find(false);
    if (i >= 0)
    {
        FatalErrorInFunction
            << "The entry " << entries[i].name << " of surface.patches matches"
            << " no solid of a file" << nl
            << "Solids: " << listed(solids).c_str() << exit(FatalError);
    }
}


static wallSurface readCurves
(
    const fileName& file,
    const wallSurfaceControls& controls
)
{
    if (!controls.planar.isWanted())
    {
        FatalErrorInFunction
            << "The file " << file << " has a curve: a mesh of two"
            << " dimensions needs the entry twoDimensional"
            << exit(FatalError);
    }
    List<planeCurve> curves(readCurveFile(file));
    for (planeCurve& curve : curves)
    {
        for (vector2D& x : curve.points)
        {
            x *= controls.scale;
        }
    }

    return stripOn(curves, controls.planar);
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

    if (isCurveFile(file))
    {
        return readCurves(file, controls);
    }

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
    if (!controls.planar.isWanted())
    {
        return part;
    }

    // Sections are followed from face to face. Curves of several patches have
    // ends of their own.
    if (separateFaces)
    {
        wallReading untold;
        mergeNearPoints(part, controls.mergeTolerance, untold);
    }
    separateFaces = true;

    return stripOn(part, controls.planar);
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

    boolList isUsed(controls.patches.size(), false);
    DynamicList<string> solids;

    for (const fileName& file : files)
    {
        bool separate = false;
        wallSurface part(readPart(file, controls, separate, reading));
        separateFaces = separateFaces || separate;
        const wordList given(part.patchNames);
        part.patchNames = patchNamesOf(part, file, files.size() == 1);
        renamePatches
        (
            controls.patches, file, given, part.patchNames, isUsed
        );
        for (const word& name : given)
        {
            solids.append(string(file.name() + ": " + name));
        }

        if (files.size() == 1)
        {
            wall = std::move(part);
        }
        else
        {
            appendSurface(part, labelList(), wall);
        }
    }

    requireUsed(controls.patches, isUsed, solids);
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
