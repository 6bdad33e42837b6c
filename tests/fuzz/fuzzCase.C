/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fuzzCase.H"
#include "equalPoints.H"
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


//- A face, after those of its points that are not written yet
static void writeFace
(
    std::FILE* out,
    const Foam::word& patch,
    const Foam::pointField& points,
    Foam::equalPoints& labels,
    Foam::label& nPoints
)
{
    for (const Foam::point& x : points)
    {
        if (labels.insert(x, nPoints))
        {
            std::fprintf(out, "v %.17g %.17g %.17g\n", x.x(), x.y(), x.z());
            ++nPoints;
        }
    }

    std::fprintf(out, "g %s\nf", patch.c_str());
    for (const Foam::point& x : points)
    {
        std::fprintf(out, " %d", labels.find(x) + 1);
    }
    std::fprintf(out, "\n");
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

            equalPoints labels;
            label nPoints = 0;
            forAll(wall.faces, i)
            {
                writeFace
                (
                    out, wall.patchNames[wall.patchIDs[i]],
                    pointField(wall.points, wall.faces[i]), labels, nPoints
                );
            }
            for (const sidePatch& side : wall.border.sides)
            {
                for (const face& f : side.faces)
                {
                    writeFace
                    (
                        out, side.name, f.points(side.points), labels, nPoints
                    );
                }
            }

            std::fclose(out);
        },
        [](std::FILE*) { return true; },
        60
    ) == processEnd::complete;
}


// ************************************************************************* //
