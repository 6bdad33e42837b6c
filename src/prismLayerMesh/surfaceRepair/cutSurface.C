/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutSurface.H"
#include "EdgeMap.H"
#include "ranges.H"
#include "surfacePart.H"
#include "wallPredicates.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Points nearer to the plane than this share of their mean edge are put on it
static constexpr scalar nearShare = 0.25;

//- Points nearer to the plane than this share of that are on it: their edges
//  would all be cut at one place
static constexpr scalar onShare = 1e-3;


namespace
{

struct planeCutter
{
    const sidePatch& plane;
    const scalarField& distances;
    wallSurface& surface;

    //- Labels of the points of edges on the plane, after those of the surface
    EdgeMap<label> cuts{};
    DynamicList<point> cutPoints{};

    //- The point of an edge that is on the plane
    label cut(const edge& e)
    {
        if (!cuts.found(e))
        {
            const label a = min(e.start(), e.end());
            const label b = max(e.start(), e.end());
            const scalar t = distances[a]/(distances[a] - distances[b]);
            const pointField& points = surface.points;
            const point x((1 - t)*points[a] + t*points[b]);

            cuts.insert(e, points.size() + cutPoints.size());
            cutPoints.append(x - plane.distance(x)*plane.normal);
        }

        return cuts[e];
    }

    //- The part of a face that is not beyond the plane
    face part(const face& f)
    {
        face left;

        forAll(f, k)
        {
            const scalar d = distances[f[k]];
            const edge e(f.faceEdge(k));

            if (d <= 0)
            {
                left.append(f[k]);
            }
            if (d*distances[e.end()] < 0)
            {
                left.append(cut(e));
            }
        }

        return left;
    }

    void cutAll()
    {
        DynamicList<face> faces(surface.faces.size());
        DynamicList<label> patchIDs(faces.size());
        const auto add = [&](const face& f, const label facei)
        {
            faces.append(f);
            patchIDs.append(surface.patchIDs[facei]);
        };

        forAll(surface.faces, facei)
        {
            const face& f = surface.faces[facei];
            const bool isInFront =
                anyOf(f, [&](const label p) { return distances[p] < 0; });

            // Faces on the plane are beyond it
            const face left(isInFront ? part(f) : face());

            if (left.size() > 4)
            {
                for (label k = 1; k + 1 < left.size(); ++k)
                {
                    add(face({left[0], left[k], left[k + 1]}), facei);
                }
            }
            else if (left.size())
            {
                add(left, facei);
            }
        }

        surface.points.append(cutPoints);
        surface.faces.transfer(faces);
        surface.patchIDs.transfer(patchIDs);
        removeUnusedPoints(surface.faces, surface.points);
    }
};

} // End anonymous namespace


//- Points nearer to the plane than their share, with a neighbour that is
//  further beyond, and points that are almost on it
static bitSet nearTheCut
(
    const wallSurface& surface,
    const scalarField& distances
)
{
    scalarField near(distances.size(), Zero);
    labelList n(distances.size(), Zero);
    for (const face& f : surface.faces)
    {
        for (const edge& e : f.edges())
        {
            const scalar length = e.mag(surface.points);
            for (const label p : {e.start(), e.end()})
            {
                near[p] += length;
                ++n[p];
            }
        }
    }
    forAll(near, p)
    {
        near[p] *= nearShare/max(n[p], label(1));
    }

    bitSet points(distances.size());
    forAll(points, p)
    {
        points.set(p, mag(distances[p]) < onShare*near[p]);
    }
    for (const face& f : surface.faces)
    {
        for (const edge& e : f.edges())
        {
            for (const label p : {e.start(), e.end()})
            {
                const label q = e.otherVertex(p);

                if (mag(distances[p]) < near[p] && distances[q] >= near[q])
                {
                    points.set(p);
                }
            }
        }
    }

    return points;
}


//- Moves points that were put on a plane back to where they were, until no
//  faces are in conflict. Faces that will be cut off may be.
static void takeBackConflicts
(
    const scalarField& distances,
    const pointField& from,
    wallSurface& surface,
    bitSet& onPlane
)
{
    const auto isCutOff = [&](const face& f)
    {
        return allOf(f, [&](const label p)
        {
            return distances[p] >= 0 || onPlane.test(p);
        });
    };

    for (bool more = true; more;)
    {
        more = false;
        bitSet gone(surface.faces.size());
        forAll(surface.faces, facei)
        {
            gone.set(facei, isCutOff(surface.faces[facei]));
        }
        for (const label facei : facesInConflict(surface, gone))
        {
            for (const label p : surface.faces[facei])
            {
                if (onPlane.test(p))
                {
                    onPlane.unset(p);
                    surface.points[p] = from[p];
                    more = true;
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList facesInConflict(const wallSurface& surface, const bitSet& skip)
{
    const vectorField normals(surface.faceNormals());
    bitSet faces(surface.faces.size());
    bitSet skipped(skip);
    skipped.resize(surface.faces.size());
    forAll(normals, facei)
    {
        if (!skipped.test(facei) && normals[facei] == vector::zero)
        {
            faces.set(facei);
            skipped.set(facei);
        }
    }

    for (const labelPair& pair : findIntersectingFaces(surface, skipped))
    {
        faces.set(pair.first());
        faces.set(pair.second());
    }

    return faces.sortedToc();
}


void cutOff
(
    wallSurface& surface,
    const sidePatch& plane,
    const scalarField& distances
)
{
    planeCutter{plane, distances, surface}.cutAll();
}


void removeFacesOn
(
    wallSurface& surface,
    const sidePatch& plane,
    const scalar tolerance
)
{
    const scalarField distances(distancesTo(plane, surface.points));
    const auto isOff = [&](const label p)
    {
        return mag(distances[p]) > tolerance;
    };
    bitSet kept(surface.faces.size());
    forAll(surface.faces, facei)
    {
        kept.set(facei, anyOf(surface.faces[facei], isOff));
    }

    keepFaces(kept, surface);
}


void cutSurface
(
    wallSurface& surface,
    const sidePatch& plane,
    repairSteps& steps
)
{
    scalarField distances(distancesTo(plane, surface.points));
    const pointField from(surface.points);
    bitSet onPlane(nearTheCut(surface, distances));
    for (const label p : onPlane)
    {
        surface.points[p] -= distances[p]*plane.normal;
    }

    takeBackConflicts(distances, from, surface, onPlane);
    for (const label p : onPlane)
    {
        distances[p] = 0;
    }

    const label nFaces = surface.faces.size();
    cutOff(surface, plane, distances);
    addStep
    (
        steps, "points put on the side plane " + plane.name, onPlane.count()
    );
    addStep
    (
        steps, "faces less, beyond the side plane " + plane.name,
        max(nFaces - surface.faces.size(), label(1))
    );
}

} // End namespace Foam

// ************************************************************************* //
