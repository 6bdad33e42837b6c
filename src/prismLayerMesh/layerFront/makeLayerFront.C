/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerFront.H"
#include "adviceOnPoints.H"
#include "faceSectors.H"
#include "wallPointsError.H"

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
    const wallVisibility& visibility_;
    const boolList& narrow_;

    //- Whether all narrow cones have been looked at once
    bool searched_ = false;

    //- Points with more than one column, and their sectors
    DynamicList<label> points_;
    DynamicList<normalSectors> sectors_;

    //- Index in these of each point of the wall, or -1
    labelList indices_;

    //- The second column of each of these points
    labelList secondColumns_;

    layerFront& front_;


    //- Column of the sector of point k
    label sectorColumn(const label k, const label s) const
    {
        return s ? secondColumns_[k] + s - 1 : points_[k];
    }


    //- Column of face i around point p of the wall
    label column(const label p, const label i) const
    {
        const label k = indices_[p];

        return k < 0 ? p : sectorColumn(k, sectors_[k].sector(i));
    }


    //- Sum of the normals of the faces of edge i of p
    vector edgeNormal(const label p, const label i) const
    {
        const vectorField& corners = visibility_.cornerNormals[p];

        return corners[i] + corners[corners.rcIndex(i)];
    }


    //- Direction of the column at the other end of edge i of p; where there are
    //  two, or it is not known yet, the mean of the normals of the edge's faces
    vector middle(const label p, const label i) const
    {
        const label q = addressing_.pointPoints[p][i];
        const label k = indices_[q];

        if (k < 0 && (!narrow_[q] || searched_))
        {
            return visibility_.cones[q].axis;
        }

        if (k >= 0)
        {
            const label back = addressing_.pointPoints[q].find(p);
            const label s = sectors_[k].sector(back);
            const label before = addressing_.pointFaces[q].rcIndex(back);

            if (s == sectors_[k].sector(before))
            {
                return sectors_[k].axes[s];
            }
        }

        return edgeNormal(p, i);
    }


    normalSectors sectorsOf(const label p) const
    {
        vectorField middles(addressing_.pointPoints[p].size());
        vectorField normals(middles.size());
        forAll(middles, i)
        {
            middles[i] = middle(p, i);
            normals[i] = edgeNormal(p, i);
        }

        normalSectors sectors;
        const auto divide = [&](auto divided, const vectorField& m)
        {
            sectors = divided(wall_, addressing_, visibility_, m, p);

            return sectors.starts.size() || !visibility_.cones[p].empty();
        };

        // With other middles cells may be positive all the same
        divide(makeNormalSectors, middles)
     || divide(makeFaceSectors, middles)
     || divide(makeNormalSectors, normals)
     || divide(makeFaceSectors, normals);

        return sectors;
    }


    //- Divide point k again; true if its division changes
    bool divideAgain(const label k)
    {
        const normalSectors old(sectors_[k]);
        const normalSectors sectors(sectorsOf(points_[k]));

        if (sectors.starts.empty())
        {
            return false;
        }

        sectors_[k] = sectors;

        return sectors.starts != old.starts
            || max(mag(sectors.axes - old.axes))
             > frontControls::directionTolerance;
    }


    //- Divide again the points beside others with narrow cones, until the
    //  planes of each follow from the others' directions
    void agree()
    {
        searched_ = true;
        bool changed = true;

        for (label i = 0; changed && i < frontControls::maxRounds; ++i)
        {
            changed = false;
            forAll(points_, k)
            {
                const labelList& beside = addressing_.pointPoints[points_[k]];

                if (UIndirectList<bool>(narrow_, beside).found(true))
                {
                    changed = divideAgain(k) || changed;
                }
            }
        }
    }


    //- Face that has no area on the wall
    void addFace(const face& columns)
    {
        front_.surface.faces.append(columns);
        front_.surface.patchIDs.append(-1);
    }


    void addColumns()
    {
        forAll(points_, k)
        {
            secondColumns_[k] = front_.wallPoints.size();

            for (label s = 1; s < sectors_[k].starts.size(); ++s)
            {
                front_.wallPoints.append(points_[k]);
                front_.surface.points.append(wall_.points[points_[k]]);
            }
        }
    }


    //- The faces of the wall stand on the columns of their sectors
    void moveFaces()
    {
        for (const label p : points_)
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
        const label p = points_[k];

        for (const label i : sectors_[k].starts)
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

        forAll(points_, k)
        {
            if (addressing_.isOnBorder(points_[k]))
            {
                const label last = sectors_[k].starts.size() - 1;
                border.edges.append
                (
                    edge(sectorColumn(k, last), sectorColumn(k, 0))
                );
                border.edgeSides.append(addressing_.sidesOf(points_[k])[0]);
            }
        }
    }


    //- Between three or more columns of point k
    void addPointFaces(const label k)
    {
        for (face f : sectors_[k].triangles)
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

        forAll(points_, k)
        {
            forAll(sectors_[k].starts, s)
            {
                const label c = sectorColumn(k, s);
                visibility.polygonNormals[c].append(sectors_[k].planes[s]);
                visibility.setCone(c);
            }
        }
    }

public:

    frontBuilder
    (
        const wallSurface& wall,
        const wallAddressing& addressing,
        const wallVisibility& visibility,
        const boolList& narrow,
        layerFront& front
    )
    :
        wall_(wall),
        addressing_(addressing),
        visibility_(visibility),
        narrow_(narrow),
        indices_(wall.points.size(), -1),
        front_(front)
    {
        DynamicList<label> lost;
        for (const label p : findIndices(narrow, true))
        {
            normalSectors sectors(sectorsOf(p));

            if (sectors.starts.size())
            {
                indices_[p] = points_.size();
                points_.append(p);
                sectors_.append(std::move(sectors));
            }
            else if (visibility.cones[p].empty())
            {
                lost.append(p);
            }
        }

        if (lost.size())
        {
            throw wallPointsError
            (
                wall, lost,
                "see no directions that are in front of all their faces, not "
                "even with several columns",
                adviceOnPoints(wall, addressing, lost)
            );
        }

        secondColumns_.setSize(points_.size());
        agree();
    }


    void divide()
    {
        addColumns();
        moveFaces();
        moveBorder();

        forAll(points_, k)
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
        frontBuilder(wall, addressing, visibility, narrow, front).divide();
    }

    front.setConstraints();

    return front;
}

} // End namespace Foam

// ************************************************************************* //
