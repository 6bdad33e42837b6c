/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "movePolygonPoints.H"

#include "HashSet.H"
#include "polygonGeometry.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

typedef DynamicList<label, 64> someLabels;


//- A mesh whose points move one by one
class movingPoints
{
    const pointMoveControls& controls_;
    polyMeshParts& mesh_;
    polygonGeometry geometry_;
    const scalar leastCosine_;

    //- Poorness of each cell
    scalarField poor_;
    DynamicList<schemeFace> seen_;

    const polyMeshTopology& topology() const { return mesh_.topology; }

    //- The area of the triangles from the centre of a face to its edges that a
    //  point does not see, as share of the face
    scalar hidden
    (
        const label facei,
        const scalar way,
        const point& from
    ) const
    {
        const face& f = topology().faces[facei];
        const point& centre = geometry_.faceCentres[facei];
        scalar sum = 0;
        for (label k = 0; k < f.size() && f.size() > 3; ++k)
        {
            const vector area
            (
                0.5
               *(
                    (mesh_.points[f[k]] - centre)
                  ^ (mesh_.points[f.nextLabel(k)] - centre)
                )
            );
            sum += way*(area & (centre - from)) > 0 ? 0 : mag(area);
        }

        const scalar whole = max(mag(geometry_.faceAreas[facei]), sum);

        return sum > 0 ? 0.3 + sum/whole : 0;
    }

    //- Skewness of a face between two cells, as OpenFOAM defines it
    scalar skewness(const label facei) const
    {
        const polyMeshTopology& t = topology();
        const point& own = geometry_.cellCentres[t.owner[facei]];
        const vector d(geometry_.cellCentres[t.neighbour[facei]] - own);
        const vector& area = geometry_.faceAreas[facei];
        const vector to(geometry_.faceCentres[facei] - own);
        const scalar along = area & d;
        if (along <= SMALL*mag(area)*mag(d))
        {
            return controls_.maxSkewness + 5;
        }
        const vector off(to - (area & to)/along*d);
        const vector way(normalised(off));
        scalar size = 0.2*mag(d) + VSMALL;
        for (const label p : t.faces[facei])
        {
            const vector arm(mesh_.points[p] - geometry_.faceCentres[facei]);
            size = max(size, mag(way & arm));
        }

        return mag(off)/size;
    }

    scalar poorness(const label celli)
    {
        const finiteVolumes volumes(geometry_.volumes(mesh_));
        const scalar gain = gainOf(volumes, celli, seen_);
        scalar sum = sqr(min(max(gain - controls_.gain, scalar(0)), scalar(2)));
        const scalar size = ::cbrt(mag(geometry_.cellVolumes[celli]));
        for (const schemeFace& f : seen_)
        {
            const scalar area = mag(f.area);
            if (f.explicitArea == vector::zero && f.ownShare == 0)
            {
                continue;
            }
            const scalar cosine = (f.area & f.d)/max(area*mag(f.d), VSMALL);
            sum += controls_.faceWeight*max(leastCosine_ - cosine, scalar(0));
        }
        for (const label facei : geometry_.cells[celli])
        {
            const vector& area = geometry_.faceAreas[facei];
            const scalar way = topology().owner[facei] == celli ? 1 : -1;
            const scalar depth = way*
            (
                area
              & (geometry_.faceCentres[facei] - geometry_.cellCentres[celli])
            )/max(mag(area)*size, VSMALL);
            sum += depth > 0 ? 0 : 5 - 5*max(depth, scalar(-1));
            sum += hidden(facei, way, geometry_.cellCentres[celli]);
            if (facei < topology().neighbour.size())
            {
                const scalar excess = skewness(facei) - controls_.maxSkewness;
                sum += min(max(excess, scalar(0)), scalar(5));
            }
        }

        return sum;
    }

    //- Sums the poorness of some cells, and keeps it
    scalar sumPoorness(const labelUList& cells)
    {
        scalar sum = 0;
        for (const label celli : cells)
        {
            poor_[celli] = poorness(celli);
            sum += poor_[celli];
        }

        return sum;
    }

    void update(const labelUList& faces, const labelUList& cells)
    {
        for (const label facei : faces)
        {
            geometry_.setFace(mesh_, facei);
        }
        for (const label celli : cells)
        {
            geometry_.setCell(mesh_, celli);
        }
    }

    labelList cellsOf(const labelUList& faces) const
    {
        const polyMeshTopology& t = topology();
        labelHashSet cells;
        for (const label facei : faces)
        {
            cells.insert(t.owner[facei]);
            if (facei < t.neighbour.size())
            {
                cells.insert(t.neighbour[facei]);
            }
        }

        return cells.sortedToc();
    }

public:

    movingPoints(const pointMoveControls& controls, polyMeshParts& mesh)
    :
        controls_(controls),
        mesh_(mesh),
        geometry_(mesh),
        leastCosine_(Foam::cos(degToRad(controls.maxNonOrtho))),
        poor_(mesh.nCells)
    {
        forAll(poor_, celli)
        {
            poor_[celli] = poorness(celli);
        }
    }

    bool isPoor(const label celli) const { return poor_[celli] > 0; }

    const labelUList& facesOf(const label celli) const
    {
        return geometry_.cells[celli];
    }

    //- Moves a point by steps along the axes while that helps; halves the step
    //  if none does. Returns whether the point has moved.
    bool move(const label p, const labelUList& faces, scalar& step)
    {
        // Cells beside these change little, and have their turns
        const labelList cells(cellsOf(faces));
        scalar least = sumPoorness(cells);
        point best(mesh_.points[p]);
        bool hasMoved = false;
        for (label i = 0; i < 6 && least > 0; ++i)
        {
            vector way(Zero);
            way[i/2] = (i % 2 ? -step : step);
            mesh_.points[p] = best + way;
            update(faces, cells);
            const scalar now = sumPoorness(cells);
            if (now < 0.999*least)
            {
                least = now;
                best = mesh_.points[p];
                hasMoved = true;
            }
        }
        mesh_.points[p] = best;
        update(faces, cells);
        sumPoorness(cells);
        step *= hasMoved ? 1 : 0.5;

        return hasMoved;
    }
};


//- The faces at each point that may move and is at a poor cell
void findFacesAt
(
    const movingPoints& moving,
    const polyMeshParts& mesh,
    const bitSet& isFixed,
    List<someLabels>& facesAt,
    bitSet& isWanted
)
{
    for (label celli = 0; celli < mesh.nCells; ++celli)
    {
        if (!moving.isPoor(celli))
        {
            continue;
        }
        for (const label facei : moving.facesOf(celli))
        {
            for (const label p : mesh.topology.faces[facei])
            {
                isWanted.set(p, !isFixed.test(p));
            }
        }
    }
    facesAt.setSize(mesh.points.size());
    forAll(mesh.topology.faces, facei)
    {
        for (const label p : mesh.topology.faces[facei])
        {
            if (isWanted.test(p))
            {
                facesAt[p].append(facei);
            }
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bitSet movePolygonPoints
(
    const bitSet& isFixed,
    const pointMoveControls& controls,
    polyMeshParts& mesh
)
{
    bitSet hasMoved(mesh.points.size());
    movingPoints moving(controls, mesh);
    List<someLabels> facesAt;
    bitSet isWanted(mesh.points.size());
    findFacesAt(moving, mesh, isFixed, facesAt, isWanted);

    // Mean distances to the points beside
    scalarField steps(mesh.points.size(), 0);
    for (const label p : isWanted)
    {
        for (const label facei : facesAt[p])
        {
            const face& f = mesh.topology.faces[facei];
            steps[p] +=
                controls.step/facesAt[p].size()
               *mag(mesh.points[f.nextLabel(f.find(p))] - mesh.points[p]);
        }
    }
    for (label round = 0; round < controls.nRounds; ++round)
    {
        for (const label p : isWanted)
        {
            if (moving.move(p, facesAt[p], steps[p]))
            {
                hasMoved.set(p);
            }
        }
    }

    return hasMoved;
}

} // End namespace Foam

// ************************************************************************* //
