/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polygonPoorness.H"

#include "faceQuality.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

//- The area of the triangles from the centre of a face to its edges that a
//  point does not see, as share of the face
scalar polygonPoorness::hidden
(
    const label facei,
    const scalar way,
    const point& from
) const
{
    const face& f = mesh_.topology.faces[facei];
    if (f.size() == 3)
    {
        return 0;
    }
    const point& centre = geometry_.faceCentres[facei];
    const vector to(way*(centre - from));
    scalar sum = 0;
    vector last(mesh_.points[f.last()] - centre);
    for (const label p : f)
    {
        const vector next(mesh_.points[p] - centre);
        const vector area(0.5*(last ^ next));
        sum += (area & to) > 0 ? 0 : mag(area);
        last = next;
    }
    const scalar whole = max(mag(geometry_.faceAreas[facei]), sum);

    return sum > 0 ? 0.3 + sum/whole : 0;
}


//- Whether a face of four points has a corner that turns the wrong way. A cell
//  of such faces may be a hexahedron, by its form, that is not positive.
bool polygonPoorness::isReflex(const label facei) const
{
    const face& f = mesh_.topology.faces[facei];
    bool is = false;
    for (label k = 0; k < 4 && f.size() == 4; ++k)
    {
        const point& x = mesh_.points[f[k]];
        const vector next(mesh_.points[f[f.fcIndex(k)]] - x);
        const vector previous(mesh_.points[f[f.rcIndex(k)]] - x);
        is = is || ((next ^ previous) & geometry_.faceAreas[facei]) < 0;
    }

    return is;
}


//- How poor the angle, the skewness and the weight of a face between cells are
scalar polygonPoorness::between(const label facei) const
{
    const polyMeshTopology& t = mesh_.topology;
    const point& own = geometry_.cellCentres[t.owner[facei]];
    const point& other = geometry_.cellCentres[t.neighbour[facei]];
    const faceGeometry f(geometry_.faceAt(facei));
    const scalar most = controls_.maxSkewness;
    const scalar skewness =
        (f.area & (other - own)) <= 0 ? most + 5
      : skewnessAbove
        (
            f, UIndirectList<point>(mesh_.points, t.faces[facei]), own, other,
            most
        );
    const scalar ownDepth = max(f.area & (f.centre - own), scalar(0));
    const scalar otherDepth = max(f.area & (other - f.centre), scalar(0));
    const scalar weight =
        min(ownDepth, otherDepth)/max(ownDepth + otherDepth, VSMALL);

    return
        controls_.faceWeight
       *nonOrthoViolation(f.area, other - own, leastCosine_)
      + min(max(skewness - most, scalar(0)), scalar(5))
      + max(1 - weight/controls_.minFaceWeight, scalar(0));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

polygonPoorness::polygonPoorness
(
    const poornessControls& controls,
    const label nLayerCells,
    const polyMeshParts& mesh,
    const polygonGeometry& geometry
)
:
    controls_(controls),
    leastCosine_(Foam::cos(degToRad(controls.maxNonOrtho))),
    nLayerCells_(nLayerCells),
    mesh_(mesh),
    geometry_(geometry)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalar polygonPoorness::ofFaces(const label celli, const scalar bound) const
{
    const polyMeshTopology& t = mesh_.topology;
    const point& centre = geometry_.cellCentres[celli];
    const scalar size = ::cbrt(mag(geometry_.cellVolumes[celli]));
    scalar sum = 0;
    for (const label facei : geometry_.cells[celli])
    {
        const vector& area = geometry_.faceAreas[facei];
        const scalar way = t.owner[facei] == celli ? 1 : -1;
        const scalar depth =
            way*(area & (geometry_.faceCentres[facei] - centre))
           /max(mag(area)*size, VSMALL);
        sum += depth > 0 ? 0 : 5 - 5*max(depth, scalar(-1));
        sum += isReflex(facei) ? 0.5 : 0;
        sum += celli < nLayerCells_ ? 0 : hidden(facei, way, centre);
        sum += facei < t.neighbour.size() ? between(facei) : 0;
        if (sum > bound)
        {
            break;
        }
    }

    return sum;
}


scalar polygonPoorness::operator()(const label celli, const scalar bound)
{
    const scalar sum = ofFaces(celli, bound);
    if (sum > bound)
    {
        return sum;
    }
    const scalar gain = gainOf(geometry_.volumes(mesh_), celli, seen_);

    return sum + sqr(min(max(gain - controls_.gain, scalar(0)), scalar(2)));
}

} // End namespace Foam

// ************************************************************************* //
