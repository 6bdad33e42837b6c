/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerFront.H"
#include "wallSectors.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The front while it is divided
class frontBuilder
{
    const wallSurface& wall_;
    const wallAddressing& addressing_;
    const wallSectors& divided_;

    //- The second column of each divided point
    labelList secondColumns_;

    layerFront& front_;


    //- Column of the sector of point k
    label sectorColumn(const label k, const label s) const
    {
        return s ? secondColumns_[k] + s - 1 : divided_.points[k];
    }


    //- Column of face i around point p of the wall
    label column(const label p, const label i) const
    {
        const label k = divided_.indices[p];

        return k < 0 ? p : sectorColumn(k, divided_.sectors[k].sector(i));
    }


    //- Face that has no area on the wall
    void addFace(const face& columns)
    {
        front_.surface.faces.append(columns);
        front_.surface.patchIDs.append(-1);
    }


    void addColumns()
    {
        forAll(divided_.points, k)
        {
            secondColumns_[k] = front_.wallPoints.size();

            for (label s = 1; s < divided_.sectors[k].starts.size(); ++s)
            {
                front_.wallPoints.append(divided_.points[k]);
                front_.surface.points.append(wall_.points[divided_.points[k]]);
            }
        }
    }


    //- The faces of the wall stand on the columns of their sectors
    void moveFaces()
    {
        for (const label p : divided_.points)
        {
            const labelList& pFaces = addressing_.pointFaces[p];

            forAll(pFaces, i)
            {
                face& f = front_.surface.faces[pFaces[i]];
                f[wall_.faces[pFaces[i]].find(p)] = column(p, i);
            }
        }
    }


    //- On the edges where sectors of point k meet
    void addEdgeFaces(const label k)
    {
        const label p = divided_.points[k];

        for (const label i : divided_.sectors[k].starts)
        {
            if (i == 0 && addressing_.isOnBorder(p)) continue;

            const label before = addressing_.pointFaces[p].rcIndex(i);
            const label q = addressing_.pointPoints[p][i];

            // Right of the edge from p to q is left of that from q to p
            const label back = addressing_.pointPoints[q].find(p);
            const label right = column(q, back);
            const label left =
                column(q, addressing_.pointFaces[q].rcIndex(back));

            if (left == right)
            {
                addFace(face({left, column(p, i), column(p, before)}));
            }
            else if (p < q)
            {
                addFace(face({column(p, before), right, left, column(p, i)}));
            }
        }
    }


    //- The edges of the border stand on the columns of their sectors; further
    //  ones are between the first and the last column of each divided point
    void moveBorder()
    {
        wallBorder& border = front_.surface.border;

        for (edge& e : border.edges)
        {
            e = edge
            (
                column(e.start(), 0),
                column(e.end(), addressing_.pointFaces[e.end()].size() - 1)
            );
        }

        forAll(divided_.points, k)
        {
            if (addressing_.isOnBorder(divided_.points[k]))
            {
                const label last = divided_.sectors[k].starts.size() - 1;
                border.edges.append
                (
                    edge(sectorColumn(k, last), sectorColumn(k, 0))
                );
                border.edgeSides.append
                (
                    addressing_.sidesOf(divided_.points[k])[0]
                );
            }
        }
    }


    //- Between three or more columns of point k
    void addPointFaces(const label k)
    {
        for (face f : divided_.sectors[k].triangles)
        {
            for (label& s : f)
            {
                s = sectorColumn(k, s);
            }

            addFace(f);
        }
    }


    //- What the columns of a divided point must be in front of besides their
    //  faces
    void addPlanes()
    {
        wallVisibility& visibility = front_.visibility;

        forAll(divided_.points, k)
        {
            forAll(divided_.sectors[k].starts, s)
            {
                const label c = sectorColumn(k, s);
                visibility.polygonNormals[c].append
                (
                    divided_.sectors[k].planes[s]
                );
                visibility.setCone(c);
            }
        }
    }

public:

    frontBuilder
    (
        const wallSurface& wall,
        const wallAddressing& addressing,
        const wallSectors& divided,
        layerFront& front
    )
    :
        wall_(wall),
        addressing_(addressing),
        divided_(divided),
        secondColumns_(divided.points.size()),
        front_(front)
    {}


    void divide()
    {
        addColumns();
        moveFaces();
        moveBorder();

        forAll(divided_.points, k)
        {
            addEdgeFaces(k);
            addPointFaces(k);
        }

        front_.addressing = makeWallAddressing(front_.surface);
        front_.visibility =
            makeWallVisibility(front_.surface, front_.addressing);
        addPlanes();
    }
};

} // End anonymous namespace

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

layerFront makeLayerFront
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const scalar smallestAngle
)
{
    layerFront front;
    front.surface = wall;
    front.addressing = addressing;
    front.visibility = visibility;
    front.wallPoints = identity(wall.points.size());
    front.nWallFaces = wall.faces.size();

    const boolList narrow(visibility.narrowCones(smallestAngle));

    if (narrow.found(true))
    {
        const wallSectors divided
        (
            divideNarrowPoints(wall, addressing, visibility, narrow)
        );
        front.pointsWithoutDirection = divided.pointsWithoutDirection;

        if (front.pointsWithoutDirection.empty())
        {
            frontBuilder(wall, addressing, divided, front).divide();
        }
    }

    front.setConstraints();

    return front;
}

} // End namespace Foam

// ************************************************************************* //
