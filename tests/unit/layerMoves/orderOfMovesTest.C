/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bendColumns.H"
#include "certifyLayers.H"
#include "editedColumns.H"
#include "fitHeights.H"
#include "leanColumns.H"
#include "limitHeightJumps.H"
#include "prismQuality.H"
#include "retreatColumns.H"
#include "unitConversion.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef void (*columnMove)(editedColumns&);

static const labelList changedColumns({2, 3, 7});


static void bendAll(editedColumns& m)
{
    const labelList all(identity(m.nColumns()));
    editedGeometry geometry(m.editor);
    bendTargets targets;
    targets.faces = faceTargets{::cos(degToRad(5.0)), 0.01};
    targets.keep(m.editor, all);

    bendColumns(m.editor, geometry, targets, all, [](label) { return false; });
}


static void fitAll(editedColumns& m)
{
    fitFirstHeights(m.editor, boolList(m.nColumns(), true), 1);
    fitThickness(m.editor);
}


static void limitJumps(editedColumns& m)
{
    limitHeightJumps(m.editor, neighboursOnWall(m.front));
}


static void turnSome(editedColumns& m)
{
    turnColumns(m.editor, changedColumns, m.nTurns);
}


static void leanSome(editedColumns& m)
{
    leanColumns
    (
        m.editor, changedColumns, distanceBeside(m), 10, m.nTries
    );
}


static void retreatSome(editedColumns& m)
{
    retreatColumns(m.editor, changedColumns, squeezeCause::validity);
}


static void growAll(editedColumns& m)
{
    growColumns
    (
        m.editor, identity(m.nColumns()), [](label) { return false; }
    );
}


//- Offsets of a column at the heights that its levels get by another thickness
static vectorField offsetsFor
(
    const editedColumns& m,
    const label c,
    const scalar thickness
)
{
    scalarList heights(m.spacing.nLayers + 1);
    m.spacing.setHeights(c, thickness, heights);
    vectorField offsets(m.spacing.nLayers);
    forAll(offsets, i)
    {
        offsets[i] = m.editor.offsetAt(c, heights[i + 1]);
    }

    return offsets;
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(orderOfMoves, layersCanBeCertifiedAfterAnyOrder)
{
    const std::vector<columnMove> moves
    {
        bendAll, retreatSome, fitAll, growAll, limitJumps, turnSome,
        leanSome
    };
    const label n = moves.size();

    for (const layerFront& front : fronts())
    {
        for (label first = 0; first < n; ++first)
        {
            editedColumns m(front);
            for (label i = 0; i < n; ++i)
            {
                moves[(first + i) % n](m);
            }
            const layerJudge judge
            (
                m.editor.layers(), front.surface, front.visibility, m.controls
            );
            const certification certified(certifyLayers(m.editor, judge));

            EXPECT_TRUE(certified.pointsWithoutHeight.empty()) << first;
            EXPECT_TRUE(certify(m.editor.layers()).valid()) << first;
        }
    }
}


TEST(orderOfMoves, retreatsStartFromWhatOtherMovesPlaced)
{
    for (const layerFront& front : fronts())
    {
        for (const columnMove before : {bendAll, fitAll, limitJumps})
        {
            editedColumns m(front);
            before(m);
            const layerMoveControls& controls = m.controls;
            const label c = changedColumns[0];
            const scalar thickness =
                controls.retreatFactor*m.editor.thickness()[c];
            const vectorField placed(offsetsFor(m, c, thickness));

            retreatSome(m);

            ASSERT_EQ(m.editor.thickness()[c], thickness);
            forAll(placed, i)
            {
                const vector axis
                (
                    m.columns.axisOffset
                    (
                        front.visibility, c, m.editor.heights(c)[i + 1]
                    )
                );
                const vector expected
                (
                    placed[i] + controls.straightenShare*(axis - placed[i])
                );
                EXPECT_NEAR
                (
                    mag(m.editor.offset(c, i + 1) - expected), 0, 1e-12
                );
            }
        }
    }
}


TEST(orderOfMoves, growingStartsFromWhatOtherMovesPlaced)
{
    for (const layerFront& front : fronts())
    {
        for (const columnMove before : {bendAll, fitAll, limitJumps})
        {
            editedColumns m(front);
            retreatSome(m);
            before(m);
            const label c = changedColumns[0];
            const labelList beside(m.editor.columnsBeside(c));
            const scalar thickness =
                m.editor.thickness()[c]/m.controls.retreatFactor;
            const vectorField placed(offsetsFor(m, c, thickness));

            growColumns(m.editor, beside, [](label) { return false; });

            if (m.editor.thickness()[c] == thickness)
            {
                forAll(placed, i)
                {
                    EXPECT_NEAR
                    (
                        mag(m.editor.offset(c, i + 1) - placed[i]), 0, 1e-12
                    );
                }
            }
        }
    }
}


// ************************************************************************* //
