/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldFaults.H"
#include "outerTriangles.H"
#include "planeDomain.H"
#include "polyMesh.H"

#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

namespace
{

template<class... Items>
std::string tell(const Items&... items)
{
    std::ostringstream os;
    os.precision(12);
    (os << ... << items);

    return os.str();
}


class domainJudge
{
    const wallSurface& wall_;
    const prismLayers& layers_;
    const fuzzFarField& asked_;
    const polyMesh& mesh_;

    //- Of the domain
    const scalar size_;

    label nLayerCells() const
    {
        return layers_.faces.size()*layers_.nLayers;
    }

    //- The first patches are those of the wall
    label nWallPatches() const { return layers_.patchNames.size(); }

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

    domainJudge
    (
        const wallSurface& wall,
        const prismLayers& layers,
        const fuzzFarField& asked,
        const polyMesh& mesh
    )
    :
        wall_(wall),
        layers_(layers),
        asked_(asked),
        mesh_(mesh),
        size_(boundBox(mesh.points(), false).mag())
    {}

    std::string fault() const;
};

} // End anonymous namespace


scalar domainJudge::volumeLeft() const
{
    wallSurface outer;
    outer.points = layers_.outerPoints();
    outer.faces = layers_.faces;
    labelList triangleFace;
    const faceList triangles(outerTriangles(outer, triangleFace));
    const endedSurface surface
    {
        outer.points, triangles, layers_.border.edges, layers_.border.edgeSides
    };
    const List<sidePlane> sides
    (
        SubList<sidePlane>(asked_.planes, layers_.border.sides.size())
    );
    const scalar within = volumeOf(surface, sides);

    return asked_.fluidInside ? -within : volumeOf(asked_.planes) - within;
}


std::string domainJudge::volumeFault() const
{
    scalar filled = 0;
    for (label celli = nLayerCells(); celli < mesh_.nCells(); ++celli)
    {
        filled += mesh_.cellVolumes()[celli];
    }
    const scalar left = volumeLeft();
    const scalar whole = sum(mesh_.cellVolumes());

    return
        mag(filled - left) < 1e-9*whole
      ? ""
      : tell
        (
            "the far field has the volume ", filled, ", layers leave ", left,
            " of the domain"
        );
}


scalarField domainJudge::areasLeft() const
{
    const List<sidePlane>& planes = asked_.planes;
    const endedSurface wall
    {
        wall_.points, wall_.faces, wall_.border.edges, wall_.border.edgeSides
    };
    const label nSides = wall_.border.sides.size();
    const point origin
    (
        pointOn
        (
            List<sidePlane>(SubList<sidePlane>(planes, nSides)),
            boundBox(wall_.points, false).centre()
        )
    );
    scalarField areas
    (
        asked_.fluidInside ? scalarField(planes.size(), 0) : areasOf(planes)
    );

    for (label i = 0; i < nSides; ++i)
    {
        const point x
        (
            origin - planes[i].distance(origin)*planes[i].normal
        );
        areas[i] -= capArea(wall, planes[i], i, x);
    }

    return areas;
}


label domainJudge::planeOf(const face& f) const
{
    forAll(asked_.planes, i)
    {
        bool isIn = true;
        for (const label p : f)
        {
            isIn = isIn
                && mag(asked_.planes[i].distance(mesh_.points()[p]))
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
        patchi < mesh_.boundaryMesh().size();
        ++patchi
    )
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        for (const face& f : patch)
        {
            const label i = planeOf(f);
            if (i < 0 || !asked_.planePatches[i].found(patch.name()))
            {
                const point x(f.centre(mesh_.points()));

                return tell
                (
                    "a face of the patch ", patch.name(), " is in ",
                    i < 0 ? "no plane" : "the wrong plane", ", at ",
                    x.x(), ' ', x.y(), ' ', x.z()
                );
            }
            areas[i] += f.mag(mesh_.points());
        }
    }

    forAll(left, i)
    {
        if (mag(areas[i] - left[i]) > 1e-9*sqr(size_))
        {
            return tell
            (
                "patches ", asked_.planePatches[i][0], ", ... have the area ",
                areas[i], ", the wall leaves ", left[i]
            );
        }
    }

    return "";
}


std::string domainJudge::sphereFault() const
{
    const farBoundaryControls& sphere = asked_.controls.boundary;
    const label patchi = mesh_.boundaryMesh().findPatchID("sphere");
    if (patchi < 0 || mesh_.boundaryMesh().size() != nWallPatches() + 1)
    {
        return "the patches are not those of the wall and the sphere";
    }

    for (const point& x : mesh_.boundaryMesh()[patchi].localPoints())
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
    if (asked_.controls.boundary.type == "sphere")
    {
        return sphereFault();
    }
    if (asked_.planes.empty() && wall_.border.sides.size())
    {
        return "";
    }
    const std::string fault(areaFault());

    return fault.size() ? fault : volumeFault();
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

std::string Foam::findDomainFault
(
    const wallSurface& wall,
    const prismLayers& layers,
    const fuzzFarField& asked,
    const polyMesh& mesh
)
{
    return domainJudge(wall, layers, asked, mesh).fault();
}


// ************************************************************************* //
