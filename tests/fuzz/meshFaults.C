/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshFaults.H"
#include "faultText.H"
#include "boundBox.H"
#include "coneVolume.H"
#include "ListOps.H"
#include "prismPolyMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

class cellMesh
{
    const wallSurface& wall_;
    const prismLayers& layers_;
    const pointField points_;
    const polyMeshTopology mesh_;
    labelListList cells_;


    bool pointsInto(const label facei, const label celli) const
    {
        return mesh_.owner[facei] != celli;
    }

    //- Sides of the faces are there once in each direction
    bool isClosed(label celli) const;

    //- Sum of the area vectors, over that of their magnitudes
    scalar openness(label celli) const;

    //- Times six
    long double volume(label celli) const;

    //- Times three, as OpenFOAM's solvers have it: of warped faces only the
    //  area vector and the centre
    scalar solverVolume(label celli) const;

    //- The face of a cell that has no point in common with another one; -1
    //  unless there is exactly one
    label opposite(label celli, label facei) const;

    //- Layers on a face of the wall up to the outer surface; -1 where they do
    //  not get there
    label nLayers(label facei) const;

    bool onOuter(const label facei) const
    {
        const label patchi = wall_.patchNames.size();
        const label start = mesh_.patchStarts[patchi];

        return facei >= start && facei < start + mesh_.patchSizes[patchi];
    }


public:

    cellMesh(const wallSurface& wall, const prismLayers& layers);

    std::string cellFault() const;

    std::string stackFault() const;

    std::string volumeFault() const;
};


cellMesh::cellMesh(const wallSurface& wall, const prismLayers& layers)
:
    wall_(wall),
    layers_(layers),
    points_(layers.meshPoints()),
    mesh_(makePrismTopology(layers)),
    cells_(invertOneToMany(max(mesh_.owner) + 1, mesh_.owner))
{
    forAll(mesh_.neighbour, facei)
    {
        cells_[mesh_.neighbour[facei]].append(facei);
    }
}


bool cellMesh::isClosed(const label celli) const
{
    DynamicList<labelPair> sides, reversed;

    for (const label facei : cells_[celli])
    {
        const face& f = mesh_.faces[facei];

        forAll(f, i)
        {
            const bool flip = pointsInto(facei, celli);
            const labelPair side(f[i], f.nextLabel(i));
            (flip ? reversed : sides).append(side);
            (flip ? sides : reversed).append(labelPair(side.second(), f[i]));
        }
    }

    Foam::sort(sides);
    Foam::sort(reversed);

    for (label i = 1; i < sides.size(); ++i)
    {
        if (sides[i] == sides[i - 1])
        {
            return false;
        }
    }

    return sides == reversed;
}


scalar cellMesh::openness(const label celli) const
{
    vector sum(Zero);
    scalar magnitude = VSMALL;
    scalar rounding = 0;

    for (const label facei : cells_[celli])
    {
        const face& f = mesh_.faces[facei];
        const vector area(f.areaNormal(points_));
        sum += pointsInto(facei, celli) ? -area : area;
        magnitude += mag(area);

        // Its centre is rounded as its coordinates are
        for (const edge& e : f.edges())
        {
            rounding += e.mag(points_)*1e-15*mag(points_[e.start()]);
        }
    }

    return max(mag(sum) - rounding, scalar(0))/magnitude;
}


long double cellMesh::volume(const label celli) const
{
    const labelList& faces = cells_[celli];
    const point& origin = points_[mesh_.faces[faces[0]][0]];
    long double sum = 0;

    for (const label facei : faces)
    {
        const long double cone =
            coneVolume(mesh_.faces[facei], points_, origin);
        sum += pointsInto(facei, celli) ? -cone : cone;
    }

    return sum;
}


scalar cellMesh::solverVolume(const label celli) const
{
    const labelList& faces = cells_[celli];
    point origin(Zero);
    for (const label facei : faces)
    {
        origin += mesh_.faces[facei].centre(points_)/scalar(faces.size());
    }
    scalar sum = 0;

    for (const label facei : faces)
    {
        const face& f = mesh_.faces[facei];
        const scalar cone =
            f.areaNormal(points_) & (f.centre(points_) - origin);
        sum += pointsInto(facei, celli) ? -cone : cone;
    }

    return sum;
}


label cellMesh::opposite(const label celli, const label facei) const
{
    label found = -1;

    for (const label other : cells_[celli])
    {
        bool apart = true;

        for (const label p : mesh_.faces[other])
        {
            apart = apart && !mesh_.faces[facei].found(p);
        }

        if (apart && found >= 0)
        {
            return -1;
        }
        else if (apart)
        {
            found = other;
        }
    }

    return found;
}


label cellMesh::nLayers(label facei) const
{
    label celli = mesh_.owner[facei];

    for (label n = 1; n <= layers_.nLayers; ++n)
    {
        facei = opposite(celli, facei);

        if (facei < 0 || onOuter(facei))
        {
            return facei < 0 ? -1 : n;
        }
        else if (facei >= mesh_.neighbour.size())
        {
            return -1;
        }

        celli =
            mesh_.owner[facei] == celli
          ? mesh_.neighbour[facei]
          : mesh_.owner[facei];
    }

    return -1;
}


std::string cellMesh::cellFault() const
{
    // Of the area that rounding of the coordinates leaves
    const scalar tolerance = 1e-9;

    forAll(cells_, celli)
    {
        if (!isClosed(celli) || openness(celli) > tolerance)
        {
            return faultText("cell ", celli, " is not closed");
        }

        const scalar threefold = solverVolume(celli);

        if (!(threefold > 0))
        {
            return faultText("cell ", celli, " has the volume ", threefold/3);
        }
    }

    return "";
}


std::string cellMesh::stackFault() const
{
    const label nWall = mesh_.patchStarts[wall_.patchNames.size()]
      - mesh_.patchStarts[0];

    if (nWall != wall_.faces.size())
    {
        return faultText(nWall, " faces on the wall, not ", wall_.faces.size());
    }

    for (label i = 0; i < nWall; ++i)
    {
        const label n = nLayers(mesh_.patchStarts[0] + i);

        if (n != layers_.nLayers)
        {
            return faultText("face ", i, " of the wall has ", n, " layers");
        }
    }

    return "";
}


std::string cellMesh::volumeFault() const
{
    const point& origin = wall_.points[0];

    // The outer surface, and sides after it
    long double between = -coneVolume(wall_.faces, wall_.points, origin);
    for
    (
        label patchi = wall_.patchNames.size();
        patchi < mesh_.patchSizes.size();
        ++patchi
    )
    {
        const SubList<face> faces
        (
            mesh_.faces, mesh_.patchSizes[patchi], mesh_.patchStarts[patchi]
        );
        between += coneVolume(faces, points_, origin);
    }

    long double filled = 0;
    forAll(cells_, celli)
    {
        filled += volume(celli);
    }

    // Coordinates are exact: only sums and products round
    const scalar tolerance = 1e-13*pow3(boundBox(points_, false).mag());

    if (!(std::abs(filled - between) < tolerance))
    {
        return faultText
        (
            "cells fill ", filled/6, ", between wall and outer surface is ",
            between/6
        );
    }

    return "";
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

std::string Foam::findMeshFault
(
    const wallSurface& wall,
    const prismLayers& layers
)
{
    const cellMesh mesh(wall, layers);

    for
    (
        const std::string& fault
      : {mesh.cellFault(), mesh.stackFault(), mesh.volumeFault()}
    )
    {
        if (fault.size())
        {
            return fault;
        }
    }

    return "";
}


// ************************************************************************* //
