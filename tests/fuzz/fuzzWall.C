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

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The reason of an error that names a side and what to write; otherwise empty
static std::string reasonOf(const std::string& message)
{
    static const std::string reasons[][3] =
    {
        {"throughSide", "goes through the side plane", "repair stitch"},
        {"beyondSide", "is beyond the side", "repair stitch"},
        {"allBeyondSide", "is all beyond the side", "Move the side out"},
        {"touchesSide", "touches the side", "repair stitch"},
        {"fillsBox", "fills the box", "fluid inside"},
        {"noImage", "its image does not end on", "repair stitch"},
        {"noPartner", "type cyclic has no partner", "on which the wall ends"},
        {"noPartner", "no other side patch of type cyclic", "the wall ends"},
        {"nothingLeft", "Nothing is left", "Move a side out"},
        {"loses", "is not the geometry of the files", "acceptLoss"}
    };

    for (const auto& reason : reasons)
    {
        const auto says = [&](const std::string& words)
        {
            return message.find(words) != std::string::npos;
        };
        if (says(reason[1]) && says(reason[2]))
        {
            return reason[0];
        }
    }

    return "";
}


//- Whether a message says that the wall is not the given surface: stitching
//  cannot undo all damage
static bool tellsOfLoss(const std::string& message)
{
    return
        message.find("is not the geometry of the files") != std::string::npos;
}


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
        if (prepared.defects.size() && one.isAtSides)
        {
            tell("refused", prepared.defects[0].name());
        }
        else if (prepared.defects.size())
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
        const std::string message(oneLine(e.message()));
        const std::string reason(one.isAtSides ? reasonOf(message) : "");
        const bool mayFail =
            one.hasSides()
         || (one.isDamaged() && !mustBeGood && tellsOfLoss(message));
        tell
        (
            reason.size() ? "refused" : mayFail ? "skipped" : "failed",
            reason.size() ? reason : message
        );
    }

    return wallSurface();
}

} // End namespace Foam

// ************************************************************************* //
