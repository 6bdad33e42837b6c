/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polygonMaker.H"

#include "divideGroups.H"
#include "meshCertificate.H"
#include "movePolygonPoints.H"
#include "prismFaces.H"
#include "prismPolyMesh.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Returns the cells that have no certificate, see meshCertificate.H, the cells
//  on faces of the wall with another number of layers, and, of layers alone,
//  the cells on faces of wall and outer surface that intersect.
//  some: the cells that are judged. If these are not all of the mesh, no
//  intersections are looked for.
//  nPatches: the first patches are the wall; of layers alone the outer surface
//  is the next one
//  nLayerCells: the first cells are in layers
static labelList uncertifiedCells
(
    const polyMeshParts& mesh,
    const label nPatches,
    const label nLayers,
    const label nLayerCells,
    const bitSet& some
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
    if (nLayerCells == mesh.nCells && some.all())
    {
        outer = t.patchFaces(nPatches).labels();
    }
    bitSet beyondLayers(mesh.nCells, true);
    beyondLayers.unset(identity(nLayerCells));
    bitSet given(some);
    given.flip();
    const meshCertificate certificate
    (
        certifyMesh
        (
            polyhedralMesh(mesh.points, faces, owner, neighbour),
            identity(nWall, t.patchStarts[0]), outer, beyondLayers, given
        )
    );
    DynamicList<label> cells(certificate.invalidCells);
    forAll(certificate.nLayers, i)
    {
        const label celli = owner[t.patchStarts[0] + i];
        if (some.test(celli) && certificate.nLayers[i] != nLayers)
        {
            cells.append(celli);
        }
    }
    for (const labelPair& pair : certificate.intersections)
    {
        cells.append(owner[pair.first()]);
        cells.append(owner[pair.second()]);
    }

    return labelList(std::move(cells));
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void polygonMaker::setPairs(const UList<sidePatch>& sides)
{
    pairs_ = cyclicFaces(sides, patches_.all);
    if (pairs_.empty())
    {
        return;
    }
    facesOnPairs_.resize(layers_.faces.size());
    tetsOnPairs_.resize(tets_.size());
    columnsOnPairs_.resize(layers_.nColumns());
    pointsOnPairs_.resize(far_.points.size());
    label corner = 0;
    forAll(layers_.faces, facei)
    {
        const face& f = layers_.faces[facei];
        forAll(f, k)
        {
            if (pairs_.has(patches_.ofEdges[corner++]))
            {
                columnsOnPairs_.set(f.faceEdge(k));
                facesOnPairs_.set(facei);
            }
        }
    }
    const polyMeshTopology& t = far_.topology;
    forAll(patches_.ofFar, i)
    {
        const bool isPaired = pairs_.has(patches_.ofFar[i]);
        for (const label f : isPaired ? t.patchFaces(i) : labelRange())
        {
            pointsOnPairs_.set(t.faces[f]);
        }
    }
    keepAt(pointsOnPairs_, tets_.points(), tetsOnPairs_);
}


wallCorners polygonMaker::wall() const
{
    const label n = layers_.nLayers;
    wallCorners wall{layers_, neighbours_, front_, common_, labelList()};
    wall.cells.setSize(front_.groups.size(), -1);
    for (label facei = 0; facei < layers_.nWallFaces(); ++facei)
    {
        forAll(layers_.faces[facei], k)
        {
            label& cell = wall.cells[wall.corner(facei, k)];
            cell = n*front_.of(facei, k);
            if (n == 0)
            {
                const label own = far_.topology.owner[farFaces_[facei]];
                cell = groups_.at(tets_, own, layers_.faces[facei][k]);
            }
        }
    }

    return wall;
}


void polygonMaker::movePoints(polygonGeometry& geometry)
{
    // The others are where they are best
    bitSet isFixed(labels_.size());
    forAll(labels_, p)
    {
        const label i = labels_[p];
        const label facei = points_.wallFaceOf(i);
        const label known = facei < 0 ? i : points_.ofFace(facei, 0);
        const bool isNew = divided_.empty() || divided_.found(known);
        isFixed.set(p, !isNew || (facei < 0 && !points_.isFree(i)));
    }
    movePolygonPoints
    (
        isFixed, pointMoveControls(), nLayerCells(), labels_, points_,
        made_.mesh, geometry
    );
    mayMove_ = false;
}


labelList polygonMaker::divide(const labelUList& cells)
{
    bitSet onFront(front_.nGroups), inFar(groups_.nGroups);
    for (const label celli : cells)
    {
        const label g = corners().groupOf(celli);
        g < front_.nGroups ? onFront.set(g) : inFar.set(g - front_.nGroups);
    }
    divided_.clear();
    corners().visit
    (
        [&](const label g, const label facei, label)
        {
            if (onFront.test(g))
            {
                divided_.insert(points_.ofFace(facei, 0));
            }
        },
        [&](const label g, const label t, label)
        {
            if (inFar.test(g))
            {
                points_.visitInner
                (
                    t, [&](const label i) { divided_.insert(i); }
                );
            }
        }
    );
    const bitSet frontChanged
    (
        divideFrontGroups(layers_, neighbours_, front_, onFront, onFront_)
    );
    const bitSet farChanged
    (
        divideFarGroups(far_, tets_, groups_, inFar, inFar_)
    );
    mayMove_ = true;
    DynamicList<label> stuck;
    for (const label celli : cells)
    {
        const label g = corners().groupOf(celli);
        if (!frontChanged.test(g) && !farChanged.test(g - front_.nGroups))
        {
            stuck.append(celli);
        }
    }

    return labelList(std::move(stuck));
}


void polygonMaker::goBack()
{
    onFront_ = best_->onFront;
    inFar_ = best_->inFar;
    points_.setPlaces(best_->places);
    best_.reset();
    mayMove_ = false;
    isPart_ = false;
    isLast_ = true;
    hasChanged_ = true;
}


bool polygonMaker::dividePoor(const polygonGrade& grade)
{
    if (isTouched() || isLast_)
    {
        return true;
    }
    const bool isBest = !best_ || grade.isBetterThan(best_->grade);
    if (isBest)
    {
        best_.reset
        (
            new validMesh{onFront_, inFar_, points_.places(), grade}
        );
    }
    const labelList& poor = grade.poorCells;
    hasChanged_ =
        nPoorRounds_++ < controls_.nPoorRounds
     && divide(poor).size() < poor.size();
    if (!hasChanged_ && !isBest)
    {
        goBack();
    }

    return !hasChanged_;
}


void polygonMaker::divideInvalid
(
    const labelUList& invalid,
    const polygonGeometry& geometry
)
{
    const labelList stuck(divide(invalid));
    const givenPoints at(points_, labels_, made_.mesh, stuck);
    hasChanged_ = keepAround(at) || stuck.size() < invalid.size();
    if (!hasChanged_ && best_)
    {
        goBack();
    }
    if (!hasChanged_)
    {
        // At the latest when all of them stay, the mesh is as it was given
        hasChanged_ =
            keepBeside(layers_.nColumns(), layers_.faces, onFront_.whole)
          + keepBeside(far_.points.size(), tets_.points(), inFar_.whole);
    }
    place_ = geometry.cellCentres[invalid[0]];
}


bool polygonMaker::keepAround(const givenPoints& at)
{
    return
        keepAt(at.columns, layers_.faces, onFront_.whole)
      + keepAt(at.farPoints, tets_.points(), inFar_.whole);
}


bool polygonMaker::keepOnPairs(const labelUList& cells)
{
    bitSet isWanted(front_.nGroups + groups_.nGroups);
    for (const label celli : cells)
    {
        isWanted.set(corners().groupOf(celli));
    }
    bool isNew = false;
    corners().visit
    (
        [&](const label g, const label facei, label)
        {
            if (isWanted.test(g) && facesOnPairs_.test(facei))
            {
                isNew = onFront_.whole.set(facei) || isNew;
            }
        },
        [&](const label g, const label t, label)
        {
            if (isWanted.test(front_.nGroups + g) && tetsOnPairs_.test(t))
            {
                isNew = inFar_.whole.set(t) || isNew;
            }
        }
    );
    if (isNew)
    {
        return true;
    }
    givenPoints at(points_, labels_, made_.mesh, cells);
    at.columns &= columnsOnPairs_;
    at.farPoints &= pointsOnPairs_;

    return keepAround(at);
}


labelList polygonMaker::invalidIn(const polygonGeometry& geometry) const
{
    const bitSet some(corners().cellsAt(part_.first));
    bitSet invalid(made_.mesh.nCells);
    invalid.set
    (
        withoutKept
        (
            geometry.invalidCells(made_.mesh, some), layers_, front_,
            onFront_.whole, geometry.cellVolumes
        )
    );
    if (isTouched())
    {
        invalid.set(pinchedCells(wall(), points_, labels_, made_.mesh));
    }
    if (!isTouched() || invalid.none())
    {
        invalid.set
        (
            uncertifiedCells
            (
                made_.mesh, layers_.patchNames.size(), layers_.nLayers,
                nLayerCells(), some
            )
        );
    }

    return invalid.sortedToc();
}


void polygonMaker::setCommonPolygons()
{
    const polyMeshTopology& t = made_.mesh.topology;
    made_.commonPolygons = labelList(t.faces.size(), -1);
    forAll(ofPatches_, patchi)
    {
        SubList<label>
        (
            made_.commonPolygons, t.patchSizes[patchi], t.patchStarts[patchi]
        ) = ofPatches_[patchi];
    }
}


void polygonMaker::setCounts(const polygonGeometry& geometry)
{
    polygonCounts& counts = made_.counts;
    compareWalls
    (
        wall(), made_.mesh, geometry, counts.wallDistance,
        counts.wallAreaRatio
    );
    counts.nColumns = layers_.nLayers ? front_.nGroups : 0;
    counts.nLayerCells = nLayerCells();
    counts.nOthers = groups_.ofOthers.size();
    counts.nPolyhedra = groups_.nGroups - counts.nOthers;
    counts.nPartsOfColumns = onFront_.nPartsInUse();
    counts.nPartsOfPolyhedra = inFar_.nPartsInUse();
    counts.nKeptFaces = onFront_.whole.count();
    counts.nKeptTets = inFar_.whole.count();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

polygonMaker::polygonMaker
(
    const prismLayers& layers,
    farFieldMesh& far,
    const commonTriangles& common,
    const UList<sidePatch>& sides,
    const polygonControls& controls
)
:
    layers_(layers),
    far_(far),
    common_(common),
    controls_(controls),
    neighbours_(findFaceNeighbours(layers)),
    tets_(far, nTetsOf(far)),
    points_(layers, far, tets_, common, controls),
    patches_(layers, neighbours_, far),
    changedParts_(layers, far, tets_)
{
    if (layers_.nLayers == 0)
    {
        farFaces_.setSize(layers_.faces.size(), -1);
        forAll(far_.frontFaces, k)
        {
            farFaces_[far_.frontFaces[k]] = far_.topology.patchStarts[0] + k;
        }
    }
    setPairs(sides);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool polygonMaker::keepWhole(commonPolygons& polygons)
{
    const bool hasLayers = layers_.nLayers;
    const label nWhole = onFront_.whole.count();
    if (hasLayers && !isLast_)
    {
        keepNeighbours(layers_, neighbours_, front_, onFront_);
    }
    bool isNew = label(onFront_.whole.count()) > nWhole;
    forAll(common_.faces, facei)
    {
        const label triangle = common_.faces[facei];
        const label t = hasLayers ? -1 : far_.topology.owner[farFaces_[facei]];
        if (polygons.isWhole(triangle))
        {
            isNew = onFront_.whole.set(facei) || isNew;
            isNew = (t >= 0 && inFar_.whole.set(t)) || isNew;
        }
        const bool isWhole =
            hasLayers ? onFront_.whole.test(facei) : inFar_.whole.test(t);
        isNew = (isWhole && polygons.keep(triangle)) || isNew;
    }

    return isNew;
}


void polygonMaker::group(commonPolygons& polygons)
{
    for (const label t : inFar_.whole)
    {
        points_.fixTet(t);
    }
    front_ = groupFront(layers_, neighbours_, controls_, onFront_);
    if (!far_.empty())
    {
        groups_ = groupFarField
        (
            layers_, neighbours_, front_, far_, tets_, inFar_
        );
    }
    if (isTouched())
    {
        joinCommonCorners(wall(), polygons);
    }
}


void polygonMaker::collectFaces(commonPolygons& polygons)
{
    faces_ = meshBuilder();
    part_ =
        isPart_ ? changedParts_.since(front_.starts, onFront_, inFar_)
      : changedPart();
    changedParts_.end(onFront_, inFar_);
    isPart_ = controls_.makesParts && !isTouched();
    if (isTouched() && layers_.nLayers)
    {
        divideGroups(wall(), polygons, front_);
    }
    appendLayerFaces
    (
        layers_, neighbours_, front_, points_, patches_.ofEdges, !isTouched(),
        part_.third, faces_
    );
    if (isTouched())
    {
        ofPatches_ = List<DynamicList<label>>(layers_.patchNames.size());
        appendWallFaces(wall(), points_, polygons, faces_, ofPatches_);
    }
    if (far_.empty())
    {
        appendOuterFaces
        (
            layers_, front_, points_, layers_.patchNames.size(),
            part_.third, faces_
        );
    }
    else
    {
        appendFarFaces
        (
            corners(), part_.third, patches_.ofFar, controls_.sharpAngle,
            faces_
        );
    }
    stays_ = stayingPoints(faces_, points_);
    if (isTouched())
    {
        addCommonPoints(wall(), points_, stays_, polygons);
    }
}


void polygonMaker::makeMesh(const commonPolygons& polygons)
{
    hasChanged_ = false;
    if (isTouched())
    {
        keepCommonPoints(wall(), points_, polygons, stays_);
    }
    made_ = polygonMesh();
    polyMeshParts& mesh = made_.mesh = makePolygonParts
    (
        faces_, points_, stays_, corners().cellsAt(part_.second),
        patches_.all.names.size(), labels_
    );
    mesh.patches = patches_.all;
    faces_ = meshBuilder();
    stays_.clear();
    setCommonPolygons();

    polygonGeometry geometry(mesh);
    if (mayMove_)
    {
        movePoints(geometry);
    }
    const labelList invalid(invalidIn(geometry));
    const labelList alone
    (
        invalid.empty() && part_.isAll()
      ? pairs_.withoutImage(mesh) : labelList()
    );
    isValid_ = false;
    if (invalid.empty() && !part_.isAll())
    {
        // The next round judges all of the mesh
        hasChanged_ = true;
        isPart_ = false;
    }
    else if (alone.size())
    {
        const labelList cells
        (
            UIndirectList<label>(mesh.topology.owner, alone)
        );
        hasChanged_ = keepOnPairs(cells);
        place_ = geometry.faceCentres[alone[0]];
    }
    else if (invalid.size())
    {
        divideInvalid(invalid, geometry);
    }
    else
    {
        const polygonGrade grade(mesh, geometry, controls_);
        made_.counts.grade = grade.scheme;
        isValid_ = dividePoor(grade);
    }
    if (isValid_)
    {
        setCounts(geometry);
    }
}


void polygonMaker::refuse() const
{
    FatalErrorInFunction
        << "No valid polygons were found: a cell is not positive,"
        << " intersects others, or has no image on a cyclic side, at "
        << place_ << nl
        << "Use cells triangles" << exit(FatalError);
}


polygonMesh polygonMaker::take()
{
    if (!far_.empty())
    {
        made_.mesh.cellZones = zonesOf(corners());
    }
    pairs_.align(made_.mesh);

    return std::move(made_);
}

} // End namespace Foam

// ************************************************************************* //
