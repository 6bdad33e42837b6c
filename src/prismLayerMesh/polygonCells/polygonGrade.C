/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polygonGrade.H"

#include "HashSet.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

polygonGrade::polygonGrade
(
    const polyMeshParts& mesh,
    const polygonGeometry& geometry,
    const polygonGradeControls& controls
)
{
    const finiteVolumes volumes(geometry.volumes(mesh));
    const scalarField gains(explicitGains(volumes));
    scheme = gradeOf(volumes, gains);
    factor = max(scheme.factor, controls.maxFactor);
    labelHashSet poor(geometry.skewCells(mesh, controls.maxSkewness));
    nSkew = poor.size();
    if (nSkew == 0 && scheme.factor > controls.maxFactor)
    {
        forAll(gains, celli)
        {
            if (gains[celli] > controls.maxGain)
            {
                poor.insert(celli);
            }
        }
    }
    poorCells = poor.sortedToc();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool polygonGrade::isBetterThan(const polygonGrade& other) const
{
    return
        nSkew < other.nSkew || (nSkew == other.nSkew && factor < other.factor);
}

} // End namespace Foam

// ************************************************************************* //
