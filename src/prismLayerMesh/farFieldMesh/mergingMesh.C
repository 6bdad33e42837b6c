/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "mergingMesh.H"
#include "cellPredicates.H"
#include "faceQuality.H"
#include "layerGeometry.H"
#include "ranges.H"
#include "UIndirectList.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

//- Layers below the outer surface whose cells take part in the gains
static const label nContextLayers = 4;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void mergingMesh::addFace(const mergingFace& f)
{
    cells_[f.owner].faces.push_back(faces_.size());
    if (f.neighbour >= 0)
    {
        cells_[f.neighbour].faces.push_back(faces_.size());
    }
    faces_.append(f);
}


void mergingMesh::addFarFaces(const label nContext)
{
    const polyMeshTopology& t = far_.topology;
    const label nInternal = t.neighbour.size();
    List<faceGeometry> geometries(t.faces.size());

    #pragma omp parallel for schedule(static)
    forAll(geometries, f)
    {
        geometries[f] = faceGeometry(pointsOf(f));
    }

    forAll(t.faces, f)
    {
        const label k = f - t.patchStarts[0];
        const label neighbour =
            f < nInternal ? t.neighbour[f]
          : k < t.patchSizes[0] && nContext
          ? far_.nCells + nContext*far_.frontFaces[k] : -1;
        addFace(mergingFace{t.owner[f], neighbour, geometries[f]});
    }
}


void mergingMesh::addLowerFaces
(
    const prismLayers& layers,
    const label nContext,
    const label j
)
{
    const label level = layers.nLayers - j - 1;
    forAll(layers.faces, front)
    {
        const label c = far_.nCells + nContext*front + j;
        faceGeometry f(levelPoints{layers, layers.faces[front], level});
        f.area *= -1;
        addFace(mergingFace{c, j + 1 < nContext ? c + 1 : -1, f});
    }
}


void mergingMesh::addSides
(
    const prismLayers& layers,
    const wallAddressing& addressing,
    const label nContext,
    const label j
)
{
    const label high = layers.nLayers - j;
    forAll(addressing.edges, e)
    {
        const labelPair& fronts = addressing.edgeFaces[e];
        const edge& ends = addressing.edges[e];
        const face& first = layers.faces[fronts.first()];
        const bool forward = first.edgeDirection(ends) > 0;
        const label a = forward ? ends.start() : ends.end();
        const label b = forward ? ends.end() : ends.start();
        const label neighbour = fronts.second() < 0
          ? -1 : far_.nCells + nContext*fronts.second() + j;
        addFace
        (
            mergingFace
            {
                far_.nCells + nContext*fronts.first() + j, neighbour,
                faceGeometry(sidePoints{layers, a, b, high})
            }
        );
    }
}


void mergingMesh::setCentre(const label celli)
{
    mergingCell& c = cells_[celli];
    boost::container::small_vector<faceGeometry, 8> faces;
    for (const label f : c.faces)
    {
        faces.push_back(faces_[f].geometry);
        faces.back().area *= faces_[f].owner == celli ? 1 : -1;
    }
    const cellGeometry cell
    (
        UList<faceGeometry>(faces.data(), faces.size())
    );
    c.centre = cell.centre;
    c.volume = cell.volume3/3;
}


const UIndirectList<point> mergingMesh::pointsOf(const label f) const
{
    const auto found = polygons_.cfind(f);

    return UIndirectList<point>
    (
        far_.points, found.good() ? *found : far_.topology.faces[f]
    );
}


bool mergingMesh::isBehind
(
    const point& x,
    const label f,
    const bool fromOwner
) const
{
    const auto points(pointsOf(f));
    const label n = points.size();

    // The normal of a face points away from its owner
    const int behind = fromOwner ? -1 : 1;
    for (label first = 0; first < min(n - 2, label(2)); ++first)
    {
        for (label k = first + 1; k + 1 < first + n; ++k)
        {
            const int sign = orientation
            (
                points[first], points[k % n], points[(k + 1) % n], x
            );
            if (sign != behind)
            {
                return false;
            }
        }
    }

    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

mergingMesh::mergingMesh
(
    const prismLayers& layers,
    const wallAddressing& addressing,
    const label nTets,
    const farFieldMesh& far
)
:
    far_(far),
    gone_(far.topology.faces.size())
{
    const label nContext = min(nContextLayers, layers.nLayers);
    cells_.setSize(far.nCells + nContext*layers.faces.size());
    partOf_ = identity(cells_.size());
    faces_.reserve
    (
        far.topology.faces.size()
      + nContext*(layers.faces.size() + addressing.edges.size())
    );
    addFarFaces(nContext);
    for (label j = 0; j < nContext; ++j)
    {
        addLowerFaces(layers, nContext, j);
        addSides(layers, addressing, nContext, j);
    }

    #pragma omp parallel for schedule(static)
    forAll(cells_, c)
    {
        setCentre(c);
        cells_[c].nTets = c < nTets;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label mergingMesh::partOf(label c) const
{
    while (partOf_[c] != c)
    {
        c = partOf_[c];
    }

    return c;
}


//- Rounding of the centre of a polyhedron, over its largest coordinate: another
//  order of the faces gives another centre
static constexpr scalar centreRounding = 100*SMALL;


bool mergingMesh::isStar(const label c) const
{
    const point& centre = cells_[c].centre;
    const scalar rounding = centreRounding*cmptMax(cmptMag(centre));

    return allOf(cells_[c].faces, [&](const label f)
    {
        const faceGeometry& g = faces_[f].geometry;
        const bool isOwner = faces_[f].owner == c;
        const scalar pyramid3 = (isOwner ? 1 : -1)*g.pyramid3(centre);

        return pyramid3 > rounding*mag(g.area)
            && isBehind(centre, f, isOwner);
    });
}


bool mergingMesh::isBehindPolygon(const label c, const label polygon) const
{
    const bool fromOwner = faces_[polygon].owner == c;
    for (const label f : cells_[c].faces)
    {
        for (const label p : far_.topology.faces[f])
        {
            if
            (
                polygons_[polygon].find(p) < 0
             && !isBehind(far_.points[p], polygon, fromOwner)
            )
            {
                return false;
            }
        }
    }

    return true;
}


void mergingMesh::appendNeighbours(const label c, fewLabels& cells) const
{
    for (const label f : cells_[c].faces)
    {
        const label other = across(f, c);
        if (other >= 0 && cells.find(other) < 0)
        {
            cells.append(other);
        }
    }
}


labelList mergingMesh::fanOf
(
    const edge& e,
    const label from,
    const label to
) const
{
    const auto has = [&](const label f)
    {
        const face& points = far_.topology.faces[f];

        return points.found(e.start()) && points.found(e.end());
    };

    DynamicList<label> fan;
    label f = from;
    label c = faces_[from].owner;
    while (c >= 0 && cells_[c].nTets == 1)
    {
        fan.append(c);
        label next = -1;
        for (const label g : cells_[c].faces)
        {
            next = g != f && has(g) ? g : next;
        }
        if (next == to)
        {
            return labelList(std::move(fan));
        }
        f = next;
        c = across(f, c);
    }

    return labelList();
}


mergingMesh::state mergingMesh::stateOf(const labelUList& cells) const
{
    state now;
    for (const label c : cells)
    {
        now.cells.append(std::make_pair(c, cells_[c]));
        for (const label f : cells_[c].faces)
        {
            now.faces.append(std::make_pair(f, faces_[f]));
        }
    }

    return now;
}


void mergingMesh::restore(const state& before)
{
    for (const auto& c : before.cells)
    {
        cells_[c.first] = c.second;
        partOf_[c.first] = c.first;
    }
    for (const auto& f : before.faces)
    {
        faces_[f.first] = f.second;
    }
}


void mergingMesh::merge(const label a, const label b)
{
    mergingCell& into = cells_[a];
    mergingCell& from = cells_[b];
    const scalar volume = into.volume + from.volume;
    into.centre = (into.volume*into.centre + from.volume*from.centre)/volume;
    into.volume = volume;
    into.nTets += from.nTets;

    faceLabels faces;
    for (const label f : into.faces)
    {
        if (across(f, a) != b)
        {
            faces.push_back(f);
        }
    }
    for (const label f : from.faces)
    {
        mergingFace& g = faces_[f];
        if (across(f, b) != a)
        {
            (g.owner == b ? g.owner : g.neighbour) = a;
            faces.push_back(f);
        }
    }
    into.faces = std::move(faces);
    from.faces.clear();
    partOf_[b] = a;

    // The centre of a cell with a warped polygon is no mean of the centres
    const auto isPolygon = [&](const label f) { return polygons_.found(f); };
    if (polygons_.size() && anyOf(cells_[a].faces, isPolygon))
    {
        setCentre(a);
    }
}


void mergingMesh::unite(const labelUList& triangles, const face& polygon)
{
    const label first = triangles[0];
    for (const label c : {faces_[first].owner, faces_[first].neighbour})
    {
        faceLabels kept;
        for (const label g : cells_[c].faces)
        {
            if (g == first || !triangles.found(g))
            {
                kept.push_back(g);
            }
        }
        cells_[c].faces = kept;
    }
    for (const label g : triangles)
    {
        gone_.set(g, g != first);
    }
    polygons_.insert(first, polygon);
    faces_[first].geometry = faceGeometry(pointsOf(first));
    setCentre(faces_[first].owner);
    setCentre(faces_[first].neighbour);
}


void mergingMesh::separate(const labelUList& triangles)
{
    polygons_.erase(triangles[0]);
    gone_.unset(triangles);
}


scalar mergingMesh::excessOfFaces
(
    const labelUList& cells,
    const mergeControls& controls
) const
{
    const scalar least = Foam::cos(degToRad(controls.maxNonOrtho));
    const scalar leastAtCore = Foam::cos(degToRad(controls.maxNonOrthoAtCore));
    scalar sum = 0;
    const auto add = [&](const label f)
    {
        const mergingFace& g = faces_[f];
        if (g.neighbour < 0)
        {
            return;
        }
        const point& own = cells_[g.owner].centre;
        const point& other = cells_[g.neighbour].centre;
        const vector& area = g.geometry.area;
        const scalar toOwn = mag(area & (g.geometry.centre - own));
        const scalar toOther = mag(area & (other - g.geometry.centre));
        const scalar weight =
            min(toOwn, toOther)/max(toOwn + toOther, VSMALL);
        scalar excess =
            nonOrthoViolation
            (
                area, other - own,
                isOfCore(g.owner) || isOfCore(g.neighbour) ? leastAtCore : least
            )
          + max(controls.minWeight - weight, scalar(0))/controls.minWeight;
        if (f < far_.topology.faces.size())
        {
            excess += skewnessViolation
            (
                g.geometry, pointsOf(f), own, other, controls.maxSkewness
            );
        }
        sum += controls.faceWeight*excess;
    };
    forAll(cells, i)
    {
        for (const label f : cells_[cells[i]].faces)
        {
            const label j = cells.find(across(f, cells[i]));
            if (j < 0 || j > i)
            {
                add(f);
            }
        }
    }

    return sum;
}

} // End namespace Foam

// ************************************************************************* //
