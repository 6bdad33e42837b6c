/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "harmonicField.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Solid angle of the triangle that three unit vectors span on the sphere
static scalar solidAngle(const vector& a, const vector& b, const vector& c)
{
    return 2*::atan2
    (
        mag((a ^ b) & c),
        1 + (a & b) + (b & c) + (c & a)
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

tetAreas::tetAreas(const tetPointRef& tet)
{
    const vector ab = tet.b() - tet.a();
    const vector ac = tet.c() - tet.a();
    const vector ad = tet.d() - tet.a();

    normals[0] = ac ^ ad;
    normals[1] = ad ^ ab;
    normals[2] = ab ^ ac;
    sixV = max
    (
        normals[2] & ad,
        harmonicControls::smallestShape*mag(ab)*mag(ac)*mag(ad)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

FixedList<vector, 4> tetAreas::gradients() const
{
    FixedList<vector, 4> gradients;

    for (label i = 1; i < 4; ++i)
    {
        gradients[i] = normals[i - 1]/sixV;
    }
    gradients[0] = -(gradients[1] + gradients[2] + gradients[3]);

    return gradients;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

vectorField tetGradients(const backgroundMesh& mesh, const scalarField& field)
{
    vectorField gradients(mesh.tets.size());

    forAll(mesh.tets, t)
    {
        const FixedList<vector, 4> g(tetAreas(mesh.tet(t)).gradients());

        gradients[t] = Zero;
        for (label i = 0; i < 4; ++i)
        {
            gradients[t] += field[mesh.tets[t][i]]*g[i];
        }
    }

    return gradients;
}


gradientMeans pointGradientMeans
(
    const backgroundMesh& mesh,
    const scalarField& field
)
{
    const vectorField tetGradient(tetGradients(mesh, field));
    const scalarField tetSize(mag(tetGradient));

    gradientMeans means;
    means.gradients.setSize(mesh.points.size(), Zero);
    means.sizes.setSize(mesh.points.size(), 0);
    scalarField angles(mesh.points.size(), 0);

    forAll(mesh.tets, t)
    {
        const tetCell& tet = mesh.tets[t];

        for (label i = 0; i < 4; ++i)
        {
            const point& x = mesh.points[tet[i]];
            const scalar angle = solidAngle
            (
                normalised(mesh.points[tet[(i + 1) % 4]] - x),
                normalised(mesh.points[tet[(i + 2) % 4]] - x),
                normalised(mesh.points[tet[(i + 3) % 4]] - x)
            );

            means.gradients[tet[i]] += angle*tetGradient[t];
            means.sizes[tet[i]] += angle*tetSize[t];
            angles[tet[i]] += angle;
        }
    }

    means.gradients /= max(angles, VSMALL);
    means.sizes /= max(angles, VSMALL);

    return means;
}


vectorField pointGradients(const backgroundMesh& mesh, const scalarField& field)
{
    return pointGradientMeans(mesh, field).gradients;
}

} // End namespace Foam

// ************************************************************************* //
