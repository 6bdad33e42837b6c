/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polygonCells.H"

#include "polygonGeometry.H"
#include "farPolygons.H"
#include "keptParts.H"
#include "makeFarFieldMesh.H"
#include "meshCertificate.H"
#include "movePolygonPoints.H"
#include "OStringStream.H"
#include "prismFaces.H"
#include "prismPolyMesh.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

label nTetsOf(const farFieldMesh& far)
{
    for (const cellZoneParts& zone : far.cellZones)
    {
        if (zone.name == farFieldName)
        {
            return zone.cells.size();
        }
    }

    return 0;
}


//- Returns the cells that have no certificate, see meshCertificate.H, and, of
//  layers alone, the cells on faces of wall and outer surface that intersect.
//  nPatches: the first patches are the wall; of layers alone the outer surface
//  is the next one
//  nLayerCells: the first cells are in layers
labelList uncertifiedCells
(
    const polyMeshParts& mesh,
    const label nPatches,
    const label nLayerCells
)
{
    const polyMeshTopology& t = mesh.topology;
    const faceList& faces = t.faces;
    const labelList& owner = t.owner;
    const labelList& neighbour = t.neighbour;
    label nWall = 0;
    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        nWall += t.patchSizes[patchi];
    }
    labelList outer;
    if (nLayerCells == mesh.nCells)
    {
        outer = identity(t.patchSizes[nPatches], t.patchStarts[nPatches]);
    }
    bitSet beyondLayers(mesh.nCells, true);
    beyondLayers.unset(identity(nLayerCells));
    const meshCertificate certificate
    (
        certifyMesh
        (
            polyhedralMesh(mesh.points, faces, owner, neighbour),
            identity(nWall, t.patchStarts[0]), outer, beyondLayers
        )
    );
    DynamicList<label> cells(certificate.invalidCells);
    for (const labelPair& pair : certificate.intersections)
    {
        cells.append(owner[pair.first()]);
        cells.append(owner[pair.second()]);
    }

    return labelList(std::move(cells));
}


//- Returns the cellZones of a mesh. The layers have the first cells. The zones
//  of the far field follow.
List<cellZoneParts> zonesOf
(
    const farFieldMesh& far,
    const farGroups& groups,
    const label nLayerCells
)
{
    List<cellZoneParts> zones;
    zones.append(cellZoneParts(boundaryLayerName, identity(nLayerCells)));
    const label nTets = groups.ofTets.size();
    for (const cellZoneParts& zone : far.cellZones)
    {
        bitSet cells(nLayerCells + groups.nGroups);
        for (const label celli : zone.cells)
        {
            if (celli >= nTets)
            {
                cells.set(nLayerCells + groups.ofOthers[celli - nTets]);
                continue;
            }
            for (const label g : groups.ofTets[celli])
            {
                cells.set(nLayerCells + g);
            }
        }
        zones.append(cellZoneParts(zone.name, cells.toc()));
    }

    return zones;
}


//- Returns the cells of some that are no prism or hexahedron that stays: these
//  have the certificate of the layers.
//  whole: front faces that stay
//  volumes: of the cells; they must be positive all the same
labelList withoutKept
(
    const labelUList& cells,
    const prismLayers& layers,
    const frontGroups& front,
    const bitSet& whole,
    const scalarField& volumes
)
{
    bitSet isKept(front.nGroups);
    for (const label facei : whole)
    {
        isKept.set(front.of(facei, 0));
    }
    DynamicList<label> others;
    for (const label celli : cells)
    {
        const label group = celli/layers.nLayers;
        const bool stays =
            group < front.nGroups && volumes[celli] > 0 && isKept.test(group);
        if (!stays)
        {
            others.append(celli);
        }
    }

    return labelList(std::move(others));
}


//- Compares the wall of polygons with the wall
void compareWalls
(
    const prismLayers& layers,
    const frontGroups& front,
    const polyMeshParts& mesh,
    const polygonGeometry& geometry,
    polygonCounts& counts
)
{
    labelList columnOf(front.nGroups);
    scalar area = 0;
    for (label facei = 0; facei < layers.nWallFaces(); ++facei)
    {
        const face& f = layers.faces[facei];
        pointField x(f.size());
        forAll(f, k)
        {
            columnOf[front.of(facei, k)] = f[k];
            x[k] = layers(f[k], 0);
        }
        area += face(identity(f.size())).mag(x);
    }
    scalar polygons = 0;
    for (label patchi = 0; patchi < layers.patchNames.size(); ++patchi)
    {
        const label start = mesh.topology.patchStarts[patchi];
        for (label i = 0; i < mesh.topology.patchSizes[patchi]; ++i)
        {
            const label group =
                mesh.topology.owner[start + i]/layers.nLayers;
            const vector& normal = geometry.faceAreas[start + i];
            const vector off
            (
                layers(columnOf[group], 0)
              - geometry.faceCentres[start + i]
            );
            polygons += mag(normal);
            counts.wallDistance = max
            (
                counts.wallDistance,
                mag(off & normal)/max(mag(normal), VSMALL)
            );
        }
    }
    counts.wallAreaRatio = polygons/area;
}


class polygonMaker
{
    const prismLayers& layers_;
    farFieldMesh& far_;
    const polygonControls& controls_;
    const labelListList neighbours_;
    const farTets tets_;
    cornerPoints points_;
    meshPatches patches_;

    //- The patch of each edge without a neighbour, by corner; the patch of each
    //  patch of the far field's topology
    labelList sidePatches_;
    labelList farPatches_;

    // Corners that are cells of their own, and the groups with them
        groupExceptions onFront_;
        groupExceptions inFar_;

    //- Labels of the points in tetrahedra that were divided last. If it is
    //  empty, all points may move.
    labelHashSet divided_;

    // The last mesh: the groups, and the labels of its points
        frontGroups front_;
        farGroups groups_;
        labelList labels_;

    void setPatches()
    {
        const List<DynamicList<labelPair>> open
        (
            openEdges(layers_, neighbours_)
        );
        patches_ = patchesOfMesh(layers_, open.size(), far_);
        const List<labelPair> parts
        (
            partsOfPatches(layers_, open.size(), far_)
        );
        labelList ofLayers
        (
            layers_.patchNames.size() + 1 + open.size(), label(-1)
        );
        farPatches_.setSize(far_.topology.patchStarts.size(), -1);
        forAll(parts, patchi)
        {
            if (parts[patchi].first() >= 0)
            {
                ofLayers[parts[patchi].first()] = patchi;
            }
            if (parts[patchi].second() >= 0)
            {
                farPatches_[parts[patchi].second()] = patchi;
            }
        }
        const frontGroups corners
        (
            groupFront(layers_, neighbours_, controls_, onFront_)
        );
        sidePatches_.setSize(corners.groups.size(), -1);
        forAll(open, i)
        {
            for (const labelPair& e : open[i])
            {
                sidePatches_[corners.starts[e.first()] + e.second()] =
                    ofLayers[layers_.patchNames.size() + 1 + i];
            }
        }
    }

    label nLayerCells() const { return front_.nGroups*layers_.nLayers; }

    //- Moves free points of a mesh to where gains fall
    void movePoints(polyMeshParts& mesh, polygonGeometry& geometry)
    {
        // The others are where they are best
        bitSet isFixed(labels_.size());
        forAll(labels_, p)
        {
            const bool isNew =
                divided_.empty() || divided_.found(labels_[p]);
            isFixed.set(p, !isNew || !points_.isFree(labels_[p]));
        }
        const pointMoveControls moves;
        for
        (
            const label p
          : movePolygonPoints(isFixed, moves, mesh, geometry)
        )
        {
            points_.move(labels_[p], mesh.points[p]);
        }
    }

    //- Returns the mesh, without zones
    polyMeshParts make()
    {
        keepNeighbours(layers_, neighbours_, front_, onFront_);
        for (const label t : inFar_.whole)
        {
            points_.fixTet(t);
        }
        front_ = groupFront(layers_, neighbours_, controls_, onFront_);
        polygonFaces faces;
        appendLayerFaces
        (
            layers_, neighbours_, front_, points_, sidePatches_, faces
        );
        if (far_.empty())
        {
            appendOuterFaces
            (
                layers_, front_, points_, layers_.patchNames.size(), faces
            );
        }
        else
        {
            groups_ = groupFarField
            (
                layers_, neighbours_, front_, far_, tets_, inFar_
            );
            appendFarFaces
            (
                {layers_, front_, far_, tets_, groups_, points_}, farPatches_,
                controls_.sharpAngle, faces
            );
        }
        polyMeshParts mesh
        (
            faces.makeParts
            (
                points_, nLayerCells() + groups_.nGroups,
                patches_.names.size(), labels_
            )
        );
        mesh.patches = patches_;

        return mesh;
    }

    //- Calls visit(celli, corner) for the corners of front faces, and of
    //  tetrahedra, with the first cell that they are in; corner is the number
    //  of the front face, or of the tetrahedron, and the position there
    template<class OnFront, class OnTet>
    void visitCorners(const OnFront& onFront, const OnTet& onTet) const
    {
        forAll(layers_.faces, facei)
        {
            forAll(layers_.faces[facei], k)
            {
                onFront(front_.of(facei, k), facei, k);
            }
        }
        forAll(groups_.ofTets, t)
        {
            for (label k = 0; k < 4; ++k)
            {
                onTet(groups_.ofTets[t][k], t, k);
            }
        }
    }

    //- Sets a corner apart, or, if it is apart, its face or tetrahedron whole.
    //  Returns whether that is new.
    static bool except
    (
        const label corner,
        const label i,
        groupExceptions& exceptions
    )
    {
        return exceptions.apart.set(corner) || exceptions.whole.set(i);
    }

    //- Divides cells that are not valid into corners. If a corner is not valid,
    //  its front face or tetrahedron stays whole. Returns the cells that this
    //  does not change.
    labelList divide(const labelUList& cells)
    {
        // The groups of the front come first; those of the far field follow
        const auto groupOf = [&](const label celli)
        {
            return
                celli < nLayerCells()
              ? celli/layers_.nLayers
              : front_.nGroups + celli - nLayerCells();
        };
        bitSet isWanted(front_.nGroups + groups_.nGroups);
        bitSet isChanged(isWanted.size());
        for (const label celli : cells)
        {
            isWanted.set(groupOf(celli));
        }
        const auto setIf = [&](const label g, const bool hasChanged)
        {
            isChanged.set(g, isChanged.test(g) || hasChanged);
        };
        divided_.clear();
        visitCorners
        (
            [&](const label g, const label facei, const label k)
            {
                if (isWanted.test(g))
                {
                    const label corner = front_.starts[facei] + k;
                    setIf(g, except(corner, facei, onFront_));
                }
            },
            [&](const label farGroup, const label t, const label k)
            {
                const label g = front_.nGroups + farGroup;
                if (isWanted.test(g))
                {
                    setIf(g, except(4*t + k, t, inFar_));
                    points_.visitInner
                    (
                        t, [&](const label i) { divided_.insert(i); }
                    );
                }
            }
        );
        DynamicList<label> stuck;
        for (const label celli : cells)
        {
            if (!isChanged.test(groupOf(celli)))
            {
                stuck.append(celli);
            }
        }

        return labelList(std::move(stuck));
    }

    //- Leaves whole the front faces and tetrahedra that have an edge at cells
    //  of a mesh. A cell that nothing else helps has whole ones around it then,
    //  and is as it was given. Returns whether there was a change.
    bool keepAround(const polyMeshParts& mesh, const labelUList& cells)
    {
        const givenPoints at(points_, labels_, mesh, cells);

        return
            keepAt(at.columns, layers_.faces, onFront_.whole)
          + keepAt(at.farPoints, tets_.points(), inFar_.whole);
    }

    //- Returns the cells that are not valid. If all cells are valid, returns
    //  the cells without a certificate, which takes longer.
    labelList invalidIn
    (
        const polyMeshParts& mesh,
        const polygonGeometry& geometry
    ) const
    {
        const labelList invalid
        (
            withoutKept
            (
                geometry.invalidCells(mesh), layers_, front_, onFront_.whole,
                geometry.cellVolumes
            )
        );

        return
            invalid.size() ? invalid
          : uncertifiedCells(mesh, layers_.patchNames.size(), nLayerCells());
    }

public:

    polygonMaker
    (
        const prismLayers& layers,
        farFieldMesh& far,
        const polygonControls& controls
    )
    :
        layers_(layers),
        far_(far),
        controls_(controls),
        neighbours_(findFaceNeighbours(layers)),
        tets_(far, nTetsOf(far)),
        points_(layers, far, tets_, controls)
    {
        setPatches();
    }

    polygonMesh makeValid()
    {
        polygonMesh made;
        for (;;)
        {
            made.mesh = make();
            polygonGeometry geometry(made.mesh);
            if (!far_.empty())
            {
                movePoints(made.mesh, geometry);
            }
            const labelList invalid(invalidIn(made.mesh, geometry));
            if (invalid.empty())
            {
                const finiteVolumes volumes(geometry.volumes(made.mesh));
                made.counts.grade = gradeOf(volumes, explicitGains(volumes));
                compareWalls
                (
                    layers_, front_, made.mesh, geometry, made.counts
                );
                break;
            }
            const labelList stuck(divide(invalid));
            if (!keepAround(made.mesh, stuck) && stuck.size() == invalid.size())
            {
                FatalErrorInFunction
                    << "No valid polygons were found: a cell is not positive,"
                    << " or intersects others, at "
                    << geometry.cellCentres[invalid[0]] << nl
                    << "Use cells triangles" << exit(FatalError);
            }
        }
        if (!far_.empty())
        {
            made.mesh.cellZones = zonesOf(far_, groups_, nLayerCells());
        }
        polygonCounts& counts = made.counts;
        counts.nColumns = front_.nGroups;
        counts.nLayerCells = nLayerCells();
        counts.nOthers = groups_.ofOthers.size();
        counts.nPolyhedra = groups_.nGroups - counts.nOthers;
        counts.nCornersOfColumns = onFront_.apart.count();
        counts.nCornersOfTets = inFar_.apart.count();
        counts.nKeptFaces = onFront_.whole.count();
        counts.nKeptTets = inFar_.whole.count();

        return made;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

dictionary toDictionary(const polygonCounts& counts)
{
    dictionary entries;
    entries.add("columns", counts.nColumns);
    entries.add("layerCells", counts.nLayerCells);
    entries.add("polyhedra", counts.nPolyhedra);
    entries.add("otherCells", counts.nOthers);
    entries.add("cornersOfColumns", counts.nCornersOfColumns);
    entries.add("cornersOfTets", counts.nCornersOfTets);
    entries.add("keptFaces", counts.nKeptFaces);
    entries.add("keptTets", counts.nKeptTets);
    entries.add("wallDistance", counts.wallDistance);
    entries.add("wallAreaRatio", counts.wallAreaRatio);
    entries.add("largeGains", counts.grade.nLargeGains);
    entries.add("factor", counts.grade.factor);

    return entries;
}


string textOf(const polygonCounts& counts)
{
    OStringStream text;
    text<< counts.nColumns << " columns, " << counts.nLayerCells
        << " cells in layers, " << counts.nPolyhedra << " polyhedra";
    if (counts.nCornersOfColumns || counts.nCornersOfTets)
    {
        text<< "\ncolumns divided into " << counts.nCornersOfColumns
            << " corners of prisms, polyhedra into " << counts.nCornersOfTets
            << " corners of tetrahedra; " << counts.nKeptFaces
            << " columns of prisms and " << counts.nKeptTets
            << " tetrahedra stay";
    }
    text<< "\npoints of the wall are off the polygons by "
        << counts.wallDistance << " m at most, their area is "
        << counts.wallAreaRatio << " of the wall's";

    return text.str();
}


polygonMesh makePolygonCells
(
    const prismLayers& layers,
    farFieldMesh& far,
    const polygonControls& controls
)
{
    return polygonMaker(layers, far, controls).makeValid();
}

} // End namespace Foam

// ************************************************************************* //
