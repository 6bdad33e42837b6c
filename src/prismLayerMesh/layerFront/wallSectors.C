/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSectors.H"
#include "faceSectors.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

class pointDivider
{
    const wallSurface& wall_;
    const wallAddressing& addressing_;
    const wallVisibility& visibility_;
    const boolList& narrow_;

    //- Whether all narrow cones have been looked at once
    bool searched_ = false;

    wallSectors divided_;


    //- Sum of the normals of the faces of edge i of p
    vector edgeNormal(const label p, const label i) const
    {
        const vectorField& corners = visibility_.cornerNormals[p];

        return corners[i] + corners[corners.rcIndex(i)];
    }


    //- Whether sectors of the other end of edge i of p meet on it
    bool isShared(const label p, const label i) const
    {
        const label q = addressing_.pointPoints[p][i];
        const label k = divided_.indices[q];
        const label back = addressing_.pointPoints[q].find(p);
        const label before = addressing_.pointFaces[q].rcIndex(back);

        return k >= 0
            && divided_.sectors[k].sector(back)
            != divided_.sectors[k].sector(before);
    }


    //- Direction of the column at the other end of edge i of p; where there are
    //  two, or it is not known yet, the mean of the normals of the edge's faces
    vector middle(const label p, const label i) const
    {
        const label q = addressing_.pointPoints[p][i];
        const label k = divided_.indices[q];

        if (isShared(p, i) || (k < 0 && narrow_[q] && !searched_))
        {
            return edgeNormal(p, i);
        }

        const label back = addressing_.pointPoints[q].find(p);

        return k < 0
          ? visibility_.cones[q].axis
          : divided_.sectors[k].axes[divided_.sectors[k].sector(back)];
    }


    normalSectors sectorsOf(const label p) const
    {
        vectorField middles(addressing_.pointPoints[p].size());
        vectorField normals(middles.size());
        bitSet shared(middles.size());
        forAll(middles, i)
        {
            middles[i] = middle(p, i);
            normals[i] = edgeNormal(p, i);
            shared.set(i, isShared(p, i));
        }

        normalSectors sectors;
        const auto found = [&](normalSectors&& divided)
        {
            sectors = std::move(divided);

            return sectors.starts.size() || !visibility_.cones[p].empty();
        };
        const auto byNormals = [&](const vectorField& m)
        {
            return makeNormalSectors(wall_, addressing_, visibility_, m, p);
        };
        const auto byFaces = [&](const vectorField& m)
        {
            return
                makeFaceSectors(wall_, addressing_, visibility_, m, shared, p);
        };

        // With other middles cells may be positive all the same
        found(byNormals(middles)) || found(byFaces(middles))
     || found(byNormals(normals)) || found(byFaces(normals));

        return sectors;
    }


    //- Divide point k again; true if its division changes
    bool divideAgain(const label k)
    {
        const normalSectors old(divided_.sectors[k]);
        const normalSectors sectors(sectorsOf(divided_.points[k]));

        if (sectors.starts.empty())
        {
            return false;
        }

        divided_.sectors[k] = sectors;

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
            forAll(divided_.points, k)
            {
                const labelList& beside =
                    addressing_.pointPoints[divided_.points[k]];

                if (UIndirectList<bool>(narrow_, beside).found(true))
                {
                    changed = divideAgain(k) || changed;
                }
            }
        }
    }

public:

    pointDivider
    (
        const wallSurface& wall,
        const wallAddressing& addressing,
        const wallVisibility& visibility,
        const boolList& narrow
    )
    :
        wall_(wall),
        addressing_(addressing),
        visibility_(visibility),
        narrow_(narrow)
    {
        divided_.indices.setSize(wall.points.size(), -1);
    }


    wallSectors divide()
    {
        DynamicList<label> lost;
        for (const label p : findIndices(narrow_, true))
        {
            normalSectors sectors(sectorsOf(p));

            if (sectors.starts.size())
            {
                divided_.indices[p] = divided_.points.size();
                divided_.points.append(p);
                divided_.sectors.append(std::move(sectors));
            }
            else if (visibility_.cones[p].empty())
            {
                lost.append(p);
            }
        }

        if (lost.empty())
        {
            agree();
        }
        divided_.pointsWithoutDirection = std::move(lost);

        return std::move(divided_);
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

wallSectors divideNarrowPoints
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const boolList& narrow
)
{
    return pointDivider(wall, addressing, visibility, narrow).divide();
}

} // End namespace Foam

// ************************************************************************* //
