/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallDomain.H"
#include "backgroundMesh.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

tetDomain wallAndEnvelope
(
    const wallSurface& wall,
    const offsetEnvelope& envelope
)
{
    labelList triangleFace;
    tetDomain domain;
    domain.facets = wallTriangles(wall, triangleFace);
    domain.points = wall.points;
    domain.points.append(envelope.points);

    return domain;
}


pointField bodySeeds(const wallSurface& wall, const wallSearch& search)
{
    DynamicList<point> seeds;

    for (const label facei : largestFaces(wall))
    {
        // On one triangle of the face: its centre may be off a warped face
        const face& f = wall.faces[facei];
        const triPointRef tri
        (
            wall.points[f[0]], wall.points[f[1]], wall.points[f[2]]
        );
        const vector inwards = -tri.unitNormal();
        const scalar tiny =
            domainControls::seedShare*::sqrt(f.mag(wall.points));

        const pointIndexHit hit
        (
            search.firstHit
            (
                tri.centre() + tiny*inwards,
                tri.centre() + search.bounds().mag()*inwards
            )
        );

        // Without a hit the inner side is the outside, and not meshed anyway
        if (hit.hit())
        {
            seeds.append(0.5*(tri.centre() + hit.rawPoint()));
        }
    }

    return pointField(std::move(seeds));
}


boundBox boxAround
(
    const pointField& points,
    const offsetEnvelope& envelope
)
{
    boundBox box(points);
    box.inflate(domainControls::boxShare);
    const vector margin =
        point::uniform(domainControls::boxHeights*max(envelope.radius));
    box.min() -= margin;
    box.max() += margin;

    return box;
}


void addBox(const boundBox& box, tetDomain& domain)
{
    const label first = domain.points.size();
    domain.points.append(box.points());

    // In the order of boundBox::points
    static const label faces[6][4] =
    {
        {0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
        {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}
    };

    for (const label (&f)[4] : faces)
    {
        domain.facets.append(face({first+f[0], first+f[1], first+f[2]}));
        domain.facets.append(face({first+f[0], first+f[2], first+f[3]}));
    }
}

} // End namespace Foam

// ************************************************************************* //
