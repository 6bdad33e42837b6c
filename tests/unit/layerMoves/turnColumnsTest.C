/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "editedColumns.H"
#include "turnColumns.H"

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
