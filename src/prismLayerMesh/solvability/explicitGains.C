/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "explicitGains.H"
#include "labelList.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- As surfaceInterpolation of OpenFOAM: the least cosine of the angle between
//  the normal and the line of the centres
static constexpr scalar leastCosine = 0.05;


//- One over the distance of two centres along a normal [1/m]
static scalar inverseAlong(const vector& normal, const vector& d)
{
    return 1/max(max(normal & d, leastCosine*mag(d)), VSMALL);
}


namespace
{

//- Finite volumes as cellGain asks for them
class gainMesh
{
    const finiteVolumes& mesh_;

    //- First face of each cell in the list of faces, and the number of all
    labelList starts_;
    labelList faces_;

    List<schemeFace> schemes_;

    template<class Visit>
    void visitFaces(const Visit& visit) const
    {
        forAll(mesh_.owner, f)
        {
            visit(mesh_.owner[f], f);
            if (f < mesh_.neighbour.size())
            {
                visit(mesh_.neighbour[f], f);
            }
        }
    }

    schemeFace makeScheme(const label f) const
    {
        const vector& area = mesh_.faceAreas[f];
        const point& centre = mesh_.faceCentres[f];
        const point& own = mesh_.cellCentres[owner(f)];

        return neighbour(f) < 0
          ? schemeFace(area, centre, own)
          : schemeFace(area, centre, own, mesh_.cellCentres[neighbour(f)]);
    }

public:

    explicit gainMesh(const finiteVolumes& mesh)
    :
        mesh_(mesh),
        starts_(mesh.cellVolumes.size() + 1, Zero),
        faces_(mesh.owner.size() + mesh.neighbour.size()),
        schemes_(mesh.owner.size())
    {
        visitFaces([&](const label c, label) { ++starts_[c + 1]; });
        for (label c = 1; c < starts_.size(); ++c)
        {
            starts_[c] += starts_[c - 1];
        }
        labelList next(starts_);
        visitFaces([&](const label c, const label f)
        {
            faces_[next[c]++] = f;
        });

        #pragma omp parallel for schedule(static)
        forAll(schemes_, f)
        {
            schemes_[f] = makeScheme(f);
        }
    }

    SubList<label> facesOf(const label c) const
    {
        return SubList<label>(faces_, starts_[c + 1] - starts_[c], starts_[c]);
    }

    label owner(const label f) const { return mesh_.owner[f]; }

    label neighbour(const label f) const
    {
        return f < mesh_.neighbour.size() ? mesh_.neighbour[f] : -1;
    }

    const vector& area(const label f) const { return mesh_.faceAreas[f]; }

    scalar volume(const label c) const { return mesh_.cellVolumes[c]; }

    const schemeFace& scheme(const label f) const { return schemes_[f]; }

    bool seesFaces(const label c) const
    {
        for (const label f : facesOf(c))
        {
            const scalar height = mesh_.faceAreas[f]
              & (mesh_.faceCentres[f] - mesh_.cellCentres[c]);

            if ((owner(f) == c ? height : -height) <= 0)
            {
                return false;
            }
        }

        return mesh_.cellVolumes[c] > 0;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

schemeFace::schemeFace
(
    const vector& area,
    const point& centre,
    const point& ownerCentre,
    const point& neighbourCentre
)
{
    const vector d(neighbourCentre - ownerCentre);
    const scalar magArea = mag(area);
    const vector normal(area/max(magArea, VSMALL));
    const scalar inverse = inverseAlong(normal, d);
    const scalar toOwner = mag(area & (centre - ownerCentre));
    const scalar toNeighbour = mag(area & (neighbourCentre - centre));

    ownerShare = toNeighbour/max(toOwner + toNeighbour, VSMALL);
    implicit = magArea*inverse;
    explicitArea = magArea*(normal - d*inverse);
}


schemeFace::schemeFace
(
    const vector& area,
    const point& centre,
    const point& ownerCentre
)
{
    const scalar magArea = mag(area);

    implicit = magArea
       *inverseAlong(area/max(magArea, VSMALL), centre - ownerCentre);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalarField explicitGains(const finiteVolumes& mesh)
{
    const gainMesh cells(mesh);
    scalarField gains(mesh.cellVolumes.size());

    #pragma omp parallel
    {
        cellGain<gainMesh> gainOf(cells);

        #pragma omp for schedule(dynamic, 1024)
        forAll(gains, c)
        {
            gains[c] = gainOf(c);
        }
    }

    return gains;
}

} // End namespace Foam

// ************************************************************************* //
