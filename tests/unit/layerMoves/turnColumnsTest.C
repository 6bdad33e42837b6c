/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "editedColumns.H"
#include "leanColumns.H"

#include <gtest/gtest.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(turnColumns, turnThreeTimesAtMost)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        label n = 0;

        while (n < 100 && turnColumns(m.editor, labelList(1, 3), m.nTurns))
        {
            ++n;
        }

        EXPECT_EQ(n, 3);
    }
}


TEST(turnColumns, movedFacesAreThoseAroundColumnsThatTurn)
{
    for (const layerFront& front : fronts())
    {
        editedColumns m(front);
        const label now = m.editor.now();

        turnColumns(m.editor, labelList(1, 3), m.nTurns);
        labelList columns(front.addressing.pointPoints[3]);
        columns.append(3);

        const labelList faces(facesOf(m, columns));
        EXPECT_EQ(m.editor.touchedSince(now), faces);
    }
}


// ************************************************************************* //
