/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "normalSectors.H"
#include "faceSectors.H"
#include "planarFan.H"
#include "sectorSearch.H"
#include "stageProgress.H"

namespace Foam
{

normalSectors makeNormalSectors
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const vectorField& neighbourDirections,
    const label p
)
{
    // On two side patches a column can only stand on the line of both
    return addressing.sidesOf(p).size() > 1
      ? normalSectors()
      : sectorSearch
        (
            wall, addressing, visibility, neighbourDirections, p
        ).best();
}


// * * * * * * * * * * * * * * *  Wall Sectors * * * * * * * * * * * * * * * //

namespace
{

struct pointDivider
{
    const wallSurface& wall;
    const wallAddressing& addressing;
    const wallVisibility& visibility;
    const boolList& narrow;

    //- Whether all narrow cones have been looked at once
    bool searched = false;

    wallSectors divided{};


    //- Sum of the normals of the faces of edge i of p
    vector edgeNormal(const label p, const label i) const
    {
        const vectorField& corners = visibility.cornerNormals[p];

        return corners[i] + corners[corners.rcIndex(i)];
    }


    //- Whether sectors of the other end of edge i of p meet on it
    bool isShared(const label p, const label i) const
    {
        const label q = addressing.pointPoints[p][i];
        const label k = divided.indices[q];
        const label back = addressing.pointPoints[q].find(p);
        const label before = addressing.pointFaces[q].rcIndex(back);

        return k >= 0
            && divided.sectors[k].sector(back)
            != divided.sectors[k].sector(before);
    }


    //- Direction of the column at the other end of edge i of p; where there are
    //  two, or it is not known yet, the mean of the normals of the edge's faces
    vector neighbourDirection(const label p, const label i) const
    {
        const label q = addressing.pointPoints[p][i];
        const label k = divided.indices[q];

        if (isShared(p, i) || (k < 0 && narrow[q] && !searched))
        {
            return edgeNormal(p, i);
        }

        const label back = addressing.pointPoints[q].find(p);

        return k < 0
          ? visibility.cones[q].axis
          : divided.sectors[k].axes[divided.sectors[k].sector(back)];
    }


    normalSectors sectorsOf(const label p) const
    {
        if (pointAcross(wall, addressing, p) >= 0)
        {
            return makePlanarFan(wall, addressing, visibility, p);
        }

        vectorField neighbourDirections(addressing.pointPoints[p].size());
        vectorField normals(neighbourDirections.size());
        bitSet shared(neighbourDirections.size());
        forAll(neighbourDirections, i)
        {
            neighbourDirections[i] = neighbourDirection(p, i);
            normals[i] = edgeNormal(p, i);
            shared.set(i, isShared(p, i));
        }

        const bool hasNoDirection = visibility.cones[p].isFlat();
        normalSectors sectors;

        // Normals may divide where directions of neighbours do not
        for (const vectorField* d : {&neighbourDirections, &normals})
        {
            sectors = makeNormalSectors(wall, addressing, visibility, *d, p);
            if (sectors.starts.size() || !hasNoDirection)
            {
                break;
            }

            sectors =
                makeFaceSectors(wall, addressing, visibility, *d, shared, p);
            if (sectors.starts.size())
            {
                break;
            }
        }

        return sectors;
    }


    //- Divide point k again; true if its division changes
    bool divideAgain(const label k)
    {
        const normalSectors old(divided.sectors[k]);
        const normalSectors sectors(sectorsOf(divided.points[k]));

        if (sectors.starts.empty())
        {
            return false;
        }

        divided.sectors[k] = sectors;

        return sectors.starts != old.starts
            || max(mag(sectors.axes - old.axes))
             > frontControls::directionTolerance;
    }


    //- Divide again the points beside others with narrow cones, until the
    //  planes of each follow from the others' directions
    void agree()
    {
        searched = true;
        const auto divideAll = [&]()
        {
            bool changed = false;
            forAll(divided.points, k)
            {
                const labelList& beside =
                    addressing.pointPoints[divided.points[k]];

                if (UIndirectList<bool>(narrow, beside).found(true))
                {
                    changed = divideAgain(k) || changed;
                }
            }

            return changed;
        };
        repeatUntilStable
        (
            "dividing points again", frontControls::maxRounds, divideAll
        );
    }


    wallSectors divide()
    {
        divided.indices.setSize(wall.points.size(), -1);

        DynamicList<label> lost;
        for (const label p : findIndices(narrow, true))
        {
            normalSectors sectors(sectorsOf(p));

            if (sectors.starts.size())
            {
                divided.indices[p] = divided.points.size();
                divided.points.append(p);
                divided.sectors.append(std::move(sectors));
            }
            else if (visibility.cones[p].empty())
            {
                lost.append(p);
            }
        }

        if (lost.empty())
        {
            agree();
        }
        divided.pointsWithoutDirection = std::move(lost);

        return std::move(divided);
    }
};

} // End anonymous namespace


wallSectors divideNarrowPoints
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const boolList& narrow
)
{
    return pointDivider{wall, addressing, visibility, narrow}.divide();
}

} // End namespace Foam

// ************************************************************************* //
