/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceQualityReport.H"

#include <iomanip>
#include <sstream>

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

dictionary toDictionary(const faceQualityCounts& faces)
{
    dictionary beyond;
    for (label k = 0; k < faceQualityCounts::nBounds; ++k)
    {
        beyond.add(faceQualityCounts::names[k], faces.nBeyond[k]);
    }

    dictionary dict;
    dict.add("faces", faces.nFaces);
    dict.add("meanNonOrthogonality", faces.meanNonOrtho());
    dict.add("maxNonOrthogonality", faces.maxNonOrtho);
    dict.add("maxSkewness", faces.maxSkewness);
    dict.add("minFaceWeight", faces.minWeight);
    dict.add("minVolumeRatio", faces.minVolRatio);
    dict.add("poorFaces", faces.nBeyondAny);
    dict.add("nonOrthogonalByWall", faces.nOfWall);
    dict.add("beyond", beyond);

    return dict;
}


void write(Ostream& os, const char* where, const faceQualityCounts& faces)
{
    std::ostringstream text;
    text<< std::fixed << std::setprecision(1)
        << "Faces " << where << ": non-orthogonality mean "
        << faces.meanNonOrtho() << ", max " << faces.maxNonOrtho
        << std::setprecision(2) << "; skewness max " << faces.maxSkewness
        << std::defaultfloat << std::setprecision(2)
        << "; weight min " << faces.minWeight
        << "; volume ratio min " << faces.minVolRatio << '\n';

    if (faces.nBeyondAny)
    {
        const char* separator = "    beyond bounds: ";
        for (label k = 0; k < faceQualityCounts::nBounds; ++k)
        {
            if (faces.nBeyond[k])
            {
                text<< separator << faces.nBeyond[k] << ' '
                    << faceQualityCounts::names[k];
                separator = ", ";
            }
            if (k == 0 && faces.nOfWall)
            {
                text<< " (" << faces.nOfWall << " because of the wall's faces)";
            }
        }

        const point& x = faces.firstPlace;
        text<< std::setprecision(6) << "; first at (" << x.x() << ' ' << x.y()
            << ' ' << x.z() << ")\n";
    }

    os  << text.str().c_str();
}

} // End namespace Foam

// ************************************************************************* //
