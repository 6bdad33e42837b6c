/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "farFieldReport.H"
#include "dictionary.H"

#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static dictionary toDictionary(const faceQuality& quality)
{
    dictionary dict;
    dict.add("faces", quality.nFaces);
    dict.add("nonOrthogonality", toDictionary(quality.nonOrthogonality));
    dict.add("skewness", toDictionary(quality.skewness));
    dict.add("poorFaces", quality.poorPlaces.size());

    return dict;
}


static void write
(
    Ostream& os,
    const std::string& where,
    const faceQuality& quality
)
{
    std::ostringstream line;
    line<< std::fixed << std::setprecision(1)
        << "Non-orthogonality " << where << ": mean "
        << quality.nonOrthogonality.mean << ", max "
        << quality.nonOrthogonality.max << "; max skewness "
        << std::setprecision(2) << quality.skewness.max;

    if (quality.poorPlaces.size())
    {
        const point& x = quality.poorPlaces[0];
        line<< "; beyond 70 or 4 " << quality.poorPlaces.size()
            << " faces, first at " << std::defaultfloat << std::setprecision(6)
            << '(' << x.x() << ' ' << x.y() << ' ' << x.z() << ')';
    }

    os  << line.str().c_str() << nl;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::dictionary Foam::toDictionary(const farFieldReport& report)
{
    dictionary patches;
    forAll(report.patches, patchi)
    {
        patches.add(report.patches[patchi], report.patchFaces[patchi]);
    }

    dictionary dict;
    dict.add("cells", report.nCells);
    dict.add("patchFaces", patches);
    dict.add("layers", toDictionary(report.layers));
    dict.add("transition", toDictionary(report.transition));
    dict.add("inside", toDictionary(report.farField));
    dict.add("volumeRatio", toDictionary(report.volumeRatio));

    return dict;
}


void Foam::write(Ostream& os, const farFieldReport& report)
{
    std::ostringstream volumes;
    volumes.precision(3);
    volumes
        << "cells " << report.nCells
        << "; their volume over that of the last layer: 1 % below "
        << report.volumeRatio.p1 << ", median " << report.volumeRatio.p50
        << ", 99 % below " << report.volumeRatio.p99;

    os  << nl << "Far field: " << volumes.str().c_str() << nl;
    write(os, "of layers", report.layers);
    write(os, "between", report.transition);
    write(os, "in the far field", report.farField);
}


// ************************************************************************* //
