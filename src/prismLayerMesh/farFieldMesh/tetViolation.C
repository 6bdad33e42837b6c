/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetViolation.H"
#include "faceQuality.H"
#include "farFieldMeshControls.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The triangles of layers and cut
static faceList innerTriangles(const farFieldTets& mesh)
{
    faceList triangles(mesh.outerTriangles);
    triangles.append(mesh.cutTriangles);

    return triangles;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

tetViolation::tetViolation
(
    const neighbourCells& neighbours,
    const farFieldTets& mesh,
    const DynamicList<point>& points,
    const tetEditor& tets
)
:
    inner_(makeTriangleIndex(innerTriangles(mesh))),
    neighbourCells_(neighbours),
    points_(points),
    tets_(tets)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalar tetViolation::ofFace(const label t, const label i) const
{
    const triFace f(tets_[t].face(i));
    const label neighbour = tets_.neighbour(t, i);
    const label triangle = neighbour < 0 ? inner_.lookup(f, -1) : -1;

    if (neighbour < 0 && triangle < 0)
    {
        return 0;
    }

    const point owner(tets_[t].tet(points_).centre());
    const point other
    (
        neighbour < 0
      ? neighbourCells_.centres[triangle]
      : tets_[neighbour].tet(points_).centre()
    );
    const FixedList<point, 3> x({points_[f[0]], points_[f[1]], points_[f[2]]});
    const faceGeometry g(x);
    const scalar toOwner = mag((g.centre - owner) & g.area);
    const scalar toNeighbour = mag((other - g.centre) & g.area);
    const scalar weight =
        min(toOwner, toNeighbour)/(toOwner + toNeighbour + VSMALL);
    const scalar target = farFieldTuned.targetCosine;
    const scalar maxSkewness = farFieldTuned.targetSkewness;
    const scalar volume = neighbour < 0 ? neighbourCells_.volumes[triangle] : 0;
    const scalar ratio = volume > 0 ? tets_[t].tet(points_).mag()/volume : 1;

    return
        pow3(nonOrthoViolation(g.area, other - owner, target)/target)
      + pow3(skewnessViolation(g, x, owner, other, maxSkewness))
      + pow3(max(1 - weight/farFieldTuned.targetWeight, scalar(0)))
      + pow3(max(1 - ratio/farFieldTuned.targetVolumeRatio, scalar(0)));
}


scalar tetViolation::ofTets(const labelUList& tets, const scalar bound) const
{
    scalar sum = 0;

    for (const label t : tets)
    {
        for (label i = 0; i < 4 && sum <= bound; ++i)
        {
            const label neighbour = tets_.neighbour(t, i);
            const bool within = neighbour >= 0 && tets.found(neighbour);

            if (!within || neighbour > t)
            {
                sum += ofFace(t, i);
            }
        }
    }

    return sum;
}


bool tetViolation::missesTargets(const label t, const label i) const
{
    return ofFace(t, i) > farFieldTuned.toleratedViolation;
}

} // End namespace Foam

// ************************************************************************* //
