/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshFuzzCase.H"
#include "prepareWall.H"
#include "throwingErrors.H"

#include <sstream>

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

std::string oneLine(const std::string& text)
{
    std::istringstream words(text);
    std::string word, line;

    while (words >> word)
    {
        line += (line.empty() ? "" : " ") + word;
    }

    return line;
}


wallSurface prepareFuzzWall
(
    const fuzzCase& one,
    const wallSurface& surface,
    const prismLayerControls& controls,
    const listener& tell
)
{
    const bool mustBeGood =
        one.isAssembly
     || (
            one.isDamaged()
         && one.repair == surfaceRepairControls::method::wrap
        );
    stageObserver observer;
    observer.begin = [&](const word& stage) { tell("stage", stage); };
    const throwingErrors throwing;

    try
    {
        const preparedWall prepared
        (
            prepareWall(surface, controls, PtrList<regionSearch>(), observer)
        );
        if (prepared.defects.size())
        {
            tell
            (
                mustBeGood ? "failed" : "skipped",
                oneLine(describe(prepared.defects))
            );
        }
        else if (prepared.isRemeshed && findWallDefects(prepared.wall).size())
        {
            tell("failed", "defects after the remesh");
        }

        return prepared.wall;
    }
    catch (const Foam::error& e)
    {
        // A plane may cut off all, an end may be curved too far
        tell(one.hasSides() ? "skipped" : "failed", oneLine(e.message()));
    }

    return wallSurface();
}

} // End namespace Foam

// ************************************************************************* //
