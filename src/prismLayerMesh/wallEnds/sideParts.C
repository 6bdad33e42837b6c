/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideParts.H"
#include "disjointSets.H"
#include "ranges.H"
#include "sideShape.H"
#include "surfacePart.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Function>
void sideFaces::forAllPairs(const Function& call) const
{
    for (label e = 0; e < edges_.nEdges(); ++e)
    {
        const SubList<wallSide> both(edges_.on(e));

        if (both.size() == 2)
        {
            call(both[0].facei, both[1].facei);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

sideFaces::sideFaces
(
    const wallSurface& surface,
    const labelList& sectors,
    const layerControls& layers
)
:
    surface_(surface),
    sectors_(sectors),
    edges_(makeWallSides(surface)),
    normals_(surface.faceNormals()),
    isSide_(surface.faces.size()),
    atWall_(surface.faces.size())
{
    boolList isSidePatch(surface_.patchNames.size(), false);
    forAll(isSidePatch, patchi)
    {
        isSidePatch[patchi] = layers.isSide(surface_.patchNames[patchi]);
    }

    forAll(surface_.patchIDs, facei)
    {
        isSide_.set(facei, isSidePatch[surface_.patchIDs[facei]]);
    }

    forAllPairs([&](const label f, const label g)
    {
        atWall_.set(f, atWall_.test(f) || !isSide_.test(g));
        atWall_.set(g, atWall_.test(g) || !isSide_.test(f));
    });
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

List<DynamicList<label>> sideFaces::joined
(
    const scalar cosine,
    const labelUList& partOfFace
) const
{
    disjointSets sets(surface_.faces.size());
    forAllPairs([&](const label f, const label g)
    {
        if
        (
            isSide_.test(f) && isSide_.test(g)
         && sectors_[f] == sectors_[g]
         && surface_.patchIDs[f] == surface_.patchIDs[g]
         && (normals_[f] & normals_[g]) > cosine
        )
        {
            sets.join(f, g);
        }
    });

    Map<label> listOf;
    DynamicList<DynamicList<label>> lists;
    for (const label f : isSide_)
    {
        if (partOfFace[f] < 0)
        {
            if (listOf.insert(sets.find(f), lists.size()))
            {
                lists.append(DynamicList<label>());
            }
            lists[listOf[sets.find(f)]].append(f);
        }
    }

    return List<DynamicList<label>>(std::move(lists));
}


bool sideFaces::touchWall(const labelUList& faces) const
{
    return anyOf(faces, [&](const label f) { return atWall_.test(f); });
}


bitSet sideFaces::joinedToWall() const
{
    labelList components;
    bitSet hasWall(findComponents(edges_, isSide_.size(), components));
    forAll(components, facei)
    {
        if (!isSide_.test(facei))
        {
            hasWall.set(components[facei]);
        }
    }

    bitSet joined(components.size());
    forAll(components, facei)
    {
        joined.set(facei, hasWall.test(components[facei]));
    }

    return joined;
}


// * * * * * * * * * * * * * * *  Side Parts * * * * * * * * * * * * * * * * //

//- Faces with a larger angle than that between them are not of one plane
//  part: cos(5 degrees)
static constexpr scalar samePlaneCosine = 0.996;

//- The largest angle of a face of a curved part with the mean plane: cos(75
//  degrees)
static constexpr scalar leastSeen = 0.2588;

//- Bound on the rounds in which curved parts are divided in two
static constexpr label maxDivisions = 6;


namespace
{

class partFinder
{
    const wallSurface& surface_;
    const layerControls& layers_;
    const scalar tolerance_;
    const sideFaces faces_;

    sideParts parts_;


    //- A plane through faces
    sidePatch planeThrough(const labelUList& faces) const
    {
        vector normal(Zero);
        point centre(Zero);
        scalar area = 0;

        for (const label f : faces)
        {
            const scalar a = surface_.faces[f].mag(surface_.points);
            normal += surface_.faces[f].areaNormal(surface_.points);
            centre += a*surface_.faces[f].centre(surface_.points);
            area += a;
        }

        sidePatch side;
        side.normal = -normalised(normal);
        side.origin = centre/max(area, VSMALL);

        return side;
    }


    //- Whether the points of faces are in a plane
    bool isPlane(const labelUList& faces) const
    {
        const sidePatch side(planeThrough(faces));

        // Faces around a hole have no normal together
        return mag(side.normal) > 0.5 && allOf(faces, [&](const label f)
        {
            const face& points = surface_.faces[f];

            return allOf(points, [&](const label p)
            {
                return mag(side.distance(surface_.points[p])) <= tolerance_;
            });
        });
    }


    sidePatch curvedThrough(const labelUList& faces) const
    {
        sidePatch side(planeThrough(faces));
        const wallSurface own(makeSurfacePart(surface_, faces).surface);
        side.shape = std::make_shared<const sideShape>(own.points, own.faces);

        return side;
    }


    void addPart(const labelUList& faces, const sidePatch& plane)
    {
        sidePatch side(plane);
        side.name = surface_.patchNames[surface_.patchIDs[faces[0]]];
        const word& type = layers_.entryOf(side.name)->type;
        side.type = type.empty() ? "patch" : type;

        for (const label f : faces)
        {
            parts_.sideOfFace[f] = parts_.sides.size();
        }
        parts_.sides.append(side);
    }

public:

    partFinder
    (
        const wallSurface& surface,
        const labelList& sectors,
        const layerControls& layers,
        const scalar tolerance
    )
    :
        surface_(surface),
        layers_(layers),
        tolerance_(tolerance),
        faces_(surface, sectors, layers),
        parts_{List<sidePatch>(), labelList(surface.faces.size(), -1)}
    {}

    sideParts find()
    {
        // All of a part that is joined at any angle, where it is plane
        for (const labelList& part : faces_.joined(-2, parts_.sideOfFace))
        {
            if (isPlane(part))
            {
                addPart(part, planeThrough(part));
            }
        }

        const List<DynamicList<label>> smooth
        (
            faces_.joined(samePlaneCosine, parts_.sideOfFace)
        );
        const List<DynamicList<label>> curved
        (
            faces_.joined(curvedCosine, parts_.sideOfFace)
        );
        labelList curvedOf(surface_.faces.size(), -1);
        forAll(curved, i)
        {
            UIndirectList<label>(curvedOf, curved[i]) = i;
        }

        boolList isCurved(curved.size(), false);
        for (const labelList& part : smooth)
        {
            if (!isPlane(part) || !faces_.touchWall(part))
            {
                isCurved[curvedOf[part[0]]] =
                    !isPlane(curved[curvedOf[part[0]]]);
            }
        }

        for (const labelList& part : smooth)
        {
            if (!isCurved[curvedOf[part[0]]])
            {
                addPart(part, planeThrough(part));
            }
        }
        forAll(curved, i)
        {
            if (isCurved[i])
            {
                addPart(curved[i], curvedThrough(curved[i]));
            }
        }

        return parts_;
    }

    //- Returns for each curved part that is not wholly seen along its mean
    //  normal a face that is not seen
    Map<label> unseen() const
    {
        Map<label> faces;

        forAll(parts_.sideOfFace, facei)
        {
            const label s = parts_.sideOfFace[facei];

            if
            (
                s >= 0 && parts_.sides[s].isCurved()
             && (-parts_.sides[s].normal & faces_.normal(facei)) < leastSeen
            )
            {
                faces.insert(s, facei);
            }
        }

        return faces;
    }

    //- Errors: FatalError if a part is not joined to the wall
    void checkJoined() const
    {
        const bitSet joined(faces_.joinedToWall());

        forAll(parts_.sideOfFace, facei)
        {
            const label s = parts_.sideOfFace[facei];

            if (s >= 0 && !joined.test(facei))
            {
                FatalErrorInFunction
                    << "The wall does not end on the side patch "
                    << parts_.sides[s].name << " at " << parts_.sides[s].origin
                    << nl << "No face beside this part of the patch has layers."
                    << " Stitch the part to the wall (surface { repair stitch;"
                    << " }), give the patch layers (remove nSurfaceLayers 0"
                    << " from layers.patches), or remove the part from the"
                    << " surface"
                    << exit(FatalError);
            }
        }
    }
};

} // End anonymous namespace


static void refuseCurved(const wallSurface& surface, const label facei)
{
    FatalErrorInFunction
        << "The side patch " << surface.patchNames[surface.patchIDs[facei]]
        << " curves too far: the face at "
        << surface.faces[facei].centre(surface.points)
        << " is not visible along the mean normal of the patch" << nl
        << "Divide it into several patches" << exit(FatalError);
}


sideParts findSideParts
(
    wallSurface& surface,
    const layerControls& layers,
    const scalar tolerance
)
{
    labelList sectors(surface.faces.size(), Zero);

    for (label round = 0; ; ++round)
    {
        partFinder finder(surface, sectors, layers, tolerance);
        sideParts found(finder.find());
        const Map<label> unseen(finder.unseen());

        if (unseen.empty())
        {
            finder.checkJoined();

            return found;
        }

        if (round == maxDivisions)
        {
            refuseCurved(surface, *unseen.cbegin());
        }

        sectoredSurface sectored{surface, found.sideOfFace, sectors};
        for (const label part : unseen.sortedToc())
        {
            divideSidePart(sectored, part, tolerance);
        }
        sectors = sectored.sectors;
    }
}

} // End namespace Foam

// ************************************************************************* //
