/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "editedColumns.H"
#include "improveLayers.H"
#include "prismQuality.H"
#include "retreatColumns.H"

#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

using namespace Foam;

//- Columns of which some are lower than they need to be
static void lower(editedColumns& m)
{
    for (label i = 0; i < 4; ++i)
    {
        retreatColumns(m.editor, someColumns(m, 3), squeezeCause::validity);
    }
}


static void improve(editedColumns& m)
{
    const layerJudge judge
    (
        m.editor.layers(), m.front.surface, m.front.visibility, m.controls
    );
    improveLayers(m.editor, judge);
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(improveLayers, needlessRetreatsAreUndone)
{
    editedColumns m(fronts()[0]);
    const scalarField thickness(m.editor.thickness());
    lower(m);
    ASSERT_LT(min(m.editor.thickness() - thickness), 0);

    improve(m);

    EXPECT_EQ(m.editor.thickness(), thickness);
    EXPECT_FALSE(m.editor.causes().found(squeezeCause::validity));
}


TEST(improveLayers, certifiedLayersStayCertified)
{
    label nCertified = 0;

    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        lower(m);
        const scalarField thickness(m.editor.thickness());

        if (certify(m.editor.layers()).valid())
        {
            ++nCertified;
            improve(m);

            EXPECT_TRUE(certify(m.editor.layers()).valid());
            EXPECT_GE(min(m.editor.thickness() - thickness), 0);
        }
    }

    EXPECT_GE(nCertified, 2);
}

// ************************************************************************* //
