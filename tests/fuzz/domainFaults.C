/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldFaults.H"
#include "faultText.H"
#include "planeDomain.H"
#include "prismQuality.H"
#include "ranges.H"
#include "surfaceMeasures.H"
#include "tetBoundary.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

namespace
{

class domainJudge : madeFarField
{
    //- Of the domain
    const scalar size_;

    //- Whether the outer face on a front face is one face of the mesh
    bool isWhole(label fronti) const;

    //- Of the space that the layers leave, from their outer surface
    scalar volumeLeft() const;

    std::string volumeFault() const;

    //- Areas of all planes that the wall leaves
    scalarField areasLeft() const;

    //- The plane that all points of a face are in, or -1
    label planeOf(const face& f) const;

    std::string areaFault() const;

    std::string sphereFault() const;

public:

    explicit domainJudge(const madeFarField& made)
    :
        madeFarField(made),
        size_(boundBox(made.mesh.points(), false).mag())
    {}

    std::string fault() const;
};

} // End anonymous namespace


bool domainJudge::isWhole(const label fronti) const
{
    const face& columns = layers.faces[fronti];
    const label top = (fronti + 1)*layers.nLayers - 1;

    return anyOf(mesh.cells()[top], [&](const label facei)
    {
        const face& f = mesh.faces()[facei];

        return f.size() == columns.size()
         && allOf(columns, [&](const label c)
            {
                return f.found(layers.pointLabel(c, layers.nLayers));
            });
    });
}


scalar domainJudge::volumeLeft() const
{
    const wallSurface outer(outerPolygons(layers));
    labelList triangleFace;
    const faceList triangles(outerTriangles(outer, triangleFace));
    const endedSurface surface
    {
        outer.points, triangles, layers.border.edges, layers.border.edgeSides
    };
    const List<sidePlane> sides
    (
        SubList<sidePlane>(asked.planes, layers.border.sides.size())
    );
    scalar within = volumeOf(surface, sides);

    // A polygon that stays whole is no pair of triangles, if it is warped
    forAll(triangles, i)
    {
        const label fronti = triangleFace[i];
        if (layers.faces[fronti].size() > 3 && isWhole(fronti))
        {
            const UIndirectList<point> points(outer.points, triangles[i]);
            within -= faceGeometry(points).pyramid3(Zero)/3;
            if (i == 0 || triangleFace[i - 1] != fronti)
            {
                const UIndirectList<point> whole
                (
                    outer.points, layers.faces[fronti]
                );
                within += faceGeometry(whole).pyramid3(Zero)/3;
            }
        }
    }

    return asked.fluidInside ? -within : volumeOf(asked.planes) - within;
}


std::string domainJudge::volumeFault() const
{
    scalar filled = 0;
    for (label celli = nLayerCells(); celli < mesh.nCells(); ++celli)
    {
        filled += mesh.cellVolumes()[celli];
    }
    const scalar left = volumeLeft();
    const scalar whole = sum(mesh.cellVolumes());

    return
        mag(filled - left) < 1e-9*whole
      ? ""
      : faultText
        (
            "the far field has the volume ", filled, ", layers leave ", left,
            " of the domain"
        );
}


scalarField domainJudge::areasLeft() const
{
    const List<sidePlane>& planes = asked.planes;
    const endedSurface ended
    {
        wall.points, wall.faces, wall.border.edges, wall.border.edgeSides
    };
    const label nSides = wall.border.sides.size();
    const point origin
    (
        pointOn
        (
            List<sidePlane>(SubList<sidePlane>(planes, nSides)),
            boundBox(wall.points, false).centre()
        )
    );
    scalarField areas
    (
        asked.fluidInside ? scalarField(planes.size(), 0) : areasOf(planes)
    );

    for (label i = 0; i < nSides; ++i)
    {
        const point x
        (
            origin - planes[i].distance(origin)*planes[i].normal
        );
        areas[i] -= capArea(ended, planes[i], i, x);
    }

    return areas;
}


label domainJudge::planeOf(const face& f) const
{
    forAll(asked.planes, i)
    {
        bool isIn = true;
        for (const label p : f)
        {
            isIn = isIn
                && mag(asked.planes[i].distance(mesh.points()[p]))
                 < 1e-9*size_;
        }
        if (isIn)
        {
            return i;
        }
    }

    return -1;
}


std::string domainJudge::areaFault() const
{
    const scalarField left(areasLeft());
    scalarField areas(left.size(), 0);

    for
    (
        label patchi = nWallPatches();
        patchi < mesh.boundaryMesh().size();
        ++patchi
    )
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        for (const face& f : patch)
        {
            const label i = planeOf(f);
            if (i < 0 || !asked.planePatches[i].found(patch.name()))
            {
                const point x(f.centre(mesh.points()));

                return faultText
                (
                    "a face of the patch ", patch.name(), " is in ",
                    i < 0 ? "no plane" : "the wrong plane", ", at ",
                    x.x(), ' ', x.y(), ' ', x.z()
                );
            }
            areas[i] += f.mag(mesh.points());
        }
    }

    forAll(left, i)
    {
        if (mag(areas[i] - left[i]) > 1e-9*sqr(size_))
        {
            return faultText
            (
                "patches ", asked.planePatches[i][0], ", ... have the area ",
                areas[i], ", the wall leaves ", left[i]
            );
        }
    }

    return "";
}


std::string domainJudge::sphereFault() const
{
    const farBoundaryControls& sphere = asked.controls.boundary;
    const label patchi = mesh.boundaryMesh().findPatchID("sphere");
    if (patchi < 0 || mesh.boundaryMesh().size() != nWallPatches() + 1)
    {
        return "the patches are not those of the wall and the sphere";
    }

    for (const point& x : mesh.boundaryMesh()[patchi].localPoints())
    {
        if (mag(mag(x - sphere.origin) - sphere.radius) > 1e-9*sphere.radius)
        {
            return "a point of the sphere is not on it";
        }
    }

    return "";
}


std::string domainJudge::fault() const
{
    if (asked.controls.boundary.type == farBoundaryType::sphere)
    {
        return sphereFault();
    }
    // Sections are measured from a point on all sides; parallel ones have none
    const bool isPeriodic = anyOf(wall.border.sides, [](const sidePatch& side)
    {
        return side.type == "cyclic";
    });
    if (isPeriodic || (asked.planes.empty() && wall.border.sides.size()))
    {
        return "";
    }
    const std::string fault(areaFault());

    return fault.size() ? fault : volumeFault();
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

std::string Foam::findDomainFault(const madeFarField& made)
{
    return domainJudge(made).fault();
}


// ************************************************************************* //
