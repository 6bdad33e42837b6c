/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wedgeMesh.H"
#include "meshCertificate.H"
#include "ListOps.H"
#include "polyhedralMesh.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A point is on the axis if its distance from the axis is at most this share
//  of the largest distance
static constexpr scalar axisShare = 1e-9;


//- A mesh of two dimensions while it becomes a wedge
class planarMesh
{
    const planarControls& controls_;
    const polyMesh& mesh_;
    const scalar largestRadius_;

    scalar radius(const point& x) const
    {
        return x[controls_.directions().second()];
    }

    //- Distance along the normal, from the first side to the second one
    scalar across(const point& x) const { return x & controls_.normal; }

    bool isOnAxis(const label p) const
    {
        return mag(radius(mesh_.points()[p])) <= axisShare*largestRadius_;
    }

public:

    planarMesh(const planarControls& controls, const polyMesh& mesh)
    :
        controls_(controls),
        mesh_(mesh),
        largestRadius_
        (
            max
            (
                mesh.points().component(controls.directions().second())
            )
        )
    {}


    //- The point that each point becomes: on the axis, a point of the second
    //  side becomes the point across. The other points stay.
    labelList mergedPoints() const
    {
        labelList merged(identity(mesh_.nPoints()));
        for (const face& f : mesh_.faces())
        {
            for (const edge& e : f.edges())
            {
                const scalar way =
                    across(mesh_.points()[e.end()])
                  - across(mesh_.points()[e.start()]);
                if
                (
                    way > 0.5*controls_.thickness
                 && isOnAxis(e.start()) && isOnAxis(e.end())
                )
                {
                    merged[e.end()] = e.start();
                }
            }
        }

        return merged;
    }


    point turned(const label p) const
    {
        const point& x = mesh_.points()[p];
        const scalar r = isOnAxis(p) ? 0 : radius(x);
        if (r < 0)
        {
            FatalErrorInFunction
                << "The point " << x << " is beyond the axis of the wedge" << nl
                << "Move the curve to one side of the axis" << exit(FatalError);
        }

        const scalar half = 0.5*controls_.wedgeAngle;
        const scalar side = across(x) > 0.5*controls_.thickness ? 1 : -1;
        point y(side*r*::sin(half)*controls_.normal);
        const labelPair in(controls_.directions());
        y[in.first()] = x[in.first()];
        y[in.second()] = r*::cos(half);

        return y;
    }
};


//- A face in which no point follows itself
face withoutRepeats(const face& f)
{
    DynamicList<label> points(f.size());
    forAll(f, k)
    {
        if (f[k] != f.prevLabel(k))
        {
            points.append(f[k]);
        }
    }

    return face(points);
}


void requirePositive(const polyMesh& mesh)
{
    const polyhedralMesh cells
    (
        mesh.points(), mesh.faces(), mesh.faceOwner(), mesh.faceNeighbour()
    );
    const meshCertificate certificate
    (
        certifyMesh(cells, labelList(), labelList())
    );
    if (certificate.invalidCells.size())
    {
        FatalErrorInFunction
            << certificate.invalidCells.size()
            << " cells of the wedge are not positive, the first at "
            << cells.centre(certificate.invalidCells[0]) << exit(FatalError);
    }
}


//- Sets the patches. A patch of type empty becomes a wedge. A patch without
//  faces goes.
void setPatches
(
    const labelUList& sizes,
    const labelUList& starts,
    polyMesh& mesh
)
{
    const polyBoundaryMesh& old = mesh.boundaryMesh();
    List<polyPatch*> patches;
    forAll(old, patchi)
    {
        if (sizes[patchi] == 0)
        {
            continue;
        }
        OStringStream text;
        old[patchi].write(text);
        IStringStream entries(text.str());
        dictionary patch(entries);
        patch.set("nFaces", sizes[patchi]);
        patch.set("startFace", starts[patchi]);
        if (old[patchi].type() == "empty")
        {
            patch.set("type", word("wedge"));
        }
        patches.append
        (
            polyPatch::New(old[patchi].name(), patch, patches.size(), old)
                .ptr()
        );
    }
    mesh.removeBoundary();
    mesh.addPatches(patches);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void makeWedge(const planarControls& controls, polyMesh& mesh)
{
    const planarMesh planar(controls, mesh);
    const labelList merged(planar.mergedPoints());
    labelList newPoints(mesh.nPoints());
    autoPtr<pointField> points(new pointField(mesh.nPoints()));
    label nPoints = 0;
    forAll(merged, p)
    {
        if (merged[p] == p)
        {
            points()[nPoints] = planar.turned(p);
            newPoints[p] = nPoints++;
        }
    }
    points().setSize(nPoints);

    DynamicList<face> faces(mesh.nFaces());
    DynamicList<label> owner(mesh.nFaces());
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    labelList sizes(patches.size(), Zero);
    labelList starts(patches.size());
    forAll(mesh.faces(), f)
    {
        const label patchi = patches.whichPatch(f);
        face turned(mesh.faces()[f]);
        for (label& p : turned)
        {
            p = newPoints[merged[p]];
        }
        turned = withoutRepeats(turned);
        if (patchi >= 0 && sizes[patchi] == 0)
        {
            starts[patchi] = faces.size();
        }
        if (turned.size() > 2)
        {
            faces.append(turned);
            owner.append(mesh.faceOwner()[f]);
            if (patchi >= 0)
            {
                ++sizes[patchi];
            }
        }
    }

    const fileName instance(mesh.facesInstance());
    mesh.resetPrimitives
    (
        std::move(points), autoPtr<faceList>(new faceList(std::move(faces))),
        autoPtr<labelList>(new labelList(std::move(owner))),
        autoPtr<labelList>(new labelList(mesh.faceNeighbour())),
        sizes, starts, false
    );
    mesh.setInstance(instance);
    setPatches(sizes, starts, mesh);
    requirePositive(mesh);
}

} // End namespace Foam

// ************************************************************************* //
