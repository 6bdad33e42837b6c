/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeObj.H"
#include "error.H"
#include "OFstream.H"

#include <cstdio>
#include <string>
#include <vector>

namespace Foam
{

const char* const objEnd = "# </faces>";

//- Lines that a thread makes at once
static constexpr label linesPerBlock = 4096;


//- Writes n lines. Several threads make the text.
template<class AddLine>
static void writeLines(std::ostream& os, const label n, const AddLine& addLine)
{
    std::vector<std::string> blocks((n + linesPerBlock - 1)/linesPerBlock);
    const label nBlocks = blocks.size();

    #pragma omp parallel for schedule(dynamic, 1)
    for (label block = 0; block < nBlocks; ++block)
    {
        const label end = min((block + 1)*linesPerBlock, n);
        for (label i = block*linesPerBlock; i < end; ++i)
        {
            addLine(i, blocks[block]);
        }
    }

    for (const std::string& text : blocks)
    {
        os  << text;
    }
}


void writeObj(const fileName& file, const MeshedSurface<face>& surface)
{
    OFstream stream(file);
    if (!stream.good())
    {
        FatalErrorInFunction
            << "Cannot open " << file << " for writing" << exit(FatalError);
    }

    std::ostream& os = stream.stdStream();
    os  << "# Wavefront OBJ file\no " << file.nameLessExt().c_str() << "\n\n";

    const pointField& points = surface.points();
    writeLines(os, points.size(), [&](const label i, std::string& text)
    {
        const point& x = points[i];
        char line[96];
        std::snprintf
        (
            line, sizeof(line), "v %.17g %.17g %.17g\n", x.x(), x.y(), x.z()
        );
        text += line;
    });

    for (const surfZone& zone : surface.surfZones())
    {
        os  << "g " << zone.name().c_str() << '\n';
        writeLines(os, zone.size(), [&](const label i, std::string& text)
        {
            text += 'f';
            for (const label p : surface.surfFaces()[zone.start() + i])
            {
                text += ' ' + std::to_string(p + 1);
            }
            text += '\n';
        });
    }
    os  << objEnd << '\n';
}

} // End namespace Foam

// ************************************************************************* //
