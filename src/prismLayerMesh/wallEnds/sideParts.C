/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideParts.H"
#include "bitSet.H"
#include "disjointSets.H"
#include "divideSidePart.H"
#include "readWallSurface.H"
#include "sideShape.H"
#include "wallSides.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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

    //- Sector of each face. A part is in one sector.
    const labelList& sectors_;

    const wallSides edges_;
    const layerControls& layers_;
    const scalar tolerance_;
    const vectorField normals_;

    //- Faces of patches that are to have no layers, and of these the ones
    //  beside the wall
    bitSet sideFaces_;
    bitSet atWall_;

    sideParts parts_;


    void setSideFaces()
    {
        boolList isSide(surface_.patchNames.size(), false);
        forAll(isSide, patchi)
        {
            isSide[patchi] = layers_.isSide(surface_.patchNames[patchi]);
        }

        sideFaces_.setSize(surface_.faces.size());
        forAll(surface_.patchIDs, facei)
        {
            sideFaces_.set(facei, isSide[surface_.patchIDs[facei]]);
        }

        atWall_.setSize(surface_.faces.size());
        forAllPairs([&](const label f, const label g)
        {
            atWall_.set(f, atWall_.test(f) || !sideFaces_.test(g));
            atWall_.set(g, atWall_.test(g) || !sideFaces_.test(f));
        });
    }


    //- Calls a function with the two faces of each edge that has two
    template<class Function>
    void forAllPairs(const Function& call) const
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


    //- The faces of side patches that are in no part yet, in lists of those of
    //  a patch that are joined by edges, with at least a cosine of the angle
    //  between them. In the order of the first faces.
    List<DynamicList<label>> joined(const scalar cosine) const
    {
        disjointSets sets(surface_.faces.size());
        forAllPairs([&](const label f, const label g)
        {
            if
            (
                sideFaces_.test(f) && sideFaces_.test(g)
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
        for (const label f : sideFaces_)
        {
            if (parts_.sideOfFace[f] < 0)
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

        return std::all_of(faces.begin(), faces.end(), [&](const label f)
        {
            const face& points = surface_.faces[f];

            return std::all_of(points.begin(), points.end(), [&](const label p)
            {
                return mag(side.distance(surface_.points[p])) <= tolerance_;
            });
        });
    }


    bool touchesWall(const labelUList& faces) const
    {
        return std::any_of
        (
            faces.begin(), faces.end(),
            [&](const label f) { return atWall_.test(f); }
        );
    }


    sidePatch curvedThrough(const labelUList& faces) const
    {
        sidePatch side(planeThrough(faces));
        pointField points(surface_.points);
        faceList own(UIndirectList<face>(surface_.faces, faces)());
        removeUnusedPoints(own, points);
        side.shape = std::make_shared<const sideShape>(points, own);

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
        sectors_(sectors),
        edges_(makeWallSides(surface.faces, surface.points.size())),
        layers_(layers),
        tolerance_(tolerance),
        normals_(surface.faceNormals())
    {
        parts_.sideOfFace.setSize(surface.faces.size(), -1);
        setSideFaces();
    }

    sideParts find();

    //- Returns for each curved part that is not wholly seen along its mean
    //  normal a face that is not seen
    Map<label> unseen() const;

    //- Errors: FatalError if a part is not joined to the wall
    void checkJoined() const;
};


sideParts partFinder::find()
{
    // All of a part that is joined at any angle, where it is plane
    for (const labelList& part : joined(-2))
    {
        if (isPlane(part))
        {
            addPart(part, planeThrough(part));
        }
    }

    const List<DynamicList<label>> smooth(joined(samePlaneCosine));
    const List<DynamicList<label>> curved(joined(curvedCosine));
    labelList curvedOf(surface_.faces.size(), -1);
    forAll(curved, i)
    {
        UIndirectList<label>(curvedOf, curved[i]) = i;
    }

    boolList isCurved(curved.size(), false);
    for (const labelList& part : smooth)
    {
        if (!isPlane(part) || !touchesWall(part))
        {
            isCurved[curvedOf[part[0]]] = !isPlane(curved[curvedOf[part[0]]]);
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


Map<label> partFinder::unseen() const
{
    Map<label> faces;

    forAll(parts_.sideOfFace, facei)
    {
        const label s = parts_.sideOfFace[facei];

        if
        (
            s >= 0 && parts_.sides[s].isCurved()
         && (-parts_.sides[s].normal & normals_[facei]) < leastSeen
        )
        {
            faces.insert(s, facei);
        }
    }

    return faces;
}


void partFinder::checkJoined() const
{
    labelList components;
    boolList hasWall
    (
        findComponents(edges_, surface_.faces.size(), components), false
    );
    forAll(components, facei)
    {
        if (!sideFaces_.test(facei))
        {
            hasWall[components[facei]] = true;
        }
    }

    forAll(components, facei)
    {
        const label s = parts_.sideOfFace[facei];

        if (s >= 0 && !hasWall[components[facei]])
        {
            FatalErrorInFunction
                << "The wall does not end on the side patch "
                << parts_.sides[s].name << " at " << parts_.sides[s].origin
                << exit(FatalError);
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
            const label facei = *unseen.cbegin();
            FatalErrorInFunction
                << "The side patch "
                << surface.patchNames[surface.patchIDs[facei]]
                << " is curved so far that at "
                << surface.faces[facei].centre(surface.points)
                << " it is not seen along its mean normal" << nl
                << "Divide it into several patches" << exit(FatalError);
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
