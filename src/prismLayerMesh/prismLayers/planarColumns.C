/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planarColumns.H"

namespace Foam
{

labelPair emptySides(const wallBorder& border)
{
    DynamicList<label> found;
    forAll(border.sides, s)
    {
        if (border.sides[s].type == "empty")
        {
            found.append(s);
        }
    }
    if (found.empty())
    {
        return labelPair(-1, -1);
    }

    const sidePatch& first = border.sides[found[0]];
    const sidePatch& last = border.sides[found.last()];
    if (found.size() != 2 || (first.normal & last.normal) > -1 + 1e-9)
    {
        FatalErrorInFunction
            << "A mesh of two dimensions is between two parallel planes of type"
            << " empty, not at " << found.size() << ": "
            << first.name << (found.size() > 1 ? " and " + last.name : "")
            << exit(FatalError);
    }

    return labelPair(found[0], found[1]);
}


labelList columnsAcross
(
    const faceList& faces,
    const wallBorder& border,
    const pointField& roots
)
{
    const labelPair empty(emptySides(border));
    if (empty.first() < 0)
    {
        return labelList();
    }

    const auto isOnFirst = [&](const label c)
    {
        return mag(border.sides[empty.first()].distance(roots[c]))
            < mag(border.sides[empty.second()].distance(roots[c]));
    };
    labelList across(roots.size(), -1);
    for (const face& f : faces)
    {
        label k = 0;
        while (k < f.size() && !(isOnFirst(f[k]) && isOnFirst(f.nextLabel(k))))
        {
            ++k;
        }
        bool isPlanar = f.size() == 4 && k < 4;
        for (label i = 0; isPlanar && i < 2; ++i)
        {
            label& other = across[f[(k + i) % 4]];
            const label opposite = f[(k + 3 - i) % 4];
            isPlanar =
                !isOnFirst(opposite) && (other < 0 || other == opposite);
            other = opposite;
        }
        if (!isPlanar)
        {
            FatalErrorInFunction
                << "In two dimensions the wall is one face wide between "
                << border.sides[empty.first()].name << " and "
                << border.sides[empty.second()].name << ", of quadrilaterals"
                << " with two points on each; the face at "
                << f.centre(roots) << " is not" << exit(FatalError);
        }
    }

    return across;
}


void makePlanar(const labelUList& across, prismLayers& layers)
{
    forAll(across, c)
    {
        const label other = across[c];
        if (other < 0)
        {
            continue;
        }
        const vector way(layers(other, 0) - layers(c, 0));
        for (label i = 1; i <= layers.nLayers; ++i)
        {
            layers.points[layers.index(other, i)] = layers(c, i) + way;
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
