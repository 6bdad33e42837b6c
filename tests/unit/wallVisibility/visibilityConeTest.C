/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallVisibility.H"
#include "Random.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

static vector unit(const scalar x, const scalar y, const scalar z)
{
    return normalised(vector(x, y, z));
}


//- Normals at an angle [rad] to the z axis
static vectorField circle(const label n, const scalar angle)
{
    vectorField normals(n);

    forAll(normals, i)
    {
        const scalar phi = degToRad(360.0*i/n);
        normals[i] = vector
        (
            std::sin(angle)*std::cos(phi),
            std::sin(angle)*std::sin(phi),
            std::cos(angle)
        );
    }

    return normals;
}


//- Unit normals that have at least the given z
static vectorField randomNormals
(
    const label n,
    const scalar lowest,
    Random& random
)
{
    DynamicList<vector> normals;

    while (normals.size() < n)
    {
        const vector v(2*random.sample01<vector>() - vector::one);

        if (magSqr(v) > 0.01 && magSqr(v) < 1 && v.z() > lowest*mag(v))
        {
            normals.append(normalised(v));
        }
    }

    return vectorField(std::move(normals));
}


static scalar smallest(const UList<vector>& normals, const vector& d)
{
    scalar s = GREAT;

    for (const vector& n : normals)
    {
        s = min(s, n & d);
    }

    return s;
}


//- The largest gain of smallest() over steps of all sizes and directions from
//  the axis. That function is concave in d: what is a maximum among its
//  neighbours is one among all.
static scalar largestGain
(
    const visibilityCone& cone,
    const UList<vector>& normals
)
{
    const vector a(normalised(cone.axis ^ vector(0.36, 0.48, 0.8)));
    const vector b(cone.axis ^ a);
    scalar gain = -GREAT;

    for (scalar size = 1; size > 1e-6; size *= 0.3)
    {
        for (label i = 0; i < 90; ++i)
        {
            const scalar phi = degToRad(4.0*i);
            const vector d
            (
                cone.axis + size*(std::cos(phi)*a + std::sin(phi)*b)
            );
            gain = max(gain, smallest(normals, normalised(d)) - cone.cosine);
        }
    }

    return gain;
}


static bool isEmpty(const List<vector>& normals)
{
    return makeVisibilityCone(normals).empty();
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(visibilityCone, oneNormalIsItsAxis)
{
    const vector n(unit(1, -2, 3));
    const visibilityCone cone(makeVisibilityCone(vectorField({n})));

    EXPECT_NEAR(mag(cone.axis - n), 0, 1e-15);
    EXPECT_NEAR(cone.cosine, 1, 1e-15);
}


TEST(visibilityCone, axisOfTwoNormalsBisects)
{
    for (const scalar degrees : {1.0, 60.0, 90.0, 150.0, 179.0})
    {
        const scalar half = 0.5*degToRad(degrees);
        const vectorField normals
        ({
            vector(std::sin(half), 0, std::cos(half)),
            vector(-std::sin(half), 0, std::cos(half))
        });
        const visibilityCone cone(makeVisibilityCone(normals));

        // Rounding of the normals over the cosine
        EXPECT_NEAR(mag(cone.axis - vector(0, 0, 1)), 0, 1e-13);
        EXPECT_NEAR(cone.cosine, std::cos(half), 1e-15);
    }
}


TEST(visibilityCone, axisOfCubeCornerIsItsDiagonal)
{
    const visibilityCone cone
    (
        makeVisibilityCone
        (
            vectorField({vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)})
        )
    );

    EXPECT_NEAR(mag(cone.axis - unit(1, 1, 1)), 0, 1e-15);
    EXPECT_NEAR(cone.cosine, 1/std::sqrt(3.0), 1e-15);
}


TEST(visibilityCone, axisOfCircleIsItsAxis)
{
    for (const scalar degrees : {1.0, 45.0, 89.0, 89.99})
    {
        const scalar angle = degToRad(degrees);
        const visibilityCone cone(makeVisibilityCone(circle(50, angle)));

        // The nearest point is found to 1e-14 of its square
        EXPECT_NEAR(cone.cosine, std::cos(angle), 1e-9);
        EXPECT_NEAR(mag(cone.axis - vector(0, 0, 1)), 0, 1e-6);
    }
}


TEST(visibilityCone, redundantNormalsDoNotMatter)
{
    Random random(1);
    vectorField normals(circle(3, degToRad(70.0)));
    const visibilityCone alone(makeVisibilityCone(normals));

    for (label i = 0; i < 50; ++i)
    {
        const vector w(random.sample01<vector>());
        normals.append
        (
            normalised(w[0]*normals[0] + w[1]*normals[1] + w[2]*normals[2])
        );
    }
    const visibilityCone all(makeVisibilityCone(normals));

    EXPECT_NEAR(mag(all.axis - alone.axis), 0, 1e-12);
    EXPECT_NEAR(all.cosine, alone.cosine, 1e-12);
}


TEST(visibilityCone, orderDoesNotMatter)
{
    Random random(2);
    vectorField normals(randomNormals(12, 0.1, random));
    const visibilityCone first(makeVisibilityCone(normals));

    for (label i = 0; i < 12; ++i)
    {
        inplaceRotateList(normals, 1);
        const visibilityCone cone(makeVisibilityCone(normals));

        EXPECT_NEAR(mag(cone.axis - first.axis), 0, 1e-12);
    }
}


TEST(visibilityCone, noDirectionIsMoreNormal)
{
    Random random(3);

    for (label i = 0; i < 300; ++i)
    {
        const scalar lowest = 0.5*sqr(random.sample01<scalar>());
        const vectorField normals(randomNormals(3 + i % 20, lowest, random));
        const visibilityCone cone(makeVisibilityCone(normals));

        ASSERT_FALSE(cone.empty());
        EXPECT_NEAR(mag(cone.axis), 1, 1e-14);
        EXPECT_NEAR(smallest(normals, cone.axis), cone.cosine, 1e-15);

        // Steps of 1e-6 change what is stationary by 1e-12
        EXPECT_LT(largestGain(cone, normals), 1e-12);
    }
}


TEST(visibilityCone, narrowConeIsNotEmpty)
{
    for (const scalar cosine : {1e-3, 1e-5, 1e-7})
    {
        const visibilityCone cone
        (
            makeVisibilityCone
            (
                vectorField
                ({
                    unit(1, 0, cosine), unit(-1, 0, cosine), unit(0, 1, 1)
                })
            )
        );

        ASSERT_FALSE(cone.empty());
        EXPECT_NEAR(cone.cosine/cosine, 1, 1e-2);
    }
}


TEST(visibilityCone, oppositeNormalsSeeNothing)
{
    EXPECT_TRUE(isEmpty({unit(1, 2, 3), unit(-1, -2, -3)}));
    EXPECT_TRUE(isEmpty({unit(1, 0, 0), unit(-1, 0, 0), unit(0, 0, 1)}));
}


TEST(visibilityCone, saddleCornerSeesNothing)
{
    EXPECT_TRUE
    (
        isEmpty
        ({
            unit(1, 0, 0.3), unit(0, 1, -0.3),
            unit(-1, 0, 0.3), unit(0, -1, -0.3)
        })
    );
}


TEST(visibilityCone, originInsideHullSeesNothing)
{
    EXPECT_TRUE
    (
        isEmpty
        ({
            unit(1, 1, 1), unit(1, -1, -1), unit(-1, 1, -1), unit(-1, -1, 1)
        })
    );

    Random random(4);
    for (label i = 0; i < 50; ++i)
    {
        EXPECT_TRUE(isEmpty(randomNormals(60, -1, random)));
    }
}


TEST(visibilityCone, halfTurnOfCoplanarNormalsSeesNothing)
{
    EXPECT_TRUE(isEmpty(circle(3, degToRad(90.0))));
    EXPECT_TRUE(isEmpty(circle(7, degToRad(90.0))));
}


TEST(visibilityCone, axisOfEmptyConeIsUnit)
{
    const visibilityCone cone
    (
        makeVisibilityCone
        (
            vectorField({unit(1, 0, 0), unit(-1, 0, 0), unit(0, 0, 1)})
        )
    );

    EXPECT_EQ(cone.cosine, 0);
    EXPECT_NEAR(mag(cone.axis - vector(0, 0, 1)), 0, 1e-15);
}


// ************************************************************************* //
