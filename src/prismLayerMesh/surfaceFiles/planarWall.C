/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planarWall.H"
#include "curveEnds.H"
#include "EdgeMap.H"

namespace Foam
{

//- A strip before its second row of points is there
struct stripMaker
{
    DynamicList<point> points;
    DynamicList<edge> edges;
    DynamicList<label> patchIDs;

    wallSurface strip(const vector& way) const
    {
        const label n = points.size();
        wallSurface wall;
        wall.points = points;
        wall.points.append(pointField(pointField(points) + way));
        wall.faces.setSize(edges.size());
        forAll(edges, i)
        {
            const edge& e = edges[i];
            wall.faces[i] = face({e[0], e[1], e[1] + n, e[0] + n});
        }
        wall.patchIDs = patchIDs;

        return wall;
    }
};


//- Whether one who looks against the normal sees the first axis to the right
//  and the second one up. The face on an edge has its normal to the right then.
static bool seesCoordinates(const planarControls& controls)
{
    const labelPair in(controls.directions());
    vector first(Zero);
    first[in.first()] = 1;
    vector second(Zero);
    second[in.second()] = 1;

    return ((first ^ second) & controls.normal) > 0;
}


wallSurface stripOn
(
    List<planeCurve> curves,
    const planarControls& controls
)
{
    const labelPair in(controls.directions());
    const bool isSeen = seesCoordinates(controls);
    if (controls.maxEdge < GREAT)
    {
        setCurveEnds(curves, controls);
        for (planeCurve& curve : curves)
        {
            curve = resampled(curve, controls.maxEdge, controls.maxTurn);
        }
    }

    stripMaker maker;
    for (const planeCurve& curve : curves)
    {
        const label first = maker.points.size();
        const label n = curve.points.size();
        for (const vector2D& x : curve.points)
        {
            point p(Zero);
            p[in.first()] = x.x();
            p[in.second()] = x.y();
            maker.points.append(p);
        }
        for (label i = 0; i < curve.nEdges(); ++i)
        {
            const edge along(first + i, first + (i + 1) % n);
            maker.edges.append(isSeen ? along : along.reverseEdge());
            maker.patchIDs.append(0);
        }
    }
    wallSurface wall(maker.strip(controls.thickness*controls.normal));
    wall.patchNames = wordList(1, word("patch0"));

    return wall;
}


//- The section of a surface with the plane through the origin
class sectionMaker
{
    const wallSurface& surface_;
    const vector& normal_;
    const scalarField heights_;
    EdgeMap<label> crossings_;

    //- The label of the point at which an edge goes through the plane. A point
    //  in the plane is the crossing of all of its edges.
    label crossing(label below, const label above)
    {
        below = heights_[above] > 0 ? below : above;
        const edge e(below, above);
        if (!crossings_.found(e))
        {
            crossings_.insert(e, made.points.size());
            const scalar share = below == above
              ? 0 : heights_[below]/(heights_[below] - heights_[above]);
            const point x
            (
                surface_.points[below]
              + share*(surface_.points[above] - surface_.points[below])
            );
            made.points.append(x - (x & normal_)*normal_);
        }

        return crossings_[e];
    }

    void cut(const label facei)
    {
        const face& f = surface_.faces[facei];
        label up = -1;
        label down = -1;
        forAll(f, k)
        {
            const label a = f[k];
            const label b = f.nextLabel(k);
            if (heights_[a] < 0 && heights_[b] >= 0)
            {
                up = crossing(a, b);
            }
            else if (heights_[a] >= 0 && heights_[b] < 0)
            {
                down = crossing(b, a);
            }
        }
        if (up >= 0 && down >= 0 && up != down)
        {
            // The strip's normal is that of the face
            made.edges.append(edge(down, up));
            made.patchIDs.append(surface_.patchIDs[facei]);
        }
    }

public:

    stripMaker made;

    sectionMaker(const wallSurface& surface, const vector& normal)
    :
        surface_(surface),
        normal_(normal),
        heights_(surface.points & normal)
    {
        forAll(surface.faces, facei)
        {
            cut(facei);
        }
        if (made.edges.empty())
        {
            FatalErrorInFunction
                << "The plane of twoDimensional, through the origin with the"
                << " normal " << normal << ", does not cut the surface, which"
                << " is from " << min(heights_) << " to " << max(heights_)
                << " along the normal" << exit(FatalError);
        }
    }
};


wallSurface stripOn(const wallSurface& surface, const planarControls& controls)
{
    const sectionMaker section(surface, controls.normal);
    wallSurface wall(section.made.strip(controls.thickness*controls.normal));
    wall.patchNames = surface.patchNames;
    wall.patchTypes = surface.patchTypes;

    return wall;
}


List<sidePatch> planesOf(const planarControls& controls)
{
    List<sidePatch> planes(2);
    forAll(planes, i)
    {
        planes[i].name = i ? "back" : "front";
        planes[i].type = "empty";
        planes[i].origin = i*controls.thickness*controls.normal;
        planes[i].normal = (i ? 1 : -1)*controls.normal;
    }

    return planes;
}

} // End namespace Foam

// ************************************************************************* //
