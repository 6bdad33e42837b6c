/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionMeshes.H"
#include "disjointSets.H"
#include "equalPoints.H"
#include "ListOps.H"
#include "Map.H"
#include "meshBuilder.H"
#include "triangleIndex.H"

#include <algorithm>
#include <vector>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static word nameBetween(const spaceRegions& all, const label a, const label b)
{
    return all.regions[a].name + "_to_" + all.regions[b].name;
}


//- Whether two regions are on both sides of a face of the surface. Both sides
//  of a sheet are in one region.
static bool isBetweenRegions(const spaceRegions& all, const label facei)
{
    const labelPair& both = all.regionsOfFace[facei];

    return
        both.first() >= 0 && both.second() >= 0
     && both.first() != both.second();
}


namespace
{

//- The faces of a region's mesh that another region has, too
class commonFaces
{
    const spaceRegion& region_;

    //- For each face of the mesh the common polygon that it is, see
    //  commonWall.H; -1 if the face is not between two regions. The triangles
    //  are those of the surface of all regions.
    labelList polygons_;

public:

    //- given: the common polygons of the faces; empty if they are triangles
    //  Errors: FatalError with the place of a face that the mesh does not have
    commonFaces
    (
        const spaceRegions& all,
        const label regioni,
        const polyMeshParts& mesh,
        const labelUList& given
    )
    :
        region_(all.regions[regioni]),
        polygons_(mesh.topology.faces.size(), -1)
    {
        if (given.empty())
        {
            findTriangles(all, regioni, mesh);
            return;
        }
        forAll(given, f)
        {
            const label polygon = given[f];
            const bool isBetween =
                polygon >= 0
             && isBetweenRegions(all, commonPolygons::triangle(polygon));
            polygons_[f] = isBetween ? polygon : -1;
        }
    }

    void findTriangles
    (
        const spaceRegions& all,
        const label regioni,
        const polyMeshParts& mesh
    )
    {
        // Points that have one place are one, and sheets are not common
        equalPoints places;
        forAll(region_.surface.points, p)
        {
            places.insert(region_.surface.points[p], region_.points[p]);
        }
        triangleIndex index(2*region_.faces.size());
        forAll(region_.faces, facei)
        {
            if (all.beyond(regioni, facei) >= 0)
            {
                const label f = region_.faces[facei];
                index.insert(triFace(all.surface.faces[f]), f);
            }
        }

        label nFound = 0;
        const polyMeshTopology& t = mesh.topology;
        for (label f = t.neighbour.size(); f < t.faces.size(); ++f)
        {
            face whole(t.faces[f]);
            for (label& p : whole)
            {
                p = places.find(mesh.points[p]);
            }
            if (whole.size() == 3 && min(whole) >= 0)
            {
                const label found = index.lookup(triFace(whole), -1);
                polygons_[f] = found < 0 ? -1 : 3*found;
                nFound += found >= 0;
            }
        }
        requireAll(all, regioni, nFound);
    }

    void requireAll
    (
        const spaceRegions& all,
        const label regioni,
        const label nFound
    ) const
    {
        bitSet isFound(all.surface.faces.size());
        for (const label polygon : polygons_)
        {
            if (polygon >= 0)
            {
                isFound.set(commonPolygons::triangle(polygon));
            }
        }
        label n = 0;
        forAll(region_.faces, facei)
        {
            const label other = all.beyond(regioni, facei);
            n += other >= 0;
            if (other >= 0 && !isFound.test(region_.faces[facei]))
            {
                FatalErrorInFunction
                    << "The mesh of the region " << region_.name
                    << " lacks a face of the region "
                    << all.regions[other].name << ", at "
                    << region_.surface.faces[facei].centre
                       (
                           region_.surface.points
                       )
                    << nl << "This is a fault of harmonicPrismMesh: please"
                    << " report it with the case" << exit(FatalError);
            }
        }
        if (n != nFound)
        {
            FatalErrorInFunction
                << "The mesh of the region " << region_.name << " has "
                << nFound << " faces on other regions, and its surface "
                << n << nl << "This is a fault of harmonicPrismMesh: please"
                << " report it with the case" << exit(FatalError);
        }
    }

    label polygon(const label f) const { return polygons_[f]; }

    //- Returns a face of the surface of all regions that a common face is on
    label surfaceFace(const label f) const
    {
        return commonPolygons::triangle(polygons_[f]);
    }

    bool isCommon(const label f) const { return polygons_[f] >= 0; }
};


//- Joins the meshes of regions
class regionJoiner
{
    const spaceRegions& all_;
    List<polyMeshParts>& meshes_;
    const UList<labelList>& polygons_;
    std::vector<commonFaces> common_;

    //- First cell and first point of each mesh in the list of all
    labelList firstCell_;
    labelList firstPoint_;

    //- For each common polygon: each region, and the face of its mesh
    Map<DynamicList<labelPair>> facesOf_;

    labelList pointLabels_;
    meshBuilder made_;
    polyMeshParts joined_;

    //- The faces of each faceZone among the faces that are made
    HashTable<DynamicList<label>> zones_;

    void setStarts()
    {
        label nCells = 0;
        label nPoints = 0;
        forAll(meshes_, r)
        {
            common_.emplace_back(all_, r, meshes_[r], polygons_[r]);
            firstCell_.append(nCells);
            firstPoint_.append(nPoints);
            nCells += meshes_[r].nCells;
            nPoints += meshes_[r].points.size();
        }
        joined_.nCells = nCells;
        pointLabels_.setSize(nPoints);
    }

    const face& faceOf(const label regioni, const label facei) const
    {
        return meshes_[regioni].topology.faces[facei];
    }

    //- Makes points one that are on a face of two regions
    void joinPoints()
    {
        disjointSets sets(pointLabels_.size());
        forAll(meshes_, r)
        {
            const label n = meshes_[r].topology.faces.size();
            for (label f = 0; f < n; ++f)
            {
                const label key = common_[r].polygon(f);
                if (key < 0)
                {
                    continue;
                }
                facesOf_(key).append(labelPair(r, f));
                if (facesOf_[key].size() == 1)
                {
                    continue;
                }
                const labelPair& other = facesOf_[key][0];
                const face& own = faceOf(r, f);
                for (const label p : faceOf(other.first(), other.second()))
                {
                    const point& x = meshes_[other.first()].points[p];
                    const label q = own
                    [
                        findOf(own, [&](const label k)
                        {
                            return meshes_[r].points[k] == x;
                        })
                    ];
                    sets.join
                    (
                        firstPoint_[other.first()] + p, firstPoint_[r] + q
                    );
                }
            }
        }

        DynamicList<point> points(pointLabels_.size());
        forAll(meshes_, r)
        {
            forAll(meshes_[r].points, p)
            {
                const label i = firstPoint_[r] + p;
                const label root = sets.find(i);
                if (root == i)
                {
                    pointLabels_[i] = points.size();
                    points.append(meshes_[r].points[p]);
                }
                else
                {
                    pointLabels_[i] = pointLabels_[root];
                }
            }
        }
        joined_.points = pointField(std::move(points));
    }

    template<class IsTrue>
    static label findOf(const face& f, const IsTrue& isTrue)
    {
        return std::find_if(f.begin(), f.end(), isTrue) - f.begin();
    }

    face joinedPoints(const label regioni, const label facei) const
    {
        face f(faceOf(regioni, facei));
        for (label& p : f)
        {
            p = pointLabels_[firstPoint_[regioni] + p];
        }

        return f;
    }

    label cellOf(const label regioni, const label celli) const
    {
        return firstCell_[regioni] + celli;
    }

    //- Adds the internal faces of all regions, and the faces between regions
    void addInternal()
    {
        forAll(meshes_, r)
        {
            const polyMeshTopology& t = meshes_[r].topology;
            forAll(t.faces, f)
            {
                const label own = cellOf(r, t.owner[f]);
                if (f < t.neighbour.size())
                {
                    made_.append
                    (
                        joinedPoints(r, f), own, cellOf(r, t.neighbour[f])
                    );
                }
                else if (common_[r].isCommon(f))
                {
                    addBetween(r, f, own);
                }
            }
        }
    }

    //- Adds a face between regions when it is the face of the first one
    void addBetween(const label r, const label f, const label own)
    {
        const auto& both = facesOf_[common_[r].polygon(f)];
        if (both.size() < 2 || both[0] != labelPair(r, f))
        {
            return;
        }
        const label other = both[1].first();
        const labelPair& regions =
            all_.regionsOfFace[common_[r].surfaceFace(f)];
        const word name
        (
            nameBetween
            (
                all_, min(regions.first(), regions.second()),
                max(regions.first(), regions.second())
            )
        );
        zones_(name).append(made_.size());
        made_.append
        (
            joinedPoints(r, f), own,
            cellOf(other, meshes_[other].topology.owner[both[1].second()])
        );
    }

    //- Adds the faces on a patch of each region
    void addPatch(const label patchi)
    {
        forAll(meshes_, r)
        {
            const polyMeshTopology& t = meshes_[r].topology;
            const label own =
                meshes_[r].patches.names.find(joined_.patches.names[patchi]);
            for (const label f : own < 0 ? labelRange() : t.patchFaces(own))
            {
                if (!common_[r].isCommon(f))
                {
                    made_.append
                    (
                        joinedPoints(r, f), cellOf(r, t.owner[f]),
                        meshBuilder::onPatch(patchi)
                    );
                }
            }
        }
    }

    //- Whether a patch of a region has faces that no other region has
    bool hasOwnFaces(const label r, const label patchi) const
    {
        bool has = false;
        for (const label f : meshes_[r].topology.patchFaces(patchi))
        {
            has = has || !common_[r].isCommon(f);
        }

        return has;
    }

    void addPatches()
    {
        meshPatches& patches = joined_.patches;
        forAll(meshes_, r)
        {
            const meshPatches& own = meshes_[r].patches;
            forAll(own.names, patchi)
            {
                if (!hasOwnFaces(r, patchi))
                {
                    continue;
                }
                const label known = patches.names.find(own.names[patchi]);
                if (known < 0)
                {
                    patches.names.append(own.names[patchi]);
                    patches.entries.append(own.entries[patchi]);
                }
                else if
                (
                    own.types()[patchi] != patches.types()[known]
                )
                {
                    FatalErrorInFunction
                        << "The patch " << own.names[patchi] << " has the type "
                        << patches.types()[known] << " in one region, and "
                        << own.types()[patchi] << " in the region "
                        << all_.regions[r].name << nl
                        << "Write the same type in patches of both regions, or"
                        << " one in layers.patches" << exit(FatalError);
                }
            }
        }
        forAll(patches.names, patchi)
        {
            addPatch(patchi);
        }
    }

    //- Puts the faces in order, and adds the zones
    void finish()
    {
        const label nPatches = joined_.patches.names.size();
        const labelList order(made_.order(joined_.nCells, nPatches));
        joined_.topology = made_.topology(order, nPatches);
        const labelList newFaces(invert(made_.size(), order));
        for (const word& name : zones_.sortedToc())
        {
            labelList faces(zones_[name]);
            inplaceRenumber(newFaces, faces);
            Foam::sort(faces);
            joined_.faceZones.append
            (
                faceZoneParts{name, faces, boolList(faces.size(), false)}
            );
        }
        forAll(meshes_, r)
        {
            joined_.cellZones.append
            (
                cellZoneParts
                (
                    all_.regions[r].name,
                    identity(meshes_[r].nCells, firstCell_[r])
                )
            );
        }
    }

public:

    regionJoiner
    (
        const spaceRegions& all,
        List<polyMeshParts>& meshes,
        const UList<labelList>& polygons
    )
    :
        all_(all),
        meshes_(meshes),
        polygons_(polygons)
    {}

    polyMeshParts join()
    {
        setStarts();
        joinPoints();
        addInternal();
        addPatches();
        finish();

        return std::move(joined_);
    }
};


//- Entries of a patch of region a on region b
dictionary mappedEntries(const spaceRegions& all, const label a, const label b)
{
    dictionary entries;
    entries.add("type", "mappedWall");
    entries.add("inGroups", wordList({"wall", "mappedWall"}));
    entries.add("sampleMode", "nearestPatchFace");
    entries.add("sampleRegion", all.regions[b].name);
    entries.add("samplePatch", nameBetween(all, b, a));

    return entries;
}


//- A patch of a mesh that is made anew, and its faces by their former labels
struct newPatch
{
    word name;
    dictionary entries;
    DynamicList<label> faces;
};


//- The patches of region a, without the faces that other regions have. Patches
//  with these follow.
std::vector<newPatch> separatePatches
(
    const spaceRegions& all,
    const label a,
    const polyMeshParts& mesh,
    const labelUList& polygons
)
{
    const commonFaces common(all, a, mesh, polygons);
    std::vector<newPatch> made;
    std::vector<newPatch> between(all.regions.size());
    forAll(mesh.patches.names, patchi)
    {
        made.push_back
        (
            newPatch
            {
                mesh.patches.names[patchi], mesh.patches.entries[patchi], {}
            }
        );
        for (const label f : mesh.topology.patchFaces(patchi))
        {
            if (common.isCommon(f))
            {
                const labelPair& both =
                    all.regionsOfFace[common.surfaceFace(f)];
                between[both.first() == a ? both.second() : both.first()]
                    .faces.append(f);
            }
            else
            {
                made.back().faces.append(f);
            }
        }
    }

    for (label b = 0; b < all.regions.size(); ++b)
    {
        newPatch& patch = between[b];

        // Both regions have them in the order of the surface
        std::sort
        (
            patch.faces.begin(), patch.faces.end(),
            [&](const label f, const label g)
            {
                return common.polygon(f) < common.polygon(g);
            }
        );
        patch.name = nameBetween(all, a, b);
        patch.entries = mappedEntries(all, a, b);
        made.push_back(patch);
    }

    return made;
}

} // End anonymous namespace


//- Moves the faces of region a that other regions have to patches of their own
static void separateRegion
(
    const spaceRegions& all,
    const label a,
    const labelUList& polygons,
    polyMeshParts& mesh
)
{
    const std::vector<newPatch> patches
    (
        separatePatches(all, a, mesh, polygons)
    );
    DynamicList<labelList> facesOf;
    mesh.patches = meshPatches();
    for (const newPatch& patch : patches)
    {
        if (patch.faces.size())
        {
            mesh.patches.names.append(patch.name);
            mesh.patches.entries.append(patch.entries);
            facesOf.append(patch.faces);
        }
    }
    mesh.topology.setPatches(facesOf);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

polyMeshParts joinRegions
(
    const spaceRegions& all,
    List<polyMeshParts>& meshes,
    const UList<labelList>& polygons
)
{
    return regionJoiner(all, meshes, polygons).join();
}


void separateRegions
(
    const spaceRegions& all,
    List<polyMeshParts>& meshes,
    const UList<labelList>& polygons
)
{
    forAll(meshes, a)
    {
        separateRegion(all, a, polygons[a], meshes[a]);
    }
}

} // End namespace Foam

// ************************************************************************* //
