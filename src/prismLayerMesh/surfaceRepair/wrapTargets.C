/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "EdgeMap.H"
#include "searchTree.H"
#include "unitConversion.H"
#include "wallSides.H"
#include "wrapSurface.H"

namespace Foam
{

//- A face is along a plane if the product of their unit normals is larger
static constexpr scalar alongCosine = 0.9;


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

sharpLines::sharpLines(const wallSurface& surface, const scalar minCos)
{
    const vectorField normals(surface.faceNormals());
    const wallSides sides(makeWallSides(surface));
    DynamicList<edge> sharp;
    DynamicList<Pair<vector>> both;
    for (label e = 0; e < sides.nEdges(); ++e)
    {
        const SubList<wallSide> all(sides.on(e));
        Pair<vector> n(Zero, Zero);

        if (all.size() == 2)
        {
            n.first() = normals[all[0].facei];
            n.second() = normals[all[1].facei];

            // Normals of neighbours may be opposite to each other
            if (mag(n.first() & n.second()) >= minCos)
            {
                continue;
            }
        }

        sharp.append(edge(all[0].low, all[0].high));
        both.append(n);
    }

    edges_ = edgeList(std::move(sharp));
    normals_ = List<Pair<vector>>(std::move(both));

    if (edges_.size())
    {
        const treeDataEdge items
        (
            false, edges_, surface.points, identity(edges_.size())
        );
        const boundBox box(surface.points, false);
        tree_ = makeSearchTree(items, box, 0.01, 10);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

pointIndexHit sharpLines::findNearest
(
    const point& x,
    const scalar distance
) const
{
    return tree_.valid()
      ? tree_->findNearest(x, sqr(distance)) : pointIndexHit();
}


bool sharpLines::isBetween
(
    const label edgei,
    const vector& m,
    const vector& n
) const
{
    const vector& a = normals_[edgei].first();
    const vector& b = normals_[edgei].second();

    return max(min(mag(a & m), mag(b & n)), min(mag(a & n), mag(b & m)))
      > alongCosine;
}


// * * * * * * * * * * * * * * * *  Chamfers * * * * * * * * * * * * * * * * //

//- Planes meet if the volume of their normals, or its like for two of them, is
//  larger
static constexpr scalar leastVolume = 0.1;

//- They meet near a sharp line if it is within this share of the reach
static constexpr scalar meetingShare = 0.25;


namespace
{

struct chamferSplitter
{
    const tangentPlanes& planes;
    const sharpLines& lines;
    wallSurface& wrap;

    //- Labels of the points of edges, after those of the wrap
    EdgeMap<label> onEdges{};

    DynamicList<point> middles{};
    DynamicList<point> targets{};


    //- Add a point that is to go to where the planes of others meet; -1 if they
    //  do not
    label add(const UList<label>& p, const point& middle, const scalar reach)
    {
        const pointIndexHit hit(planes.meet(p, middle, lines, reach));
        if (!hit.hit())
        {
            return -1;
        }

        middles.append(middle);
        targets.append(hit.rawPoint());

        return wrap.points.size() + middles.size() - 1;
    }


    label addCorner(const face& f)
    {
        scalar longest = 0;
        for (const edge& e : f.edges())
        {
            if (!planes.areAcross(e.start(), e.end()))
            {
                return -1;
            }
            longest = max(longest, e.mag(wrap.points));
        }

        return add(f, f.centre(wrap.points), longest);
    }


    //- Between points of the wrap and new ones, where these are yet
    scalar distance(const label p, const label q) const
    {
        const label n = wrap.points.size();
        const auto at = [&](const label r)
        {
            return r < n ? wrap.points[r] : middles[r - n];
        };

        return mag(at(p) - at(q));
    }


    //- The triangle with the points on its edges
    face withMiddles(const face& f) const
    {
        face all;

        forAll(f, k)
        {
            const auto middle = onEdges.cfind(f.faceEdge(k));
            all.append(f[k]);
            if (middle.found())
            {
                all.append(middle.val());
            }
        }

        return all;
    }


    //- Append the parts of a triangle
    void split(const face& f, DynamicList<face>& parts)
    {
        const face all(withMiddles(f));
        const label nOld = wrap.points.size();
        const label n = all.size();

        const label centre = addCorner(f);

        if (centre >= 0)
        {
            forAll(all, k)
            {
                parts.append(face({all[k], all.nextLabel(k), centre}));
            }
        }
        else if (n == 6)
        {
            const label k = all[0] < nOld ? 1 : 0;
            parts.append(face({all[k], all[k + 2], all[k + 4]}));
            for (label i = k; i < n; i += 2)
            {
                const label next = all[(i + 2) % n];
                parts.append(face({all[i], all[(i + 1) % n], next}));
            }
        }
        else if (n > 3)
        {
            // From a new point; of two, by the shorter diagonal
            const auto at = [&](const label k) { return all[k % n]; };
            label k = 0;
            while (at(k) < nOld || at(k + 1) >= nOld || at(k + 2) >= nOld)
            {
                ++k;
            }
            if (n == 5 && distance(at(k), at(k + 2))
              > distance(at(k + 1), at(k + 3)))
            {
                k += 3;
            }

            for (label i = 1; i + 1 < n; ++i)
            {
                parts.append(face({at(k), at(k + i), at(k + i + 1)}));
            }
        }
        else
        {
            parts.append(f);
        }
    }


    pointField split(const edgeList& across)
    {
        for (const edge& e : across)
        {
            const label p =
                add(labelList(e), e.centre(wrap.points), e.mag(wrap.points));
            if (p >= 0)
            {
                onEdges.insert(e, p);
            }
        }

        DynamicList<face> faces(wrap.faces.size());
        DynamicList<label> patchIDs(wrap.faces.size());
        forAll(wrap.faces, facei)
        {
            split(wrap.faces[facei], faces);
            patchIDs.setSize(faces.size(), wrap.patchIDs[facei]);
        }

        wrap.faces.transfer(faces);
        wrap.patchIDs.transfer(patchIDs);
        wrap.points.append(middles);

        return pointField(std::move(targets));
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

pointIndexHit tangentPlanes::meet
(
    const UList<label>& p,
    const point& beside,
    const sharpLines& lines,
    const scalar reach
) const
{
    const auto behind = [&](const label i)
    {
        return normals[p[i]] & (points[p[i]] - beside);
    };

    const vector& m = normals[p[0]];
    const vector& n = normals[p[1]];
    scalar det;
    vector toAll;

    if (p.size() == 2)
    {
        const scalar a = behind(0);
        const scalar b = behind(1);
        det = 1 - sqr(m & n);
        toAll = (a - (m & n)*b)*m + (b - (m & n)*a)*n;
    }
    else
    {
        const vector& l = normals[p[2]];
        det = l & (m ^ n);
        toAll = behind(0)*(n ^ l) + behind(1)*(l ^ m) + behind(2)*(m ^ n);
    }

    if (mag(det) < leastVolume || mag(toAll) > reach*mag(det))
    {
        return pointIndexHit();
    }

    const point meeting(beside + toAll/det);
    pointIndexHit hit(lines.findNearest(meeting, meetingShare*reach));

    bool isOff = false;
    bool isOnSide = false;
    bool isBetween = false;
    forAll(p, i)
    {
        isOff = isOff || areOff.test(p[i]);
        isOnSide = isOnSide || onSides.test(p[i]);
        isBetween = isBetween || (hit.hit() && lines.isBetween
        (
            hit.index(), normals[p[i]], normals[p.fcValue(i)]
        ));
    }

    if (isOff)
    {
        hit.rawPoint() = meeting;
    }

    return isBetween || isOnSide || isOff ? hit : pointIndexHit();
}


pointField splitChamfers
(
    const tangentPlanes& planes,
    const sharpLines& lines,
    const edgeList& across,
    wallSurface& wrap
)
{
    return chamferSplitter{planes, lines, wrap}.split(across);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

wrapTargets::wrapTargets
(
    const wallSurface& surface,
    const nearestSurface& nearest,
    const snapControls& controls,
    wallSurface& wrap
)
:
    nearest_(nearest),
    faceNormals_(surface.faceNormals()),
    controls_(controls),
    from_(wrap.points)
{
    foot_.minCos = Foam::cos(degToRad(controls.featureAngle));
    const sharpLines lines(surface, foot_.minCos);
    const label nGiven = wrap.points.size();

    setNearest(0);
    const edgeList chamfers(snapToEdges(lines, wrap));
    const pointField targets(splitChamfers(foot_, lines, chamfers, wrap));

    from_ = wrap.points;
    setNearest(nGiven);
    forAll(targets, i)
    {
        onEdges_.set(nGiven + i, targets[i]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void wrapTargets::setNearest(const label start)
{
    const pointField from(SubList<point>(from_, from_.size() - start, start));
    pointField onFaces;
    labelList faces;
    nearest_.find(from, onFaces, faces);
    foot_.points.setSize(from_.size());
    foot_.normals.setSize(from_.size());
    for (bitSet* const set : {&foot_.areOff, &foot_.onSides, &isFar_})
    {
        set->resize(from_.size());
    }

    forAll(from, i)
    {
        const label p = start + i;
        const vector out(from[i] - onFaces[i]);
        const vector& n = faceNormals_[faces[i]];
        const bool isInside = controls_.inside.test(faces[i]);

        // Faces of the surface need not be oriented alike; around the edge of a
        // sheet planes turn
        foot_.points[p] = isInside ? from[i] : onFaces[i];
        foot_.normals[p] =
            isInside && mag(out) > VSMALL ? vector(normalised(out))
          : (n & out) < 0 ? -n : n;
        foot_.areOff.set(p, isInside);
        foot_.onSides.set(p, controls_.sides.test(faces[i]));
        isFar_.set(p, mag(out) > controls_.distance);
    }
}


pointIndexHit wrapTargets::nearestLine
(
    const sharpLines& lines,
    const label p,
    const edge& e,
    const scalar length
) const
{
    const point& foot = foot_.points[p];
    const pointIndexHit meeting(foot_.meet(labelList(e), foot, lines, length));
    const pointIndexHit hit
    (
        meeting.hit()
     || foot_.areOff.test(e.start()) || foot_.areOff.test(e.end())
      ? meeting : lines.findNearest(foot, 2*controls_.distance)
    );

    return hit.hit() && mag(hit.rawPoint() - foot) < 2*controls_.distance
      ? hit : pointIndexHit();
}


edgeList wrapTargets::snapToEdges
(
    const sharpLines& lines,
    const wallSurface& wrap
)
{
    DynamicList<edge> chamfers;
    for (const face& f : wrap.faces)
    {
        for (const edge& e : f.edges())
        {
            // Each edge is of two faces
            if (e.start() > e.end() || !isAcross(e))
            {
                continue;
            }

            const scalar length = e.mag(wrap.points);
            const pointIndexHit a(nearestLine(lines, e.start(), e, length));
            const pointIndexHit b(nearestLine(lines, e.end(), e, length));
            const scalar da =
                a.hit() ? mag(a.rawPoint() - foot_.points[e.start()]) : GREAT;
            const scalar db =
                b.hit() ? mag(b.rawPoint() - foot_.points[e.end()]) : GREAT;

            if (min(da, db) < GREAT)
            {
                const bool first = da <= db;
                onEdges_.set
                (
                    first ? e.start() : e.end(),
                    first ? a.rawPoint() : b.rawPoint()
                );
            }
            else
            {
                chamfers.append(e);
            }
        }
    }

    return edgeList(std::move(chamfers));
}

} // End namespace Foam

// ************************************************************************* //
