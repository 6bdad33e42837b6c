/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "refuseRun.H"
#include "argList.H"
#include "OSspecific.H"
#include "parallelRun.H"
#include "polyMesh.H"
#include "prismCase.H"
#include "throwingErrors.H"

#include <new>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Writes refused.json, says the error as OpenFOAM does, and ends the run with
//  the status of the refusal
[[noreturn]] static void refuse
(
    const argList& args,
    const Time& time,
    const stageLog& log,
    const Foam::error& failure
)
{
    const label nStages = log.costs().size();
    const refusal what
    (
        refusalOf(failure, nStages ? log.costs()[nStages - 1].stage : word())
    );
    setParallel(false);
    try
    {
        const throwingErrors throwing(true);
        const fileName folder
        (
            prismCase::reportFolder
            (
                time, args.lookupOrDefault("region", polyMesh::defaultRegion)
            )
        );
        if (UPstream::master())
        {
            mkDir(folder);
            writeReport(folder/refusedName, toDictionary(what));
        }
    }
    catch (const Foam::error&)
    {
        // The error itself is more important than its file
    }

    Perr<< nl;
    if (const auto* io = dynamic_cast<const IOerror*>(&failure))
    {
        Perr<< *io;
    }
    else
    {
        Perr<< failure;
    }
    Perr<< nl << "\nNo mesh was written. A mesh that was there is as it was.\n"
        << "\nFOAM exiting\n" << endl;
    std::exit(what.status());
}


//- As above, because of an exception that is no error of OpenFOAM
[[noreturn]] static void refuse
(
    const argList& args,
    const Time& time,
    const stageLog& log,
    const refusal::codes code,
    const string& message
)
{
    refusal what;
    what.code = code;
    what.message = message;
    refuse(args, time, log, refusalError(what));
}

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool runOrRefuse
(
    const argList& args,
    const Time& time,
    const std::function<bool(stageLog&)>& run
)
{
    stageLog log(Info);
    try
    {
        return run(log);
    }
    catch (const Foam::error& failure)
    {
        refuse(args, time, log, failure);
    }
    catch (const std::bad_alloc&)
    {
        refuse
        (
            args, time, log, refusal::codes::resources,
            "There is not enough memory"
        );
    }
    catch (const std::exception& failure)
    {
        refuse
        (
            args, time, log, refusal::codes::internal,
            "A fault of harmonicPrismMesh: " + string(failure.what())
        );
    }
}

} // End namespace Foam

// ************************************************************************* //
