/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bitSet.H"
#include "edgeHashes.H"
#include "EdgeMap.H"
#include "ListOps.H"
#include "sideParts.H"
#include "sidePatch.H"

namespace Foam
{

//- Returns a face in triangles without edges that have points; the face itself
//  if it has no such edges
static DynamicList<face> pieces(const EdgeMap<label>& points, const face& whole)
{
    DynamicList<face> left;
    DynamicList<face> done;
    left.append(whole);

    while (left.size())
    {
        const face f(left.remove());
        label k = 0;
        while (k < f.size() && !points.found(f.faceEdge(k)))
        {
            ++k;
        }

        if (k == f.size())
        {
            done.append(f);
            continue;
        }

        const label x = points[f.faceEdge(k)];
        for (label i = 1; i < f.size(); ++i)
        {
            const edge e(f.faceEdge((k + i) % f.size()));
            left.append(face({x, e.start(), e.end()}));
        }
    }

    return done;
}


labelList splitAtEdges(const EdgeMap<label>& points, wallSurface& surface)
{
    DynamicList<face> added;
    DynamicList<label> from;
    forAll(surface.faces, facei)
    {
        const DynamicList<face> all(pieces(points, surface.faces[facei]));
        surface.faces[facei] = all[0];

        for (label i = 1; i < all.size(); ++i)
        {
            added.append(all[i]);
            from.append(facei);
        }
    }

    surface.faces.append(added);
    const labelList patchIDs(surface.patchIDs, from);
    surface.patchIDs.append(patchIDs);

    return labelList(std::move(from));
}


// * * * * * * * * * * * * * *  Divide Side Part * * * * * * * * * * * * * * //

namespace
{

struct partDivider
{
    sectoredSurface& sectored;
    const label part;
    const scalar tolerance;

    wallSurface& surface = sectored.surface;
    const labelList faces = findIndices(sectored.parts, part);

    //- Edges between the part and the wall, and points of other parts
    edgeHashSet border{};
    bitSet onOthers{};

    sidePlane plane{};

    //- Distance [m] of each point from the plane, 0 for points on the plane
    scalarField distances = scalarField(surface.points.size());

    //- The points at which edges cross the plane
    EdgeMap<label> crossings{};


    void findBorder()
    {
        edgeHashSet edges;
        for (const label f : faces)
        {
            edges.insert(surface.faces[f].edges());
        }

        onOthers.setSize(surface.points.size());
        forAll(surface.faces, facei)
        {
            const face& f = surface.faces[facei];

            if (sectored.parts[facei] < 0)
            {
                for (const edge& e : f.edges())
                {
                    if (edges.found(e))
                    {
                        border.insert(e);
                    }
                }
            }
            else if (sectored.parts[facei] != part)
            {
                onOthers.set(f);
            }
        }
    }


    //- Through the middle of the part, between the faces that are nearer in
    //  their normals to one of those that differ most, and to the other
    void setPlane()
    {
        vectorField areas(faces.size());
        point middle(Zero);
        forAll(faces, i)
        {
            const face& f = surface.faces[faces[i]];
            areas[i] = f.areaNormal(surface.points);
            middle += mag(areas[i])*f.centre(surface.points);
        }

        vectorField normals(areas);
        for (vector& n : normals)
        {
            n.normalise();
        }
        const vector first(normals[findMin(scalarField(normals & sum(areas)))]);
        const vector second(normals[findMin(scalarField(normals & first))]);

        vector ofFirst(Zero), ofSecond(Zero);
        forAll(normals, i)
        {
            const bool isFirst = (normals[i] & (first - second)) > 0;
            (isFirst ? ofFirst : ofSecond) += areas[i];
        }

        plane.origin = middle/max(sum(mag(areas)), VSMALL);
        plane.normal = normalised(ofFirst - ofSecond);
    }


    //- The ends next to the plane of the border's edges that cross it, of those
    //  that are on no other part
    labelList nearPoints() const
    {
        labelHashSet nearest;

        for (const edge& e : border)
        {
            if (distances[e.start()]*distances[e.end()] < 0)
            {
                const bool first =
                    mag(distances[e.start()]) < mag(distances[e.end()]);
                const label p = first ? e.start() : e.end();
                const label q = e.otherVertex(p);

                if (!onOthers.test(p) || !onOthers.test(q))
                {
                    nearest.insert(onOthers.test(p) ? q : p);
                }
            }
        }

        return nearest.sortedToc();
    }


    void setDistances()
    {
        forAll(distances, p)
        {
            const scalar d = plane.distance(surface.points[p]);
            distances[p] = mag(d) < tolerance ? 0 : d;
        }
    }


    //- Put the plane through the points at the border that are the furthest
    //  apart, and the others on it
    void putOnBorder()
    {
        setDistances();
        const labelList ends(nearPoints());
        const pointField& points = surface.points;

        if (ends.size())
        {
            plane.origin = points[ends[0]];
            const pointField apart(points, ends);
            const vector along
            (
                apart[findMax(scalarField(mag(apart - apart[0])))] - apart[0]
            );
            const vector e(normalised(along));
            plane.normal = normalised(plane.normal - (plane.normal & e)*e);
            setDistances();
        }

        for (const label p : nearPoints())
        {
            distances[p] = 0;
        }
    }


    void findCrossings()
    {
        DynamicList<point> added;
        const label nPoints = surface.points.size();

        for (const label f : faces)
        {
            for (const edge& e : surface.faces[f].edges())
            {
                const scalar a = distances[e.start()];
                const scalar b = distances[e.end()];

                if
                (
                    a*b < 0 && !border.found(e)
                 && crossings.insert(e, nPoints + added.size())
                )
                {
                    added.append
                    (
                        (b*surface.points[e.start()]
                      - a*surface.points[e.end()])/(b - a)
                    );
                }
            }
        }

        surface.points.append(added);
        distances.resize(surface.points.size(), 0);
    }


    //- Append to values of faces those of the faces that further ones are of
    static void extend(labelList& values, const labelUList& from)
    {
        const labelList added(values, from);
        values.append(added);
    }


    void divide()
    {
        findBorder();
        setPlane();
        putOnBorder();
        findCrossings();
        const labelList from(splitAtEdges(crossings, surface));
        extend(sectored.parts, from);
        extend(sectored.sectors, from);

        const label sector = max(sectored.sectors) + 1;
        for (const label f : findIndices(sectored.parts, part))
        {
            const scalarField d(distances, surface.faces[f]);
            if (sum(d) > 0)
            {
                sectored.sectors[f] = sector;
            }
        }
    }
};

} // End anonymous namespace


void divideSidePart
(
    sectoredSurface& sectored,
    const label part,
    const scalar tolerance
)
{
    partDivider{sectored, part, tolerance}.divide();
}

} // End namespace Foam

// ************************************************************************* //
