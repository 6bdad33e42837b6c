/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldReport.H"
#include "DynamicField.H"
#include "HashSet.H"
#include "labelRange.H"
#include "layerGeometry.H"
#include "makeFarFieldMesh.H"
#include "patchReport.H"
#include "polyhedralMesh.H"
#include "UIndirectList.H"

#include <iomanip>
#include <sstream>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Adds the faces of a far field to its report
struct farFieldFaces
{
    const prismLayers& layers;
    const farFieldMesh& far;
    const qualityControls& bounds;
    const label nTets;

    List<cellGeometry> cells{};
    farFieldReport report{};

    faceGeometry geometry(const label facei) const
    {
        return faceGeometry
        (
            UIndirectList<point>(far.points, far.topology.faces[facei])
        );
    }

    static faceCell cellOf(const cellGeometry& c)
    {
        return faceCell{c.centre, c.volume3/3};
    }

    void setCells()
    {
        const polyMeshTopology& t = far.topology;
        const polyhedralMesh mesh(far.points, t.faces, t.owner, t.neighbour);
        cells.setSize(mesh.nCells());

        #pragma omp parallel for schedule(static)
        forAll(cells, celli)
        {
            DynamicList<faceGeometry> faces(8);
            for (const label facei : mesh.cellFaces(celli))
            {
                faces.append(geometry(facei));
                faces.last().area *= mesh.owner(facei) == celli ? 1 : -1;
            }
            cells[celli] = cellGeometry(faces);
        }
    }

    //- The last cell on a front face; faces of the far field, one or several,
    //  are its outer face
    cellGeometry lastCell(const label fronti, const labelRange& outer) const
    {
        const label n = layers.nLayers;
        const face& f = layers.faces[fronti];
        DynamicList<faceGeometry> faces(8);

        faces.append(faceGeometry(levelPoints{layers, f, n - 1}));
        faces.last().area *= -1;
        forAll(f, k)
        {
            faces.append
            (
                faceGeometry(sidePoints{layers, f[k], f.nextLabel(k), n})
            );
        }
        for (const label facei : outer)
        {
            faces.append(geometry(far.topology.patchStarts[0] + facei));
            faces.last().area *= -1;
        }

        return cellGeometry(faces);
    }

    void addTransition()
    {
        const label start = far.topology.patchStarts[0];
        const labelList& fronts = far.frontFaces;
        DynamicField<scalar> volumeRatios(fronts.size());

        for (label i = 0; i < fronts.size();)
        {
            label end = i + 1;
            while (end < fronts.size() && fronts[end] == fronts[i])
            {
                ++end;
            }
            const labelRange outer(i, end - i);
            const cellGeometry layer(lastCell(fronts[i], outer));

            for (const label k : outer)
            {
                const cellGeometry& cell = cells[far.topology.owner[start + k]];
                const face outwards
                (
                    far.topology.faces[start + k].reverseFace()
                );
                const UIndirectList<point> points(far.points, outwards);
                report.transition.add
                (
                    k, faceGeometry(points), points,
                    cellOf(layer), cellOf(cell), bounds
                );
                volumeRatios.append(cell.volume3/layer.volume3);
            }
            i = end;
        }

        report.volumeRatio = makePercentiles(volumeRatios);
    }

    void addInside()
    {
        const polyMeshTopology& t = far.topology;

        forAll(t.neighbour, facei)
        {
            const label owner = t.owner[facei];
            const label neighbour = t.neighbour[facei];
            faceQualityCounts& faces =
                neighbour < nTets ? report.farField
              : owner < nTets ? report.cut : report.core;
            faces.add
            (
                facei, geometry(facei),
                UIndirectList<point>(far.points, t.faces[facei]),
                cellOf(cells[owner]), cellOf(cells[neighbour]), bounds
            );
        }
    }

    //- Patches with sides of layers are none of the far boundary
    void addPatches()
    {
        wordHashSet sides;
        for (const label side : layers.border.edgeSides)
        {
            sides.insert(layers.border.sides[side].name);
        }

        forAll(far.patches.names, patchi)
        {
            const word& name = far.patches.names[patchi];
            const label size = far.topology.patchSizes[1 + patchi];
            if (size && !sides.found(name))
            {
                report.patches.append(name);
                report.patchFaces.append(size);
            }
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

farFieldReport makeFarFieldReport
(
    const prismLayers& layers,
    const farFieldMesh& far,
    const qualityControls& bounds
)
{
    label nTets = 0;
    for (const cellZoneParts& zone : far.cellZones)
    {
        nTets = zone.name == farFieldName ? zone.cells.size() : nTets;
    }

    farFieldFaces faces{layers, far, bounds, nTets};
    faces.setCells();
    if (layers.nLayers > 0)
    {
        faces.addTransition();
    }
    faces.addInside();
    faces.addPatches();
    faces.report.hasLayers = layers.nLayers > 0;
    faces.report.nCells = far.nCells;
    faces.report.nTets = nTets;
    faces.report.grade = far.grade;

    return faces.report;
}


static dictionary toDictionary(const schemeGrade& grade)
{
    dictionary dict;
    dict.add("cellsWithLargeGains", grade.nLargeGains);
    dict.add("factor", grade.factor);
    dict.add("place", grade.place);

    return dict;
}


string textOf(const schemeGrade& grade)
{
    std::ostringstream text;
    text.precision(2);
    if (grade.factor < 0.7)
    {
        text<< "plain schemes converge";
    }
    else if (grade.factor < 0.9)
    {
        text<< "plain schemes probably converge";
    }
    else
    {
        text<< "plain schemes "
            << (grade.factor < 1.1 ? "may diverge" : "diverge");
    }

    return text.str();
}


//- Writes the numbers behind the grade. benchmarks/solvable.md compares the
//  factor with the factor of the whole mesh.
static void write(Ostream& os, const schemeGrade& grade)
{
    std::ostringstream text;
    text.precision(2);
    text<< "Plain schemes: ";
    if (grade.nLargeGains)
    {
        text<< "factor about " << grade.factor << " on the "
            << grade.nLargeGains << " cells with explicit gains above "
            << schemeGrade::largeGain << "; slowest at ("
            << std::setprecision(6) << grade.place.x() << ' '
            << grade.place.y() << ' ' << grade.place.z() << ')';
    }
    else
    {
        text<< "no explicit gain is above " << schemeGrade::largeGain;
    }
    os  << text.str().c_str() << nl;
}


dictionary toDictionary(const farFieldReport& report)
{
    dictionary patches;
    forAll(report.patches, patchi)
    {
        patches.add(report.patches[patchi], report.patchFaces[patchi]);
    }

    dictionary dict;
    dict.add("cells", report.nCells);
    dict.add(report.shape, report.nTets);
    dict.add("patchFaces", patches);
    if (report.hasLayers)
    {
        dict.add("transition", toDictionary(report.transition));
    }
    dict.add("inside", toDictionary(report.farField));
    if (report.nCells > report.nTets)
    {
        dict.add("cut", toDictionary(report.cut));
        dict.add("core", toDictionary(report.core));
    }
    if (report.hasLayers)
    {
        dict.add("volumeRatio", toDictionary(report.volumeRatio));
    }
    dict.add("plainScheme", toDictionary(report.grade));

    return dict;
}


void write(Ostream& os, const farFieldReport& report)
{
    std::ostringstream volumes;
    volumes.precision(3);
    volumes
        << "cells " << report.nCells << ", " << report.shape << ' '
        << report.nTets;
    if (report.hasLayers)
    {
        volumes
            << "; volumes over the last layer's: 1 % below "
            << report.volumeRatio.p1 << ", median " << report.volumeRatio.p50
            << ", 99 % below " << report.volumeRatio.p99;
    }

    os  << nl << "Far field: " << volumes.str().c_str() << nl;
    if (report.hasLayers)
    {
        write(os, "between layers and far field", report.transition);
    }
    write(os, "in the far field", report.farField);
    if (report.nCells > report.nTets)
    {
        const string cut("between " + report.shape + " and cells that stay");
        write(os, cut.c_str(), report.cut);
        write(os, "between cells that stay", report.core);
    }
    write(os, report.grade);
}

} // End namespace Foam

// ************************************************************************* //
