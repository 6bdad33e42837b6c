/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fuzzCase.H"
#include "embeddingFault.H"
#include "isolatedProcess.H"
#include "meshFaults.H"
#include "prismLayerMesh.H"
#include "wallDefects.H"
#include "wallPointsError.H"

#include <cfenv>
#include <functional>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Told of a case: stage, skipped, failed or noField, and a text
typedef std::function<void(const std::string&, const std::string&)> listener;


//- White space is one blank
static std::string oneLine(const std::string& text)
{
    std::istringstream words(text);
    std::string word, line;

    while (words >> word)
    {
        line += (line.empty() ? "" : " ") + word;
    }

    return line;
}


//- Layers that there must be: the most that any part of the wall asks for
static label nAsked(const layerControls& controls, const layerSpacing& asked)
{
    if (controls.automatic())
    {
        return asked.nLayers;
    }

    label n = controls.heights.nSurfaceLayers;

    for (const patchLayers& entry : controls.patches)
    {
        n = max(n, entry.heights.nSurfaceLayers);
    }
    for (const layerRegion& region : controls.regions)
    {
        n = max(n, region.heights.nSurfaceLayers);
    }

    // It may be that no point is left to those who ask for the most
    return min(n, max(asked.layersAsked));
}


static void mesh
(
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights& local,
    const listener& tell
)
{
    const prismLayerMesh m
    (
        makePrismLayerMesh
        (
            wall,
            controls,
            local,
            stageObserver
            {
                [&](const word& stage) { tell("stage", stage); },
                [](const string&) {}
            }
        )
    );

    tell("stage", "checks");

    if (m.fields.failure.size())
    {
        tell("noField", oneLine(m.fields.failure));
    }

    const std::string fault(findMeshFault(wall, m.made.layers));
    const std::string embedding(findEmbeddingFault(wall, m.made.layers));

    if (!m.certificate.valid())
    {
        tell("failed", "the certificate is not valid");
    }
    else if (m.made.layers.nLayers != nAsked(controls.layers, m.request))
    {
        tell("failed", "the number of layers is not what was asked for");
    }
    else if (fault.size() || embedding.size())
    {
        tell("failed", oneLine(fault + embedding));
    }
}


//- Gives the wall new triangles; what was said of its old points is forgotten
static void remesh
(
    const fuzzCase& one,
    wallSurface& wall,
    prismLayerControls& controls,
    localHeights& local,
    const listener& tell
)
{
    tell("stage", "remesh");
    controls.layers.regions.clear();
    local = localHeights();
    wall = one.remeshed(wall);
    tell(findWallDefects(wall).empty() ? "stage" : "failed", "defects");
}


static void makeAndMesh(const fuzzCase& one, const listener& tell)
{
    FatalError.throwExceptions();
    FatalIOError.throwExceptions();

    wallSurface wall;
    prismLayerControls controls;
    localHeights local;

    try
    {
        tell("stage", "surface");
        one.make(wall, controls, local);
        const List<wallDefect> defects
        (
            findWallDefects(wall, wall.border.sides.size())
        );

        if (defects.size())
        {
            tell("skipped", oneLine(describe(defects)));
            return;
        }
    }
    catch (const Foam::error& e)
    {
        // Of the polygon of a prism
        tell("skipped", oneLine(e.message()));
        return;
    }

    try
    {
        if (one.isRemeshed && wall.border.sides.empty())
        {
            remesh(one, wall, controls, local, tell);
        }
        mesh(wall, controls, local, tell);
    }
    catch (const wallPointsError& e)
    {
        // In a knife edge between wall and side patch there may be no layers
        const Map<labelPair> border(wall.border.pointSides());
        const bool onBorder = std::all_of
        (
            e.labels().begin(), e.labels().end(),
            [&](const label p) { return border.found(p); }
        );
        tell(onBorder ? "skipped" : "failed", oneLine(e.message()));
    }
    catch (const Foam::error& e)
    {
        tell("failed", oneLine(e.message()));
    }
    catch (const std::exception& e)
    {
        tell("failed", "exception: " + oneLine(e.what()));
    }
}


//- What is told, as lines to a process and from there
static void send
(
    std::FILE* out,
    const std::string& what,
    const std::string& text
)
{
    std::fputs((what + ' ' + text + '\n').c_str(), out);
    std::fflush(out);
}


static void receive(std::FILE* in, const listener& tell)
{
    std::string line;

    for (int c; (c = std::fgetc(in)) != EOF;)
    {
        if (c != '\n')
        {
            line += char(c);
            continue;
        }

        const std::size_t blank = line.find(' ');
        tell(line.substr(0, blank), line.substr(blank + 1));
        line.clear();
    }
}


//- The result that is told
class verdictListener
{
    fuzzResult& result_;
    std::string stage_;


public:

    explicit verdictListener(fuzzResult& result)
    :
        result_(result)
    {
        result_.what = fuzzResult::verdict::passed;
    }

    void tell(const std::string& what, const std::string& text)
    {
        if (what == "stage")
        {
            stage_ = text;
        }
        else if (what == "noField")
        {
            result_.noField = text;
        }
        else
        {
            result_.what =
                what == "skipped"
              ? fuzzResult::verdict::skipped
              : fuzzResult::verdict::failed;
            result_.cause = stage_ + ": " + text;
        }
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::fuzzResult Foam::runHere(const fuzzCase& one)
{
    fuzzResult result;
    verdictListener verdict(result);

    makeAndMesh
    (
        one,
        [&](const std::string& what, const std::string& text)
        {
            Info<< what.c_str() << ' ' << text.c_str() << endl;
            verdict.tell(what, text);
        }
    );

    return result;
}


Foam::fuzzResult Foam::run(const fuzzCase& one, const unsigned cpuSeconds)
{
    fuzzResult result;
    verdictListener verdict(result);

    const processEnd end = isolatedProcess
    (
        [&](std::FILE* out)
        {
            ::feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);

            makeAndMesh
            (
                one,
                [&](const std::string& what, const std::string& text)
                {
                    send(out, what, text);
                }
            );
        },
        [&](std::FILE* in)
        {
            receive
            (
                in,
                [&](const std::string& what, const std::string& text)
                {
                    verdict.tell(what, text);
                }
            );
            return true;
        },
        cpuSeconds
    );

    if (end == processEnd::failed)
    {
        verdict.tell("failed", "crashed");
    }
    else if (end == processEnd::tooLong)
    {
        std::ostringstream why;
        why << "took more than " << cpuSeconds << " s";
        verdict.tell("failed", why.str());
    }

    return result;
}


bool Foam::writeSurface(const fuzzCase& one, const fileName& file)
{
    return isolatedProcess
    (
        [&](std::FILE*)
        {
            wallSurface wall;
            prismLayerControls controls;
            localHeights local;
            one.make(wall, controls, local);

            const layerControls& layers = controls.layers;
            std::FILE* out = std::fopen(file.c_str(), "w");

            std::fprintf
            (
                out,
                "# nSurfaceLayers %d; firstLayerThickness %.17g;"
                " expansionRatio %.17g;\n",
                layers.heights.nSurfaceLayers,
                layers.heights.firstLayerThickness,
                layers.heights.expansionRatio
            );

            for (const patchLayers& other : layers.patches)
            {
                std::fprintf
                (
                    out,
                    "# patches { %s { firstLayerThickness %.17g; } }\n",
                    other.patches.c_str(),
                    other.heights.firstLayerThickness
                );
            }

            for (const point& p : wall.points)
            {
                std::fprintf(out, "v %.17g %.17g %.17g\n", p.x(), p.y(), p.z());
            }

            forAll(wall.faces, i)
            {
                const word& patch = wall.patchNames[wall.patchIDs[i]];
                std::fprintf(out, "g %s\nf", patch.c_str());

                for (const label p : wall.faces[i])
                {
                    std::fprintf(out, " %d", p + 1);
                }
                std::fprintf(out, "\n");
            }

            std::fclose(out);
        },
        [](std::FILE*) { return true; },
        60
    ) == processEnd::complete;
}


// ************************************************************************* //
