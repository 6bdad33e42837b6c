/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceSectors.H"
#include "directionsNearEdges.H"
#include "directionTriangles.H"
#include "DynamicField.H"
#include "mathematicalConstants.H"
#include "stageProgress.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Directions for all faces around a point
struct faceDirections
{
    const facesAround& around;

    //- Directions of the columns at the other ends of the edges
    const vectorField& neighbourDirections;

    //- Edges at whose other ends sectors meet too
    const bitSet& shared;

    vectorField d = vectorField(around.normals.size());

    faceList triangles{};


    //- Within a right angle of the direction of the neighbour, about edge j
    void appendShared(const label j, DynamicField<vector>& all) const
    {
        if (shared.test(j))
        {
            const vector& e = around.edges[j];
            const vector& x = neighbourDirections[j];
            all.append(normalised(x - (x & e)*e));
        }
    }


    //- What direction i must be in front of so that the directions of the
    //  neighbours at its edges are on the other sides, and all triangles
    //  positive
    vectorField limits(const label i) const
    {
        DynamicField<vector> all(around.normals[i]);

        if (!around.isFirst(i))
        {
            const vector& e = around.edges[i];
            all.append(normalised(neighbourDirections[i] ^ e));
            all.append(normalised(d.rcValue(i) ^ e));
            appendShared(i, all);
        }
        if (!around.isLast(i))
        {
            const vector& e = around.edges[around.next(i)];
            all.append(normalised(e ^ neighbourDirections[around.next(i)]));
            all.append(normalised(e ^ d.fcValue(i)));
            appendShared(around.next(i), all);
        }

        for (const face& t : triangles)
        {
            const label k = t.find(i);
            if (k >= 0)
            {
                all.append(normalised(d[t.nextLabel(k)] ^ d[t.prevLabel(k)]));
            }
        }

        if (around.isFirst(i) || around.isLast(i))
        {
            for (label k = all.size() - 1; k >= 0; --k)
            {
                all.append(around.side->reflected(all[k]));
            }
        }

        return vectorField(std::move(all));
    }


    bool isPositive() const
    {
        bool positive = true;
        forAll(d, i)
        {
            positive = positive && min(limits(i) & d[i]) > 0;
        }

        return positive;
    }


    //- Whether triangles surround each direction once; in the plane of a side
    //  patch, half of it
    bool closes() const
    {
        scalarField angles(d.size(), 0);
        forAll(d, i)
        {
            const vector& e = around.edges[i];
            const vector& f = around.edges[around.next(i)];

            angles[i] =
                (around.isFirst(i) ? 0 : angleAt(d[i], d.rcValue(i), e))
              + angleAt(d[i], e, f)
              + (around.isLast(i) ? 0 : angleAt(d[i], f, d.fcValue(i)))
              - (around.isFirst(i) || around.isLast(i) ? 1 : 2)
               *constant::mathematical::pi;
        }

        addAngles(d, triangles, angles);

        return max(mag(angles)) < frontControls::angleTolerance;
    }


    //- Put all directions near edges
    bool begin(const scalar distance)
    {
        d = directionsNearEdges(around, neighbourDirections, shared, distance);

        return cutIntoTriangles(d, triangles) && closes();
    }


    //- Put each direction into the axis of its cone, until they agree. True if
    //  all are in front of their limits then.
    bool centre()
    {
        const auto centreAll = [&]()
        {
            bool changed = false;
            forAll(d, i)
            {
                const visibilityCone cone(makeVisibilityCone(limits(i)));

                if (!cone.empty())
                {
                    changed = changed || d[i] != cone.axis;
                    d[i] = cone.axis;
                }
            }

            return changed;
        };
        repeatUntilStable
        (
            "centring directions", frontControls::maxRounds, centreAll
        );

        return isPositive();
    }


    //- The sectors; none where not even directions very near to the edges fit
    normalSectors sectors()
    {
        normalSectors all;
        scalar distance = frontControls::ringDistance;
        bool fits = false;
        for (label k = 0; !fits && k < frontControls::maxRings; ++k)
        {
            fits = begin(distance) && centre();
            distance *= 0.5;
        }

        if (!fits)
        {
            return all;
        }

        all.starts = identity(d.size());
        all.axes = d;
        all.triangles = triangles;
        forAll(d, i)
        {
            all.planes.append(limits(i));
        }

        return all;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

normalSectors makeFaceSectors
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const vectorField& neighbourDirections,
    const bitSet& shared,
    const label p
)
{
    const facesAround around(wall, addressing, visibility, p);

    // On two side patches a column can only stand on the line of both
    return addressing.sidesOf(p).size() > 1 || around.normals.size() < 2
      ? normalSectors()
      : faceDirections{around, neighbourDirections, shared}.sectors();
}

} // End namespace Foam

// ************************************************************************* //
