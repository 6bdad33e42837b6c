/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "improveStacks.H"
#include "movableColumns.H"
#include "poorStacks.H"
#include "prismQuality.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Columns of which some are lower than they need to be
static void lower(movableColumns& m)
{
    for (label i = 0; i < 4; ++i)
    {
        m.moving.retreat(someColumns(m, 3), squeezeCause::validity);
    }
}


static void improve(movableColumns& m)
{
    improveStacks
    (
        m.moving,
        bestJacobians(m.front.surface, m.front.visibility),
        labelList(m.front.surface.faces.size(), 1)
    );
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(improveStacks, needlessRetreatsAreUndone)
{
    movableColumns m(fronts()[0]);
    const scalarField room(m.moving.room());
    lower(m);
    ASSERT_LT(min(m.moving.room() - room), 0);

    improve(m);

    EXPECT_EQ(m.moving.room(), room);
    EXPECT_FALSE(m.columns.causes.found(squeezeCause::validity));
}


TEST(improveStacks, certifiedLayersStayCertified)
{
    label nCertified = 0;

    for (const layerFront& front : fronts())
    {
        movableColumns m(front);
        lower(m);
        const scalarField room(m.moving.room());

        if (certify(m.moving.layers()).valid())
        {
            ++nCertified;
            improve(m);

            EXPECT_TRUE(certify(m.moving.layers()).valid());
            EXPECT_GE(min(m.moving.room() - room), 0);
        }
    }

    EXPECT_GE(nCertified, 2);
}

// ************************************************************************* //
