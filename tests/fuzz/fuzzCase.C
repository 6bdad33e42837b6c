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
        else if (what == "farField")
        {
            result_.farField = text;
        }
        else if (what == "refused")
        {
            result_.refused = text;
        }
        else if (what == "cut")
        {
            std::istringstream is(text);
            is  >> result_.cut.n >> result_.cut.maxNonOrtho
                >> result_.cut.minWeight;
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
        [&](pipeWriter& out)
        {
            ::feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);

            meshFuzzCase
            (
                one,
                [&](const std::string& what, const std::string& text)
                {
                    out(what, text);
                    out.flush();
                }
            );
            out(std::string());
        },
        [&](pipeReader& in)
        {
            std::string what, text;
            for (in(what); what.size(); in(what))
            {
                in(text);
                verdict.tell(what, text);
            }
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


// ************************************************************************* //
