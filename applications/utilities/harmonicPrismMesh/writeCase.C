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

void writeCase
(
    const prismCase& files,
    const parallelRun& parallel,
    const caseWriter& writer,
    const preparedWall& given,
    autoPtr<caseLayers>& made,
    stageLog& log,
    replacedFiles& replaced
)
{
    layerReport report(made->report());
    farFieldMesh farField(std::move(made->mesh().farField));
    const bool hasFarField = !farField.empty();
    writer.writeOuter(made->layers(), hasFarField, replaced);
    const farFieldReport far
    (
        hasFarField
      ? makeFarFieldReport(made->layers(), farField, made->mesh().bounds)
      : farFieldReport()
    );

    const meshPiece piece
    (
        parallel.isParallel() && !hasFarField
      ? made->makePiece() : meshPiece()
    );
    prismLayers layers(std::move(made->layers()));
    made.clear();
    returnMemory();

    string size(" faces");
    if (!parallel.isParallel())
    {
        size = name(writer.writeMesh(layers, farField, replaced)) + size;
    }
    else
    {
        size = "in parts for all processes";
        hasFarField
          ? writer.writePieces(layers, farField, replaced)
          : writer.writeOwn(piece, replaced);
    }
    log.end(name(report.nCells + far.nCells) + " cells, " + size);
    report.stages = log.costs();

    dictionary entries(toDictionary(report));
    entries.add("surface", given.prepared.changes);
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
