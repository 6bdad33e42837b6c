/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "givenParts.H"
#include "disjointSets.H"
#include "ListOps.H"
#include "orientOpenWall.H"
#include "splitAtSidePatches.H"
#include "surfacePart.H"

#include <cmath>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Samples of a surface, and samples of each part at least and if there are few
//  parts
static constexpr label nSamples = 20000;
static constexpr label leastOfPart = 4;
static constexpr label mostOfPart = 64;

//- Spreads samples over faces: one on each 'spacing' of area, on triangles by
//  the sequence of Roberts, whose points are spread evenly
static List<surfaceSample> spreadSamples
(
    const wallSurface& surface,
    const labelUList& faces,
    const scalar spacing
)
{
    static constexpr scalar plastic = 1.32471795724474602596;
    DynamicList<surfaceSample> samples;
    scalar passed = 0.5*spacing;
    for (const label facei : faces)
    {
        const face& f = surface.faces[facei];
        for (label k = 1; k + 1 < f.size(); ++k)
        {
            const point& a = surface.points[f[0]];
            const vector u(surface.points[f[k]] - a);
            const vector v(surface.points[f[k + 1]] - a);
            for (passed += 0.5*mag(u ^ v); passed >= spacing; passed -= spacing)
            {
                const scalar i = samples.size() + 1;
                scalar s = i/plastic - std::floor(i/plastic);
                scalar t = i/sqr(plastic) - std::floor(i/sqr(plastic));
                if (s + t > 1)
                {
                    s = 1 - s;
                    t = 1 - t;
                }
                samples.append(surfaceSample{a + s*u + t*v, facei, spacing});
            }
        }
    }

    return List<surfaceSample>(std::move(samples));
}


//- Sets what a part bounds
static void setShape
(
    const wallSurface& given,
    const UList<sidePatch>& planes,
    givenPart& part
)
{
    part.surface = makeSurfacePart(given, part.faces).surface;
    part.box = boundBox(part.surface.points, false);
    const edgeList border(outline(part.surface.faces));
    part.isClosed = border.empty();
    openComponent whole;
    whole.faces = identity(part.faces.size());
    const scalar near =
        sideTolerance*boundBox(given.points, false).mag();
    if
    (
        !part.isClosed
     && isOnOrBeyond(part.surface.points, border, planes, near)
    )
    {
        const List<openComponent> components
        (
            openComponents(part.surface, planes)
        );
        if (components.size() == 1)
        {
            part.triangles =
                cappedTriangles(part.surface, planes, components[0]);
        }
        part.isSheet = part.triangles.empty();
    }
    if (part.triangles.empty())
    {
        part.triangles = cappedTriangles(part.surface, planes, whole);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool givenPart::has(const point& x) const
{
    return isSheet ? isBehind(triangles, x) : isWithin(triangles, x);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

PtrList<givenPart> makeGivenParts
(
    const wallSurface& given,
    const UList<sidePatch>& planes
)
{
    disjointSets sets(connectedPoints(given.points.size(), given.faces));
    labelList partOf(given.points.size(), -1);
    label n = 0;
    for (const face& f : given.faces)
    {
        label& part = partOf[sets.find(f[0])];
        part = part < 0 ? n++ : part;
    }
    List<DynamicList<label>> faces(n);
    forAll(given.faces, i)
    {
        faces[partOf[sets.find(given.faces[i][0])]].append(i);
    }

    scalar all = 0;
    PtrList<givenPart> parts(n);
    forAll(parts, i)
    {
        parts.set(i, new givenPart);
        parts[i].faces = faces[i];
        for (const label facei : faces[i])
        {
            parts[i].area += given.faces[facei].mag(given.points);
        }
        all += parts[i].area;
    }
    const label least =
        max(leastOfPart, min(mostOfPart, nSamples/max(n, label(1))));
    for (givenPart& part : parts)
    {
        if (part.area > VSMALL)
        {
            setShape(given, planes, part);
            part.samples = spreadSamples
            (
                given, part.faces, min(all/nSamples, part.area/least)
            );
        }
    }

    return parts;
}

} // End namespace Foam

// ************************************************************************* //
