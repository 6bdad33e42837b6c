/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planarWall.H"
#include "curveEnds.H"
#include "EdgeMap.H"

#include <algorithm>

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


//- Adds a curve to a strip, with one patch. The ends of open curves are points
//  of their own.
static void addCurve
(
    const planeCurve& curve,
    const label patchi,
    const planarControls& controls,
    stripMaker& maker
)
{
    const labelPair in(controls.directions());
    const bool isSeen = seesCoordinates(controls);
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
        maker.patchIDs.append(patchi);
    }
}


wallSurface stripOn
(
    List<planeCurve> curves,
    const planarControls& controls
)
{
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
        addCurve(curve, 0, controls, maker);
    }
    wallSurface wall(maker.strip(controls.thickness*controls.normal));
    wall.patchNames = wordList(1, word("patch0"));

    return wall;
}


//- The section of a surface with a plane
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

    sectionMaker(const wallSurface& surface, const planarControls& controls)
    :
        surface_(surface),
        normal_(controls.normal),
        heights_((surface.points & normal_) - controls.sectionAt)
    {
        forAll(surface.faces, facei)
        {
            cut(facei);
        }
        if (made.edges.empty())
        {
            FatalErrorInFunction
                << "The plane of twoDimensional, at " << controls.sectionAt
                << " m along the normal " << normal_
                << ", does not cut the surface, which is from "
                << min(heights_) + controls.sectionAt << " to "
                << max(heights_) + controls.sectionAt << nl
                << "Move the plane by twoDimensional.sectionAt"
                << exit(FatalError);
        }
    }
};


//- Edges of a section turn by less than this where the surface is flat [rad]:
//  the sides of its triangles are no points of the curve
static constexpr scalar flatTurn = 1e-5;


//- A curve of a section, of one patch
struct sectionCurve
{
    planeCurve curve;
    label patchi;
};


//- Follows the edges of a section
class sectionCurves
{
    const stripMaker& section_;
    const planarControls& controls_;

    //- The edge that begins at each point, and the edge that ends there; -1 if
    //  there are none or several
    labelList next_;
    labelList before_;

    boolList isDone_;

    vector2D inPlane(const label p) const
    {
        const labelPair in(controls_.directions());
        const point& x = section_.points[p];

        return vector2D(x[in.first()], x[in.second()]);
    }

    //- The edge behind an edge that goes on with the same patch, or -1
    label following(const label e) const
    {
        const label f = next_[section_.edges[e].end()];

        return
            f >= 0 && before_[section_.edges[f].start()] == e
         && section_.patchIDs[f] == section_.patchIDs[e] ? f : -1;
    }

    //- Appends a point, in place of the last one if the curve is straight there
    static void append(const vector2D& x, DynamicList<vector2D>& points)
    {
        const label n = points.size();
        if (n > 1)
        {
            const vector2D a(points[n - 1] - points[n - 2]);
            const vector2D b(x - points[n - 1]);
            const scalar turn = a.x()*b.y() - a.y()*b.x();
            if (mag(turn) <= flatTurn*(a & b))
            {
                points[n - 1] = x;
                return;
            }
        }
        if (n == 0 || mag(x - points[n - 1]) > 0)
        {
            points.append(x);
        }
    }

    sectionCurve follow(const label first)
    {
        sectionCurve made{planeCurve(), section_.patchIDs[first]};
        DynamicList<vector2D> points;
        append(inPlane(section_.edges[first].start()), points);
        label last = first;
        label e = first;
        for (; e >= 0 && !isDone_[e]; e = following(last))
        {
            last = e;
            isDone_[e] = true;
            append(inPlane(section_.edges[e].end()), points);
        }

        made.curve.isClosed = e == first && points.size() > 3;
        if (made.curve.isClosed)
        {
            points.resize(points.size() - 1);
        }
        if (!seesCoordinates(controls_))
        {
            std::reverse(points.begin(), points.end());
        }
        made.curve.points = points;
        if (!made.curve.isClosed)
        {
            const label b = before_[section_.edges[first].start()];
            const label f = next_[section_.edges[last].end()];
            const FixedList<bool, 2> goesOn{goOn(b, first), goOn(last, f)};
            const bool isSeen = seesCoordinates(controls_);
            made.curve.goesOn[0] = goesOn[isSeen ? 0 : 1];
            made.curve.goesOn[1] = goesOn[isSeen ? 1 : 0];
        }

        return made;
    }

    //- Whether the curve of one edge goes on as the curve of another, with
    //  another patch, without a corner
    bool goOn(const label e, const label f) const
    {
        return
            e >= 0 && f >= 0
         && !isCorner
            (
                inPlane(section_.edges[e].start()),
                inPlane(section_.edges[f].start()),
                inPlane(section_.edges[f].end())
            );
    }

    static void note(label& edgeAt, const label e)
    {
        edgeAt = edgeAt == -1 ? e : -2;
    }

public:

    sectionCurves(const stripMaker& section, const planarControls& controls)
    :
        section_(section),
        controls_(controls),
        next_(section.points.size(), -1),
        before_(next_),
        isDone_(section.edges.size(), false)
    {
        forAll(section.edges, e)
        {
            note(next_[section.edges[e].start()], e);
            note(before_[section.edges[e].end()], e);
        }
    }

    //- Open curves first, from where they begin
    List<sectionCurve> make()
    {
        DynamicList<sectionCurve> curves;
        for (const bool open : {true, false})
        {
            forAll(section_.edges, e)
            {
                const label b = before_[section_.edges[e].start()];
                const bool begins = b < 0 || following(b) != e;
                if (!isDone_[e] && begins == open)
                {
                    curves.append(follow(e));
                }
            }
        }

        return List<sectionCurve>(std::move(curves));
    }
};


//- Adds curves with new points to a strip
static void addResampled
(
    const UList<sectionCurve>& curves,
    const planarControls& controls,
    stripMaker& maker
)
{
    List<planeCurve> atSides(curves.size());
    forAll(curves, i)
    {
        atSides[i] = curves[i].curve;
    }
    setCurveEnds(atSides, controls);
    forAll(curves, i)
    {
        for (const label end : {0, 1})
        {
            atSides[i].goesOn[end] =
                atSides[i].goesOn[end] || curves[i].curve.goesOn[end];
        }
        addCurve
        (
            resampled(atSides[i], controls.maxEdge, controls.maxTurn),
            curves[i].patchi, controls, maker
        );
    }
}


wallSurface stripOn(const wallSurface& surface, const planarControls& controls)
{
    const sectionMaker section(surface, controls);
    stripMaker resampledMaker;
    if (controls.maxEdge < GREAT)
    {
        addResampled
        (
            sectionCurves(section.made, controls).make(), controls,
            resampledMaker
        );
    }

    const stripMaker& maker =
        controls.maxEdge < GREAT ? resampledMaker : section.made;
    wallSurface wall(maker.strip(controls.thickness*controls.normal));
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
