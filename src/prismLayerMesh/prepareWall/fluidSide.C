/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidSide.H"
#include "boundBox.H"
#include "FixedList.H"
#include "intersection.H"
#include "ListOps.H"
#include "orientOpenWall.H"
#include "OStringStream.H"
#include "ranges.H"
#include "splitAtSidePatches.H"
#include "surfacePart.H"
#include "triPointRef.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Components of a surface, closed by planes where they end on these
struct closedComponents
{
    const wallSurface& surface;
    const UList<sidePatch>& planes;
    const List<openComponent> components = openComponents(surface, planes);

    //- Triangles of each component, none for a sheet
    List<List<triPoints>> triangles{};

    closedComponents(const wallSurface& s, const UList<sidePatch>& p)
    :
        surface(s),
        planes(p),
        triangles(components.size())
    {
        forAll(components, i)
        {
            triangles[i] = cappedTriangles(surface, planes, components[i]);
        }
    }

    label size() const { return components.size(); }

    //- Whether a component ends on planes, or beyond them, without a volume
    bool isSheet(const label i) const
    {
        const openComponent& c = components[i];
        const scalar near = sideTolerance*boundBox(surface.points, false).mag();

        return
            c.borders.size() && triangles[i].empty()
         && isOnOrBeyond(surface.points, edgeList(c.borders), planes, near);
    }

    //- The triangles of a component without caps
    List<triPoints> bare(const label i) const
    {
        openComponent alone;
        alone.faces = components[i].faces;

        return cappedTriangles(surface, planes, alone);
    }

    //- The components that a point is within, in order
    labelList around(const point& x, const label but = -1) const
    {
        return subsetList(identity(size()), [&](const label i)
        {
            return i != but && isWithin(triangles[i], x);
        });
    }

    //- Whether a sheet is between two points
    bool isBetween(const point& a, const point& b) const
    {
        return anyOf(identity(size()), [&](const label i)
        {
            return isSheet(i) && isBehind(bare(i), a) != isBehind(bare(i), b);
        });
    }

    //- Whether a component bounds the part of space that a point is in
    bool isBeside(const label i, const point& x) const
    {
        const point own
        (
            surface.faces[components[i].faces[0]].centre(surface.points)
        );
        const labelList aroundPoint(around(x));
        const labelList aroundOwn(around(own, i));
        const bool isNext =
            aroundPoint.found(i)
          ? aroundOwn.size() + 1 == aroundPoint.size()
          : aroundOwn == aroundPoint;

        return isNext && !isBetween(own, x);
    }
};


//- Number of faces of bodies that tell the side of a sheet
constexpr label nTellingFaces = 200;

//- Places in each direction of a box that measure volumes
constexpr label nPlaces = 8;


//- The area of bodies in front of a sheet, and behind it [m2]
Pair<scalar> areasBeside
(
    const closedComponents& all,
    const UList<triPoints>& sheet
)
{
    const wallSurface& surface = all.surface;
    DynamicList<label> faces;
    forAll(all.components, i)
    {
        if (all.triangles[i].size() && mag(volumeOf(all.triangles[i])) > 0)
        {
            faces.append(all.components[i].faces);
        }
    }

    Pair<scalar> areas(0, 0);
    const label step = 1 + faces.size()/nTellingFaces;
    for (label i = 0; i < faces.size(); i += step)
    {
        const face& f = surface.faces[faces[i]];
        const point x(f.centre(surface.points));
        const bool isBeyond = anyOf(all.planes, [&](const sidePatch& plane)
        {
            return plane.distance(x) > 0;
        });
        if (!isBeyond)
        {
            (isBehind(sheet, x) ? areas.second() : areas.first()) +=
                f.mag(surface.points);
        }
    }

    return areas;
}


//- The shares of a box before and behind a sheet
Pair<scalar> volumesBeside(const boundBox& box, const UList<triPoints>& sheet)
{
    const scalar each = box.volume()/(nPlaces*nPlaces*nPlaces);
    Pair<scalar> volumes(0, 0);
    for (label i = 0; i < nPlaces*nPlaces*nPlaces; ++i)
    {
        const vector share
        (
            (i % nPlaces + 0.5)/nPlaces,
            (i/nPlaces % nPlaces + 0.5)/nPlaces,
            (i/(nPlaces*nPlaces) + 0.5)/nPlaces
        );
        const point x(box.min() + cmptMultiply(share, box.span()));
        (isBehind(sheet, x) ? volumes.second() : volumes.first()) += each;
    }

    return volumes;
}


//- The box of a surface in front of planes along the axes
boundBox boxInFront(const wallSurface& surface, const UList<sidePatch>& planes)
{
    boundBox box(surface.points, false);
    for (const sidePatch& plane : planes)
    {
        for (direction d = 0; d < 3; ++d)
        {
            if (mag(plane.normal[d]) > 1 - sideTolerance)
            {
                point& corner = plane.normal[d] > 0 ? box.max() : box.min();
                corner[d] = plane.origin[d];
            }
        }
    }

    return box;
}


//- Refuses to guess the side of a sheet
void refuseSheet
(
    const closedComponents& all,
    const word& patch,
    const UList<triPoints>& sheet
)
{
    const Pair<scalar> volumes
    (
        volumesBeside(boxInFront(all.surface, all.planes), sheet)
    );
    FatalErrorInFunction
        << "The patch " << patch << " divides the domain, there are bodies on"
        << " both sides, and more on the side from which its normals point. On"
        << " the side to which its normals point the domain"
        << " has about " << volumes.first() << " m3, on the other side about "
        << volumes.second() << " m3." << nl
        << "Write a point in the fluid:" << nl
        << "    surface { inside (x y z); }" << exit(FatalError);
}


//- Whether the fluid is behind a sheet
bool isFluidBehind
(
    const closedComponents& all,
    const label i,
    const word& patch,
    const wallSurfaceControls& controls,
    const bool fluidOutside
)
{
    const List<triPoints> sheet(all.bare(i));
    if (controls.hasInside)
    {
        return isBehind(sheet, controls.inside);
    }

    // The normals of the file and the bodies are two witnesses
    const bool isSaid = !fluidOutside;
    const Pair<scalar> areas(areasBeside(all, sheet));
    const scalar same = isSaid ? areas.second() : areas.first();
    const scalar whole = areas.first() + areas.second();
    if (whole <= 0 || same > 0.5*whole)
    {
        return isSaid;
    }
    if (3*same > whole)
    {
        refuseSheet(all, patch, sheet);
    }

    return !isSaid;
}

//- The mean of the normals of faces, over their area
vector meanNormal(const wallSurface& surface, const labelUList& faces)
{
    vector sum(Zero);
    for (const label facei : faces)
    {
        sum += surface.faces[facei].areaNormal(surface.points);
    }

    return normalised(sum);
}


//- A line of the log: on which side of a sheet the fluid is, and why
string sideText(const word& patch, const vector& side, const char* why)
{
    OStringStream os;
    os.precision(3);
    os  << "The fluid is on the side " << side << " of the patch " << patch
        << ": " << why << ". To override this: surface { inside (x y z); }"
        << nl;

    return os.str();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool isEnclosed(const wallSurface& surface, const point& x)
{
    static const FixedList<vector, 5> rays
    {
        {0.31, 0.58, 0.75}, {-0.62, 0.47, 0.63}, {0.44, -0.81, 0.39},
        {0.53, 0.36, -0.77}, {-0.71, -0.42, -0.57}
    };
    FixedList<label, 5> nHits(Zero);
    labelList faceOf;
    for (const face& f : wallTriangles(surface, faceOf))
    {
        const pointField& points = surface.points;
        const triPointRef triangle(points[f[0]], points[f[1]], points[f[2]]);
        forAll(rays, i)
        {
            const intersection::algorithm half = intersection::HALF_RAY;
            nHits[i] += triangle.intersection(x, rays[i], half).hit();
        }
    }

    return 2*countOf(nHits, [](const label n) { return n % 2; }) > rays.size();
}


bool isFluidOutside
(
    const wallSurface& surface,
    const UList<sidePatch>& planes,
    const wallSurfaceControls& controls
)
{
    if (!controls.hasInside)
    {
        return controls.fluidOutside;
    }

    const scalar near = sideTolerance*boundBox(surface.points, false).mag();
    const edgeList border(outline(surface.faces));
    const bool isOutside =
        isOnOrBeyond(surface.points, border, planes, near)
      ? closedComponents(surface, planes).around(controls.inside).empty()
      : !isEnclosed(surface, controls.inside);
    if (controls.isFluidGiven && isOutside != controls.fluidOutside)
    {
        FatalErrorInFunction
            << "The entries surface.fluid and surface.inside do not agree: the"
            << " point " << controls.inside << " is "
            << (isOutside ? "outside" : "inside") << " of the surface" << nl
            << "Remove the entry fluid" << exit(FatalError);
    }

    return isOutside;
}


void turnSheets
(
    wallSurface& surface,
    const UList<sidePatch>& planes,
    const wallSurfaceControls& controls,
    const bool fluidOutside,
    string& said
)
{
    if (planes.empty() || outline(surface.faces).empty())
    {
        return;
    }

    bitSet isTurned(surface.faces.size());
    {
        const closedComponents all(surface, planes);
        for (label i = 0; i < all.size(); ++i)
        {
            const labelList& faces = all.components[i].faces;
            const word& patch = surface.patchNames[surface.patchIDs[faces[0]]];
            if (!all.isSheet(i))
            {
                continue;
            }
            const bool isBehindIt =
                isFluidBehind(all, i, patch, controls, fluidOutside);
            if (isBehindIt == fluidOutside)
            {
                isTurned.set(faces);
            }
            said += sideText
            (
                patch, (isBehindIt ? -1 : 1)*meanNormal(surface, faces),
                controls.hasInside ? "the point surface.inside is there"
              : isBehindIt == fluidOutside
              ? "the bodies are there, against the normals of the file"
              : "as the normals of the file say"
            );
        }
    }
    for (const label facei : isTurned)
    {
        surface.faces[facei].flip();
    }
}


wallSurface keepBesideFluid
(
    wallSurface& surface,
    const UList<sidePatch>& planes,
    const wallSurfaceControls& controls
)
{
    wallSurface apart;
    if (!controls.hasInside)
    {
        return apart;
    }

    bitSet kept(surface.faces.size(), true);
    {
        const closedComponents all(surface, planes);
        for (label i = 0; i < all.size(); ++i)
        {
            if (all.triangles[i].size() && !all.isBeside(i, controls.inside))
            {
                kept.unset(all.components[i].faces);
            }
        }
    }
    if (!kept.all())
    {
        apart = surface;
        keepFaces(kept, surface);
        mergePatches(surface);
        kept.flip();
        keepFaces(kept, apart);
    }

    return apart;
}

} // End namespace Foam

// ************************************************************************* //
