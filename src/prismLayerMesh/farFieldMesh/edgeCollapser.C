/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "edgeCollapser.H"
#include "HashSet.H"
#include "ListOps.H"
#include "surfacePart.H"

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
    isTouched_(surface.points.size(), false)
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
}


bool Foam::edgeCollapser::finish()
{
    bitSet kept(surface_.faces.size());
    forAll(surface_.faces, facei)
    {
        const face& f = surface_.faces[facei];
        kept.set(facei, f[0] != f[1] && f[1] != f[2] && f[2] != f[0]);
    }
    keepFaces(kept, surface_);

    return !kept.all();
}


// ************************************************************************* //
