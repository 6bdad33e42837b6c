/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxSides.H"
#include "bitSet.H"
#include "disjointSets.H"
#include "HashSet.H"
#include "ListOps.H"
#include "orientOpenWall.H"
#include "ranges.H"
#include "sideParts.H"
#include "splitAtSidePatches.H"
#include "surfacePart.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A face near to a plane is in it if the product of both unit normals is
//  larger; beside it, the surface leaves the plane
static constexpr scalar inPlaneCosine = 0.9;

//- The rounding of single precision over the tolerance of planes: 1e-6 of the
//  diagonal
static constexpr scalar roundingShare = 1e-2;


//- The side planes of a far boundary that is a box, with the names and types of
//  their patches
static List<sidePatch> sidesOf(const farBoundaryControls& boundary)
{
    List<sidePatch> planes(sidesOf(boundary.box));

    for (sidePatch& plane : planes)
    {
        const word side(plane.name);
        for (const farPatch& patch : boundary.patches)
        {
            if (patch.sides.match(side))
            {
                plane.name = patch.name;
                plane.type = patch.type;
                plane.cyclic = patch.cyclic;
            }
        }
    }

    return planes;
}


namespace
{

//- A surface and what lies in planes
struct surfaceAtPlanes
{
    const wallSurface& surface;

    const scalar tolerance =
        sideTolerance*boundBox(surface.points, false).mag();

    const bool fluidOutside;

    // Made when first asked for, as most surfaces have no face in a side

        //- Points of connected parts that have a border
        bitSet openPoints{};

        //- Component of each face. 1 if the normals of a component point out of
        //  the volume that it bounds with planes, -1 if they point into it, 0
        //  if there is none
        labelList componentOf{};
        List<label> outward{};



    surfaceAtPlanes(const wallSurface& s, const bool outside)
    :
        surface(s),
        fluidOutside(outside)
    {}

    bool isOn(const sidePatch& plane, const point& x) const
    {
        return mag(plane.distance(x)) <= tolerance;
    }

    //- Whether the part of the surface that has a face has a border
    bool isOpenAt(const face& f)
    {
        if (openPoints.empty())
        {
            setOpenPoints();
        }

        return openPoints.test(f[0]);
    }

    void setOpenPoints()
    {
        const label n = surface.points.size();
        disjointSets parts(connectedPoints(n, surface.faces));
        bitSet isOpen(n);
        for (const edge& e : outline(surface.faces))
        {
            isOpen.set(parts.find(e.start()));
        }
        openPoints.resize(n);
        for (label p = 0; p < n; ++p)
        {
            openPoints.set(p, isOpen.test(parts.find(p)));
        }
    }

    void setComponents(const UList<sidePatch>& planes)
    {
        const List<openComponent> components(openComponents(surface, planes));
        componentOf.setSize(surface.faces.size());
        outward.setSize(components.size());
        forAll(components, i)
        {
            for (const label facei : components[i].faces)
            {
                componentOf[facei] = i;
            }
            const scalar volume =
                volumeOf(cappedTriangles(surface, planes, components[i]));
            outward[i] = volume > 0 ? 1 : volume < 0 ? -1 : 0;
        }
    }

    //- Whether a face in a plane is below a body that stands there: a body that
    //  has no border but on planes
    bool isBelow
    (
        const sidePatch& plane,
        const label facei,
        const UList<sidePatch>& planes
    )
    {
        const face& f = surface.faces[facei];
        if (!isOpenAt(f))
        {
            return true;
        }
        if (!fluidOutside)
        {
            return false;
        }
        if (componentOf.empty())
        {
            setComponents(planes);
        }

        return
            outward[componentOf[facei]]
           *(f.unitNormal(surface.points) & plane.normal) > inPlaneCosine;
    }

    //- Whether all points of a face are on a plane
    bool isOnPlane(const sidePatch& plane, const face& f) const
    {
        return allOf(f, [&](const label p)
        {
            return isOn(plane, surface.points[p]);
        });
    }

    bool isIn(const sidePatch& plane, const face& f) const
    {
        return
            isOnPlane(plane, f)
         && mag(f.unitNormal(surface.points) & plane.normal) > inPlaneCosine;
    }

    //- Whether all points of a face are on a plane up to the rounding of single
    //  precision, if the face's part is open: its cut has points near to planes
    bool isBottomOn(const sidePatch& plane, const face& f)
    {
        const scalar near = isOpenAt(f) ? roundingShare*tolerance : tolerance;

        return allOf(f, [&](const label p)
        {
            return mag(plane.distance(surface.points[p])) <= near;
        });
    }

    //- Returns the components that stand on a plane
    labelHashSet standingOn
    (
        const sidePatch& plane,
        const UList<sidePatch>& planes
    )
    {
        labelHashSet standing;
        forAll(surface.faces, facei)
        {
            if
            (
                isIn(plane, surface.faces[facei])
             && isBottomOn(plane, surface.faces[facei])
             && isBelow(plane, facei, planes)
            )
            {
                if (componentOf.empty())
                {
                    setComponents(planes);
                }
                standing.insert(componentOf[facei]);
            }
        }

        return standing;
    }

    bool hasBorderOn(const sidePatch& plane, const edgeList& border) const
    {
        return anyOf(border, [&](const edge& e)
        {
            return isOn(plane, surface.points[e.start()])
                && isOn(plane, surface.points[e.end()]);
        });
    }

    bool hasFaceIn(const sidePatch& plane) const
    {
        return anyOf
        (
            surface.faces, [&](const face& f) { return isIn(plane, f); }
        );
    }

    //- Whether an open part has faces in the plane that reach another plane
    bool covers(const sidePatch& plane, const UList<sidePatch>& sides)
    {
        const auto reaches = [&](const label p)
        {
            return anyOf(sides, [&](const sidePatch& side)
            {
                return mag(side.normal & plane.normal) < 0.5
                    && side.distance(surface.points[p]) >= -tolerance;
            });
        };

        forAll(surface.faces, facei)
        {
            const face& f = surface.faces[facei];
            if
            (
                isIn(plane, f) && anyOf(f, reaches)
             && !isBelow(plane, facei, sides)
            )
            {
                return true;
            }
        }

        return false;
    }

    //- Whether the surface is on both sides of a plane. What is beyond other
    //  planes does not count.
    bool crosses
    (
        const sidePatch& plane,
        const UList<sidePatch>& planes
    ) const
    {
        bool isInFront = false;
        bool isBeyond = false;
        for (const point& x : surface.points)
        {
            const bool counts = allOf(planes, [&](const sidePatch& other)
            {
                return other.distance(x) <= tolerance;
            });
            const scalar distance = plane.distance(x);
            isInFront = isInFront || (counts && distance < -tolerance);
            isBeyond = isBeyond || (counts && distance > tolerance);
        }

        return isInFront && isBeyond;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<sidePatch> sidesOf(const boundBox& box)
{
    static const char* names[] =
        {"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"};

    List<sidePatch> planes(6);
    forAll(planes, side)
    {
        planes[side].name = names[side];
        planes[side].origin = side % 2 ? box.max() : box.min();
        planes[side].normal[side/2] = side % 2 ? 1 : -1;
    }

    return planes;
}


List<sidePatch> withBoxSides
(
    const wallSurface& surface,
    const List<sidePatch>& planes,
    const farBoundaryControls& boundary,
    const bool fluidOutside
)
{
    List<sidePatch> all(planes);
    if (boundary.type != farBoundaryType::box)
    {
        return all;
    }

    surfaceAtPlanes at(surface, fluidOutside);
    const edgeList border(outline(surface.faces));
    const List<sidePatch> sides(sidesOf(boundary));
    for (const sidePatch& side : sides)
    {
        const bool isGiven = anyOf(planes, [&](const sidePatch& given)
        {
            return isSamePlane(side, given, at.tolerance);
        });

        if
        (
            !isGiven && !at.covers(side, sides)
         && (
                at.hasBorderOn(side, border) || at.hasFaceIn(side)
             || at.crosses(side, planes)
            )
        )
        {
            all.append(side);
        }
    }

    return all;
}


List<sidePatch> withoutBareSides
(
    const wallSurface& surface,
    const List<sidePatch>& planes,
    const label nGiven
)
{
    const surfaceAtPlanes at(surface, true);
    const pointField& x = surface.points;
    bitSet isKept(planes.size());
    isKept.set(labelRange(0, nGiven));
    for (const edge& e : outline(surface.faces))
    {
        const label i =
            planeOfEdge(planes, x[e.start()], x[e.end()], at.tolerance);
        if (i >= 0)
        {
            isKept.set(i);
        }
    }

    return subset(isKept, planes);
}


boundBox boxBehind
(
    const wallSurface& surface,
    const farBoundaryControls& boundary,
    const bool fluidOutside
)
{
    boundBox box(boundary.box);
    if (boundary.type != farBoundaryType::box)
    {
        return box;
    }

    surfaceAtPlanes at(surface, fluidOutside);
    const List<sidePatch> sides(sidesOf(boundary));
    forAll(sides, side)
    {
        if (at.covers(sides[side], sides))
        {
            point& corner = side % 2 ? box.max() : box.min();
            corner += 0.1*boundary.box.mag()*sides[side].normal;
        }
    }

    return box;
}


List<sidePatch> freeSides
(
    const farBoundaryControls& boundary,
    const UList<sidePatch>& ends
)
{
    if (boundary.type != farBoundaryType::box)
    {
        return List<sidePatch>();
    }

    const scalar tolerance = sideTolerance*boundary.box.mag();

    return subsetList(sidesOf(boundary), [&](const sidePatch& side)
    {
        return !anyOf(ends, [&](const sidePatch& end)
        {
            return !end.isPart() && isSamePlane(side, end, tolerance);
        });
    });
}


List<sidePatch> cyclicSides
(
    const farBoundaryControls& boundary,
    const UList<sidePatch>& ends
)
{
    List<sidePatch> sides(ends);
    sides.append(freeSides(boundary, ends));

    return subsetList(sides, [](const sidePatch& side)
    {
        return side.type == "cyclic";
    });
}


scalar leastWidth
(
    const farBoundaryControls& boundary,
    const UList<sidePatch>& ends
)
{
    List<sidePatch> planes(freeSides(boundary, ends));
    for (const sidePatch& end : ends)
    {
        if (!end.isPart())
        {
            planes.append(end);
        }
    }

    scalar least = GREAT;
    forAll(planes, i)
    {
        for (label j = 0; j < i; ++j)
        {
            if ((planes[i].normal & planes[j].normal) < -1 + sideTolerance)
            {
                least = min(least, mag(planes[i].distance(planes[j].origin)));
            }
        }
    }

    return least;
}


void requireInBox
(
    const wallSurface& wall,
    const farBoundaryControls& boundary
)
{
    const scalar touching =
        touchShare*sideTolerance*boundBox(wall.points, false).mag();

    for (const sidePatch& side : freeSides(boundary, wall.border.sides))
    {
        for (const point& x : wall.points)
        {
            const scalar distance = side.distance(x);
            if (distance > -touching)
            {
                FatalErrorInFunction
                    << "The wall "
                    << (distance > touching ? "is beyond" : "touches")
                    << " the side " << side.name << " of the far boundary at "
                    << x << ", " << mag(distance) << " m from the side" << nl
                    << "Move the side out. Or move it in: surface.repair"
                    << " stitch cuts the wall there" << exit(FatalError);
            }
        }
    }
}


void requireInFront
(
    const wallSurface& surface,
    const UList<sidePatch>& planes
)
{
    const scalar tolerance =
        sideTolerance*boundBox(surface.points, false).mag();

    for (const sidePatch& plane : planes)
    {
        const scalarField distances(distancesTo(plane, surface.points));
        if (max(distances) <= tolerance)
        {
            continue;
        }

        const bool isCut = min(distances) < -tolerance;
        FatalErrorInFunction
            << "The surface " << (isCut ? "goes through" : "is all beyond")
            << " the side plane " << plane.name << ", up to "
            << max(distances) << " m beyond it at "
            << surface.points[findMax(distances)] << nl;
        if (isCut)
        {
            FatalError
                << "To cut the surface there, write" << nl
                << "    surface { repair stitch; }" << nl;
        }
        else
        {
            FatalError
                << "Move the side out, or turn the normal of the plane" << nl;
        }
        FatalError
            << "The normal must point out of the fluid, and is "
            << plane.normal << exit(FatalError);
    }
}


label removeFacesInSides
(
    wallSurface& surface,
    const UList<sidePatch>& planes,
    const bool fluidOutside
)
{
    if (planes.empty())
    {
        return 0;
    }

    // Small faces on the plane may be steep by rounding
    surfaceAtPlanes at(surface, fluidOutside);
    bitSet kept(surface.faces.size(), true);
    for (const sidePatch& plane : planes)
    {
        const labelHashSet standing(at.standingOn(plane, planes));
        for (label i = 0; standing.size() && i < kept.size(); ++i)
        {
            if
            (
                standing.found(at.componentOf[i])
             && at.isBottomOn(plane, surface.faces[i])
            )
            {
                kept.unset(i);
            }
        }
    }

    const label nGone = kept.size() - kept.count();
    if (nGone && nGone == kept.size())
    {
        FatalErrorInFunction
            << "All faces of the surface are in sides: the body fills the box"
            << " of the far boundary" << nl
            << "Make the box larger. Or, if the fluid is inside of the surface,"
            << " write" << nl << "    surface { fluid inside; }" << nl
            << "and no boundary" << exit(FatalError);
    }
    if (nGone)
    {
        keepFaces(kept, surface);
    }

    return nGone;
}

} // End namespace Foam

// ************************************************************************* //
