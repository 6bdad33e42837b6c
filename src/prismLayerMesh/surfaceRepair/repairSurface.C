/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "repairSurface.H"
#include "boundBox.H"
#include "cutSurface.H"
#include "orientOpenWall.H"
#include "ranges.H"
#include "readWallSurface.H"
#include "sigFpe.H"
#include "splitAtSidePatches.H"
#include "stitchSurface.H"
#include "triSurfaceSearch.H"
#include "wallChanges.H"
#include "wrapSurface.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Edges of a surface are sharp if the normals of their faces differ by more
//  than this [deg]
static constexpr scalar featureAngle = 30;


//- A surface is a sheet if a wrap is on both sides of more than this share of
//  its area
static constexpr scalar plateShare = 0.5;

//- Faces further from the wrap than so many of its sizes are not reached
static constexpr scalar lostSizes = 2;


//- Faces of a surface that are far from another surface
struct lostFaces
{
    label n = 0;
    wordList patches;

    //- The largest distance [m], and the place of that face
    scalar farthest = 0;
    point place = Zero;
};


//- Returns the faces whose centres are further from another surface than a
//  distance [m]
static lostFaces facesBeyond
(
    const wallSurface& surface,
    const nearestSurface& other,
    const scalar distance
)
{
    const pointField centres(centresOf(surface));
    pointField nearest;
    labelList faces;
    other.find(centres, nearest, faces);

    lostFaces lost;
    wordHashSet patches;
    forAll(centres, facei)
    {
        const scalar d = mag(nearest[facei] - centres[facei]);
        if (d > distance)
        {
            ++lost.n;
            patches.insert(surface.patchNames[surface.patchIDs[facei]]);
            if (d > lost.farthest)
            {
                lost.farthest = d;
                lost.place = centres[facei];
            }
        }
    }
    lost.patches = patches.sortedToc();

    return lost;
}


//- Returns the place inside of a closed surface, of a lattice of points, that
//  is furthest from another surface
static point roomiestPlace
(
    const wallSurface& closed,
    const nearestSurface& other
)
{
    static constexpr label n = 16;
    const boundBox box(closed.points, false);
    pointField places(n*n*n);
    forAll(places, i)
    {
        const vector share
        (
            (i % n + 0.5)/n, (i/n % n + 0.5)/n, (i/(n*n) + 0.5)/n
        );
        places[i] = box.min() + cmptMultiply(share, box.span());
    }

    pointField nearest;
    labelList faces;
    other.find(places, nearest, faces);
    const triSurface triangles(toTriSurface(closed));
    const boolList isInside(triSurfaceSearch(triangles).calcInside(places));
    scalarField room(mag(nearest - places));
    forAll(room, i)
    {
        room[i] = isInside[i] ? room[i] : 0;
    }

    return places[findMax(room)];
}


namespace
{

class surfaceRepairer
{
    const wallSurface& original_;
    const surfaceRepairControls& controls_;
    const List<sidePatch>& planes_;
    const bool fluidOutside_;

    //- Patches that are to have no layers
    wordHashSet sidePatches_;

    //- Diagonal of the bounding box [m], and the tolerance of side planes
    const scalar diagonal_;
    const scalar tolerance_;

    repairedSurface repaired_;

    //- A length, or a share of the diagonal where none is given
    scalar orShare(const scalar length, const scalar share) const
    {
        return length > 0 ? length : share*diagonal_;
    }

    bool isSound() const
    {
        return isSoundUpTo(planes_, tolerance_, repaired_.surface);
    }

    //- Returns the faces of patches that are to have no layers
    bitSet facesOnSides() const
    {
        bitSet onSides(original_.faces.size());
        forAll(original_.faces, facei)
        {
            const word& name = original_.patchNames[original_.patchIDs[facei]];
            onSides.set(facei, sidePatches_.found(name));
        }

        return onSides;
    }

    //- Refuses a wrap with the fluid inside that has the fluid outside, because
    //  it is around a sheet
    void refusePlate(const bitSet& inside) const
    {
        scalar all = 0;
        scalar onBothSides = 0;
        forAll(original_.faces, facei)
        {
            const scalar area = original_.faces[facei].mag(original_.points);
            all += area;
            onBothSides += inside.test(facei) ? area : 0;
        }

        if (onBothSides > plateShare*all)
        {
            FatalErrorInFunction
                << "The wrap is on both sides of " << 100*onBothSides/all
                << " % of the surface, and the fluid is to be inside of the"
                << " surface. The surface has an opening through which the"
                << " wrap goes: close it, or let the surface end there by"
                << " layers.patches or surface.sidePlanes" << exit(FatalError);
        }
    }

    //- Counts the faces that the wrap does not reach.
    //  Errors: FatalError if there are any and the fluid is inside, but no seed
    //  says where
    void addLostFaces(const nearestSurface& nearest, const scalar size)
    {
        const wallSurface& wrapped = repaired_.surface;
        const lostFaces lost
        (
            facesBeyond(original_, nearestSurface(wrapped), lostSizes*size)
        );
        if (lost.n && !fluidOutside_ && controls_.seeds.empty())
        {
            FatalErrorInFunction
                << "The wrap does not reach " << lost.n << " faces, up to "
                << lost.farthest << " m from it at " << lost.place
                << ", of the patches " << listed(lost.patches).c_str() << nl
                << "With the fluid inside the wrap begins in the fluid only"
                << " where seeds say so, for example" << nl
                << "    surface { wrapCoeffs { seeds ("
                << roomiestPlace(wrapped, nearest) << "); } }"
                << exit(FatalError);
        }
        addStep
        (
            repaired_.steps, "faces that the wrap does not reach", lost.n,
            DynamicList<point>(pointField(1, lost.place))
        );
    }

    void wrap(const nearestSurface& nearest)
    {
        const scalar size = orShare(controls_.size, 0.01);
        const scalar offset =
            controls_.offset > 0 ? controls_.offset : 0.1*size;

        wallSurface& surface = repaired_.surface;
        surface = wrapSurface(original_, size, offset, controls_.seeds);
        repairSteps& steps = repaired_.steps;
        addStep(steps, "points of the wrap", surface.points.size());
        const snapControls controls
        {
            2*offset, featureAngle, facesInside(original_, nearest, surface),
            facesOnSides()
        };
        if (!fluidOutside_)
        {
            refusePlate(controls.inside);
        }
        addLeaks(original_, controls.inside, size, steps);
        addLostFaces(nearest, size);

        const snapCounts counts
        (
            snapToSurface(original_, nearest, controls, surface)
        );
        addStep(steps, "points brought back to sharp edges", counts.nOnEdges);
        addStep(steps, "points brought back to faces", counts.nOnFaces);
        addStep(steps, "points moved half way to the surface", counts.nHalfWay);
        addStep(steps, "points left in place", counts.nLeft);
    }

    //- Sets the distances between both surfaces, in front of the side planes
    void setDistances(const nearestSurface& nearest)
    {
        wallSurface inFront(original_);
        for (const sidePatch& plane : planes_)
        {
            cutOff(inFront, plane, distancesTo(plane, inFront.points));
        }

        const nearestSurface toRepaired(repaired_.surface);
        repaired_.distance = distanceTo(nearest, repaired_.surface);
        repaired_.distanceOfGiven = distanceTo(toRepaired, inFront);
    }

    void stitch()
    {
        const stitchControls controls
        {
            orShare(controls_.gap, 1e-4), orShare(controls_.hole, 0.05),
            fluidOutside_, planes_, tolerance_
        };
        stitchSurface(controls, repaired_.surface, repaired_.steps);
    }

    //- Cuts off what is beyond side planes. Returns whether there is something
    //  beyond, and the surface was closed: then cavities may be open now.
    bool cut()
    {
        wallSurface& surface = repaired_.surface;

        // Normals of an open surface may point anywhere: no part is a cavity
        const bool mayHaveCavities =
            fluidOutside_ && outline(surface.faces).empty();
        bool isCut = false;
        for (const sidePatch& plane : planes_)
        {
            if (isBeyond(plane, tolerance_, surface))
            {
                cutSurface(surface, plane, repaired_.steps, planes_);
                isCut = true;
            }
        }

        return isCut && mayHaveCavities;
    }

    //- Removes cavities that are closed by side planes
    void fillCavities()
    {
        // A cavity at a cyclic plane goes on beyond it
        const List<sidePatch> closing
        (
            subsetList(planes_, [](const sidePatch& plane)
            {
                return plane.type != "cyclic";
            })
        );
        scalar volume = 0;
        const DynamicList<point> places
        (
            removeCavities(repaired_.surface, closing, volume)
        );
        addStep
        (
            repaired_.steps,
            "cavities removed that a side plane closes, of "
          + Foam::name(volume) + " m3 in all:",
            places.size(), places
        );
    }

    void requireFaces() const
    {
        if (repaired_.surface.faces.empty())
        {
            wordList names;
            for (const sidePatch& plane : planes_)
            {
                names.append(plane.name);
            }
            FatalErrorInFunction
                << "Nothing is left of the surface after its repair. Side"
                << " planes that cut it: " << listed(names).c_str() << nl
                << "Move a side out if the surface is beyond it, or if the box"
                << " is within the body. If the fluid is inside of the surface,"
                << " write" << nl << "    surface { fluid inside; }"
                << exit(FatalError);
        }
    }

public:

    surfaceRepairer
    (
        const wallSurface& surface,
        const wallSurfaceControls& controls,
        const layerControls& layers
    )
    :
        original_(surface),
        controls_(controls.repair),
        planes_(controls.sidePlanes),
        fluidOutside_(controls.fluidOutside),
        diagonal_(boundBox(surface.points, false).mag()),
        tolerance_(sideTolerance*diagonal_)
    {
        repaired_.surface = surface;

        for (const word& name : surface.patchNames)
        {
            if (layers.isSide(name))
            {
                sidePatches_.insert(name);
            }
        }
    }

    repairedSurface repair()
    {
        typedef surfaceRepairControls::method method;
        if (controls_.repair == method::none || isSound())
        {
            return repaired_;
        }

        // CGAL's intervals may be infinite
        const sigFpe::ignore untrapped;
        const nearestSurface nearest(original_);

        // Often there is nothing else to repair. Cavities are looked for in a
        // sound surface only: of bodies that meet each other none is within
        // another.
        bool mayHaveCavities = cut();
        if (!isSound())
        {
            repaired_.surface = original_;
            repaired_.steps.clear();
            controls_.repair == method::stitch ? stitch() : wrap(nearest);
            mayHaveCavities = cut();
        }
        if (mayHaveCavities)
        {
            fillCavities();
        }
        requireFaces();

        wallSurface& surface = repaired_.surface;
        nearest.setPatches(surface, sidePatches_);
        cutReflexFaces(surface);
        orientWallSurface(surface, fluidOutside_);
        setDistances(nearest);

        return repaired_;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

repairedSurface repairSurface
(
    const wallSurface& surface,
    const wallSurfaceControls& controls,
    const layerControls& layers
)
{
    return surfaceRepairer(surface, controls, layers).repair();
}

} // End namespace Foam

// ************************************************************************* //
