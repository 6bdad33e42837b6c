/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallVisibility.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void wallVisibility::setCone(const label p)
{
    vectorField all(cornerNormals[p]);
    all.append(polygonNormals[p]);

    if (sideLines.size() && mag(sideLines[p]) > 0)
    {
        const scalar cosine = min(all & sideLines[p]);
        cones[p] = visibilityCone{sideLines[p], max(cosine, scalar(0))};
    }
    else
    {
        cones[p] = makeVisibilityCone(all);
    }
}


vectorField wallVisibility::axes() const
{
    vectorField axes(cones.size());

    forAll(axes, p)
    {
        axes[p] = cones[p].axis;
    }

    return axes;
}


boolList wallVisibility::narrowCones(const scalar smallestAngle) const
{
    boolList narrow(cones.size());

    forAll(narrow, p)
    {
        narrow[p] =
            cones[p].empty() || cones[p].cosine < ::sin(smallestAngle);
    }

    return narrow;
}


labelList wallVisibility::emptyCones() const
{
    return subsetList
    (
        identity(cones.size()),
        [&](const label p) { return cones[p].empty(); }
    );
}


vector wallVisibility::limited
(
    const label p,
    const vector& d,
    const scalar margin
) const
{
    const visibilityCone& cone = cones[p];
    const scalar smallest = margin*cone.cosine;

    // No d.n_f can be smaller by more than that
    if (cone.cosine - mag(d - cone.axis) > smallest)
    {
        return d;
    }

    // d + s*(axis - d) is no longer than 1, so what holds for it holds for
    // its unit vector
    scalar s = 0;
    for (const vectorField* normals : {&cornerNormals[p], &polygonNormals[p]})
    {
        for (const vector& n : *normals)
        {
            const scalar dn = d & n;

            if (dn < smallest)
            {
                s = max(s, (smallest - dn)/max((cone.axis & n) - dn, VSMALL));
            }
        }
    }

    return normalised(d + min(s, scalar(1))*(cone.axis - d));
}

} // End namespace Foam

// ************************************************************************* //
