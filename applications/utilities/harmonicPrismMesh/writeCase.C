/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeCase.H"
#include "farFieldReport.H"
#include "replacedFiles.H"
#include "returnMemory.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Writes the mesh, in a parallel run all pieces, and drops the layers. Returns
//  what the log says.
//  processes: is set to the costs of a parallel run
static string writeMesh
(
    const parallelRun& parallel,
    const caseWriter& writer,
    autoPtr<caseLayers>& made,
    farFieldMesh& farField,
    dictionary& processes,
    replacedFiles& replaced
)
{
    if (parallel.isParallel())
    {
        if (!farField.empty())
        {
            writer.requireDivisible(farField);
            parallel.begin();
        }
        const meshPiece piece(made->makePiece(farField));
        processes = made->costs();
        made.clear();
        writer.writeOwn(piece, replaced);

        return "in parts for all processes";
    }

    const prismLayers layers(std::move(made->layers()));
    made.clear();
    returnMemory();

    return name(writer.writeMesh(layers, farField, replaced)) + " faces";
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void writeCase
(
    const prismCase& files,
    const parallelRun& parallel,
    const caseWriter& writer,
    const caseWall& given,
    autoPtr<caseLayers>& made,
    farFieldMesh&& farField,
    const qualityControls& bounds,
    stageLog& log,
    replacedFiles& replaced
)
{
    layerReport report(made->report());
    const bool hasFarField = !farField.empty();
    writer.writeSurfaces(made->surfaces(), replaced);
    const farFieldReport far
    (
        hasFarField
      ? makeFarFieldReport(made->wholeLayers(), farField, bounds)
      : farFieldReport()
    );

    dictionary processes;
    const string size
    (
        writeMesh(parallel, writer, made, farField, processes, replaced)
    );
    log.end(name(report.nCells + far.nCells) + " cells, " + size);
    report.stages = log.costs();

    dictionary entries(toDictionary(report));
    entries.add("surface", given.changes);
    if (processes.size())
    {
        entries.add("processes", processes);
    }
    Foam::write(Info, report);

    if (hasFarField)
    {
        entries.add("farField", toDictionary(far));
        Foam::write(Info, far);
    }

    IOstream::defaultPrecision(6);
    const fileName& file = files.reportFile();
    writeReport(replaced.scratch(file, file.name())/file.name(), entries);
}

} // End namespace Foam

// ************************************************************************* //
