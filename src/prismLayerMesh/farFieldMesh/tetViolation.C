/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetViolation.H"
#include "faceQuality.H"
#include "farFieldMeshControls.H"

namespace Foam
{

//- The triangles of layers and cut
static faceList innerTriangles(const farFieldTets& mesh)
{
    faceList triangles(mesh.hasLayers ? mesh.outerTriangles : faceList());
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

scalar tetViolation::ofFace
(
    const FixedList<point, 3>& x,
    const point& centre,
    const scalar volume,
    const acrossFace& other
)
{
    const faceGeometry g(x);
    const scalar toOwner = mag((g.centre - centre) & g.area);
    const scalar toOther = mag((other.centre - g.centre) & g.area);
    const scalar weight = min(toOwner, toOther)/(toOwner + toOther + VSMALL);
    const scalar target = farFieldTuned.targetCosine;
    const scalar maxSkewness = farFieldTuned.targetSkewness;
    const scalar ratio = other.volume > 0 ? volume/other.volume : 1;

    return
        pow3(nonOrthoViolation(g.area, other.centre - centre, target)/target)
      + pow3(skewnessViolation(g, x, centre, other.centre, maxSkewness))
      + pow3(max(1 - weight/farFieldTuned.targetWeight, scalar(0)))
      + pow3(max(1 - ratio/farFieldTuned.targetVolumeRatio, scalar(0)));
}


tetViolation::acrossFace tetViolation::across
(
    const label t,
    const label i
) const
{
    const label neighbour = tets_.neighbour(t, i);
    if (neighbour >= 0)
    {
        return acrossFace{true, tets_[neighbour].tet(points_).centre(), 0};
    }
    const label triangle = inner_.lookup(tets_[t].face(i), -1);
    if (triangle >= 0)
    {
        return acrossFace
        {
            true, neighbourCells_.centres[triangle],
            neighbourCells_.volumes[triangle]
        };
    }

    return acrossFace{false, Zero, 0};
}


scalar tetViolation::ofFace(const label t, const label i) const
{
    const acrossFace other(across(t, i));
    if (!other.isCell)
    {
        return 0;
    }
    const triFace f(tets_[t].face(i));
    const auto tet(tets_[t].tet(points_));

    return ofFace
    (
        {points_[f[0]], points_[f[1]], points_[f[2]]},
        tet.centre(), other.volume > 0 ? tet.mag() : 0, other
    );
}


bool tetViolation::missesTargets(const label t, const label i) const
{
    return ofFace(t, i) > farFieldTuned.toleratedViolation;
}

} // End namespace Foam

// ************************************************************************* //
