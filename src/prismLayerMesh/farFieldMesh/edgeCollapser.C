/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "edgeCollapser.H"
#include "HashSet.H"
#include "ListOps.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::edgeCollapser::edgeCollapser(wallSurface& surface)
:
    surface_(surface),
    pointFaces_
    (
        invertManyToMany<face, labelList>
        (
            surface.points.size(), surface.faces
        )
    ),
    isTouched_(surface.points.size(), false),
    isGone_(surface.points.size())
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::edgeCollapser::leastSine
(
    const face& f,
    const vector& normal
) const
{
    const pointField& x = surface_.points;
    const vector area(f.areaNormal(x));
    scalar most = 0;
    for (label k = 0; k < 3; ++k)
    {
        const scalar a = magSqr(x[f[k]] - x[f.nextLabel(k)]);
        const scalar b = magSqr(x[f[k]] - x[f.prevLabel(k)]);
        most = max(most, a*b);
    }

    return (area & normal) > 0 ? 2*mag(area)/(::sqrt(most) + VSMALL) : 0;
}


bool Foam::edgeCollapser::isBetter(const label v, const label w) const
{
    scalar before = 1;
    scalar after = 1;
    labelHashSet around;
    label nGone = 0;
    for (const label facei : pointFaces_[v])
    {
        const face& f = surface_.faces[facei];
        const vector normal(f.areaNormal(surface_.points));
        before = min(before, leastSine(f, normal));
        around.insert(f);
        if (f.found(w))
        {
            ++nGone;
            continue;
        }
        face moved(f);
        moved[f.find(v)] = w;
        after = min(after, leastSine(moved, normal));
    }
    labelHashSet common;
    for (const label facei : pointFaces_[w])
    {
        for (const label p : surface_.faces[facei])
        {
            if (p != v && p != w && around.found(p))
            {
                common.insert(p);
            }
        }
    }

    return nGone == 2 && common.size() == 2 && after > before;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::edgeCollapser::collapse(const label v, const label w)
{
    if (isTouched_[v] || isTouched_[w] || !isBetter(v, w))
    {
        return;
    }

    for (const label facei : pointFaces_[v])
    {
        face& f = surface_.faces[facei];
        UIndirectList<bool>(isTouched_, f) = true;
        f[f.find(v)] = w;
    }
    isGone_.set(v);
}


bool Foam::edgeCollapser::finish()
{
    labelList renumbering(surface_.points.size(), -1);
    label n = 0;
    forAll(renumbering, p)
    {
        if (!isGone_.test(p))
        {
            surface_.points[n] = surface_.points[p];
            renumbering[p] = n++;
        }
    }
    surface_.points.setSize(n);

    label nFaces = 0;
    forAll(surface_.faces, facei)
    {
        const face f(renumber(renumbering, surface_.faces[facei]));
        if (f[0] != f[1] && f[1] != f[2] && f[2] != f[0])
        {
            surface_.patchIDs[nFaces] = surface_.patchIDs[facei];
            surface_.faces[nFaces++] = f;
        }
    }
    surface_.patchIDs.setSize(nFaces);
    surface_.faces.setSize(nFaces);

    return isGone_.any();
}


// ************************************************************************* //
