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

//- Writes the mesh: in a parallel run the piece of layers, or with a far field
//  all pieces. Returns what the log says.
static string writeMesh
(
    const parallelRun& parallel,
    const caseWriter& writer,
    layersPiece&& piece,
    prismLayers& layers,
    farFieldMesh& farField,
    replacedFiles& replaced
)
{
    if (!parallel.isParallel())
    {
        return name(writer.writeMesh(layers, farField, replaced)) + " faces";
    }

    if (farField.empty())
    {
        writer.writeOwn(writerOf(std::move(piece)), replaced);
    }
    else
    {
        writer.writePieces(layers, farField, replaced);
    }

    return "in parts for all processes";
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
      ? makeFarFieldReport(made->layers(), farField, bounds)
      : farFieldReport()
    );

    layersPiece piece
    (
        parallel.isParallel() && !hasFarField
      ? made->makePiece() : layersPiece()
    );
    const dictionary processes(made->costs());
    prismLayers layers(std::move(made->layers()));
    made.clear();
    returnMemory();

    const string size
    (
        writeMesh
        (
            parallel, writer, std::move(piece), layers, farField, replaced
        )
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
