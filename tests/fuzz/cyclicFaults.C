/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cyclicFaults.H"
#include "cyclicPolyPatch.H"

#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Whether a face is another one, moved, seen from the other side
static bool isImage
(
    const pointField& x,
    const face& first,
    const face& second,
    const vector& move
)
{
    const label n = first.size();
    if (second.size() != n)
    {
        return false;
    }

    const scalar tolerance = 1e-10*mag(x[first[1]] - x[first[0]]);
    for (label k = 0; k < n; ++k)
    {
        if (mag(x[first[k]] + move - x[second[(n - k) % n]]) > tolerance)
        {
            return false;
        }
    }

    return true;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

std::string Foam::findCyclicFault(const polyMesh& mesh)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const auto* first = isA<cyclicPolyPatch>(patch);
        if (!first || !first->owner())
        {
            continue;
        }

        const polyPatch& second = first->neighbPatch();
        bool isFault = patch.size() != second.size();
        vector move(Zero);
        forAll(patch, i)
        {
            if (isFault)
            {
                break;
            }
            if (i == 0)
            {
                // Along the common normal
                const vector normal(patch.faceNormals()[0]);
                move = (
                    (
                        mesh.points()[second[0][0]]
                      - mesh.points()[patch[0][0]]
                    ) & normal
                )*normal;
            }
            isFault = !isImage(mesh.points(), patch[i], second[i], move);
        }
        if (isFault)
        {
            std::ostringstream os;
            os  << "faces of " << patch.name() << " and " << second.name()
                << " do not match";

            return os.str();
        }
    }

    return std::string();
}


// ************************************************************************* //
