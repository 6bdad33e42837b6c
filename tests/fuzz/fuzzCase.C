/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fuzzCase.H"
#include "isolatedProcess.H"
#include "meshFuzzCase.H"

#include <cfenv>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

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

    meshFuzzCase
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

            meshFuzzCase
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
