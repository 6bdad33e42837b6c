/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerOverlaps.H"
#include "boundBox.H"
#include "cellPredicates.H"
#include "disjointSets.H"
#include "DynamicList.H"
#include "markedGrid.H"
#include "prismQuality.H"
#include "sideCrossings.H"

#include <algorithm>

namespace Foam
{

//- The box of some levels of a stack
static boundBox boundsOf
(
    const prismLayers& layers,
    const label facei,
    const label from,
    const label to
)
{
    boundBox bounds(boundBox::invertedBox);
    for (const label c : layers.faces[facei])
    {
        for (label i = from; i <= to; ++i)
        {
            bounds.add(layers(c, i));
        }
    }

    return bounds;
}


//- A point of a body that does not move: the middle of a face of the body's
//  wall. Points of the wall may be on a side patch, and so on the boundary of
//  other layers.
static point middleOf(const prismLayers& layers, const label facei)
{
    const face& f = layers.faces[facei];
    point middle(Zero);
    for (const label c : f)
    {
        middle += layers(c, 0)/f.size();
    }

    return middle;
}


//- Exact; not in tetrahedra without volume
static bool isInTet(const FixedList<point, 4>& tet, const point& x)
{
    const int sign = orientation(tet[0], tet[1], tet[2], tet[3]);

    return sign
     && sign*orientation(x, tet[1], tet[2], tet[3]) >= 0
     && sign*orientation(tet[0], x, tet[2], tet[3]) >= 0
     && sign*orientation(tet[0], tet[1], x, tet[3]) >= 0
     && sign*orientation(tet[0], tet[1], tet[2], x) >= 0;
}


//- Whether x is in the convex hull: in a tetrahedron of four of the points
static bool isInHull(const UList<point>& points, const point& x)
{
    const label n = points.size();

    for (label a = 0; a < n; ++a)
    {
        for (label b = a + 1; b < n; ++b)
        {
            for (label c = b + 1; c < n; ++c)
            {
                for (label d = c + 1; d < n; ++d)
                {
                    if
                    (
                        isInTet({points[a], points[b], points[c], points[d]}, x)
                    )
                    {
                        return true;
                    }
                }
            }
        }
    }

    return false;
}


static bool isInStack
(
    const prismLayers& layers,
    const label facei,
    const point& x
)
{
    for (label i = 1; i <= layers.nLayers; ++i)
    {
        if (!boundsOf(layers, facei, i - 1, i).contains(x))
        {
            continue;
        }

        // Of polygons the fans that their surfaces are cut into: warped ones
        // have a hull at any thickness
        const face& f = layers.faces[facei];

        for (label k = 1; k + 1 < f.size(); ++k)
        {
            DynamicList<point> points;
            for (const label c : {f[0], f[k], f[k + 1]})
            {
                points.append(layers(c, i - 1));
                points.append(layers(c, i));
            }

            if (isInHull(points, x))
            {
                return true;
            }
        }
    }

    return false;
}


namespace
{

struct firstFace
{
    label facei;
    point middle;
};

}


//- Returns for each column the first front face, in the whole front, of the
//  body that the column is on
static labelList firstFacesOfColumns
(
    const prismLayers& layers,
    const columnTeam& team
)
{
    disjointSets parts(connectedPoints(layers.nColumns(), layers.faces));
    labelList ofParts(layers.nColumns(), labelMax);
    forAll(layers.faces, facei)
    {
        label& first = ofParts[parts.find(layers.faces[facei][0])];
        first = min(first, team.wholeFace(facei));
    }

    // A body may have a part on each share
    labelList ofColumns(layers.nColumns(), labelMax);
    do
    {
        forAll(ofColumns, c)
        {
            label& first = ofParts[parts.find(c)];
            first = min(first, ofColumns[c]);
        }
        forAll(ofColumns, c)
        {
            ofColumns[c] = ofParts[parts.find(c)];
        }
    }
    while (team.columns.lower(ofColumns));

    return ofColumns;
}


layerBodies findBodies(const prismLayers& layers, const columnTeam& team)
{
    const labelList first(firstFacesOfColumns(layers, team));
    DynamicList<firstFace> own;
    forAll(layers.faces, facei)
    {
        const face& f = layers.faces[facei];
        if (first[f[0]] == team.wholeFace(facei) && team.countsFace(facei))
        {
            own.append({first[f[0]], middleOf(layers, facei)});
        }
    }

    List<firstFace> all(team.gather(own));
    std::sort
    (
        all.begin(), all.end(),
        [](const firstFace& a, const firstFace& b) { return a.facei < b.facei; }
    );

    layerBodies bodies;
    bodies.firstFaces.setSize(all.size());
    bodies.middles.setSize(all.size());
    forAll(all, i)
    {
        bodies.firstFaces[i] = all[i].facei;
        bodies.middles[i] = all[i].middle;
    }
    bodies.ofFaces.setSize(layers.faces.size());
    forAll(layers.faces, facei)
    {
        bodies.ofFaces[facei] = std::lower_bound
        (
            bodies.firstFaces.begin(), bodies.firstFaces.end(),
            first[layers.faces[facei][0]]
        ) - bodies.firstFaces.begin();
    }

    return bodies;
}


List<labelPair> findNestedBodies
(
    const prismLayers& layers,
    const labelUList& stacks,
    const layerBodies& bodies
)
{
    const label nBodies = bodies.firstFaces.size();
    DynamicList<labelPair> pairs;

    if (nBodies == 1)
    {
        return List<labelPair>();
    }

    // In ascending order of x
    const pointField& middles = bodies.middles;
    scalarField x(middles.component(vector::X));
    const labelList order(sortedOrder(x));
    x = scalarField(x, order);

    #pragma omp parallel for schedule(dynamic, 64) if (stacks.size() > 128)
    forAll(stacks, k)
    {
        const label facei = stacks[k];
        const boundBox box(boundsOf(layers, facei, 0, layers.nLayers));
        label i =
            std::lower_bound(x.begin(), x.end(), box.min().x()) - x.begin();

        for (; i < nBodies && x[i] <= box.max().x(); ++i)
        {
            const label body = order[i];

            if
            (
                body != bodies.ofFaces[facei]
             && box.contains(middles[body])
             && isInStack(layers, facei, middles[body])
            )
            {
                #pragma omp critical
                pairs.append
                (
                    labelPair
                    (
                        bodies.firstFaces[body], layers.faces.size() + facei
                    )
                );
            }
        }
    }
    sort(pairs);

    return List<labelPair>(std::move(pairs));
}


namespace
{

//- Outer faces of stacks that processes send each other, because they may
//  intersect. A process that finds an intersection tells the process of the
//  other stack.
//
//  Constructor and tell are collective. A team of one exchanges nothing.
class stackExchange
{
    //- What a process is told of a stack that it has sent
    struct reply
    {
        label place;
        scalar tallest;
    };

    const prismLayers& layers_;
    const scalarField& thickness_;
    const columnTeam& team_;

    //- By process, the faces that were sent to it
    List<DynamicList<label>> sent_;

    // By face that others have sent

        //- The process that it is from, and its place in what this has sent
        DynamicList<label> processes_;
        DynamicList<label> places_;

        DynamicList<scalar> tallest_;

    std::vector<labelledTriangle> triangles_;
    List<DynamicList<reply>> replies_;

    //- Index of a face that another process has sent
    label indexOf(const label facei) const
    {
        return facei - 2*layers_.faces.size();
    }

    //- Returns the outer faces near to the boxes of process p
    message facesFor
    (
        const label p,
        const message& boxesOf,
        const labelUList& outerFaces
    )
    {
        messageReader reader(boxesOf);
        const List<boundBox> boxes(reader.list<boundBox>());
        const std::vector<boundBox> near(boxes.begin(), boxes.end());
        const markedGrid grid(near);
        DynamicList<labelledTriangle> triangles;
        DynamicList<scalar> tallest;
        for (const label facei : outerFaces)
        {
            if
            (
                near.size()
             && grid.mayTouch(boxOf(layers_, facei, layers_.nLayers))
            )
            {
                for
                (
                    labelledTriangle& t
                  : trianglesOf(layers_, facei, layers_.nLayers, team_)
                )
                {
                    t.facei = sent_[p].size();
                    triangles.append(t);
                }
                sent_[p].append(facei);
                tallest.append(tallestOf(layers_, facei, thickness_));
            }
        }

        message toOther;
        toOther(triangles, tallest);

        return toOther;
    }

    //- Takes the outer faces that process p has sent
    void take(const label p, const message& faces)
    {
        const label before = 2*layers_.faces.size() + places_.size();
        messageReader reader(faces);
        for (labelledTriangle& t : reader.list<labelledTriangle>())
        {
            t.facei += before;
            triangles_.push_back(t);
        }
        const scalarList tallest(reader.list<scalar>());
        forAll(tallest, place)
        {
            processes_.append(p);
            places_.append(place);
        }
        tallest_.append(tallest);
    }

public:

    //- Sends outer faces to the processes whose stacks they may touch.
    //  References must outlive the object.
    //  outerFaces: front faces that this process counts
    //  groups: of all stacks of this process
    //  thickness: of all columns [m]
    stackExchange
    (
        const prismLayers& layers,
        const labelUList& outerFaces,
        const stackBoxes& groups,
        const scalarField& thickness,
        const columnTeam& team
    )
    :
        layers_(layers),
        thickness_(thickness),
        team_(team),
        sent_(team.size()),
        replies_(team.size())
    {
        if (team.isAlone())
        {
            return;
        }

        message noBoxes, ownBoxes;
        noBoxes(List<boundBox>());
        ownBoxes(groups.all());
        const List<message> boxes
        (
            team.exchange(List<message>(team.size(), ownBoxes))
        );

        List<message> toOthers(team.size());
        forAll(toOthers, p)
        {
            toOthers[p] =
                facesFor(p, p == team.rank() ? noBoxes : boxes[p], outerFaces);
        }

        const List<message> fromOthers(team.exchange(toOthers));
        forAll(fromOthers, p)
        {
            take(p, fromOthers[p]);
        }
    }

    //- Returns the triangles that others have sent. The labels of their faces
    //  count on from the front faces and outer faces of this process.
    const std::vector<labelledTriangle>& triangles() const
    {
        return triangles_;
    }

    bool isForeign(const label facei) const { return indexOf(facei) >= 0; }

    //- Returns the thickness [m] of the thickest column of a foreign face
    scalar tallest(const label facei) const
    {
        return tallest_[indexOf(facei)];
    }

    //- Notes that a foreign face overlaps a stack of this process.
    //  tallest: thickness [m] of the thickest column of both
    void note(const label facei, const scalar tallest)
    {
        const label i = indexOf(facei);
        replies_[processes_[i]].append({places_[i], tallest});
    }

    //- Tells the processes of foreign faces what was noted. Returns the stacks
    //  of this process that others have noted.
    List<overlappingStack> tell() const
    {
        if (team_.isAlone())
        {
            return List<overlappingStack>();
        }

        List<message> toOthers(team_.size());
        forAll(toOthers, p)
        {
            toOthers[p](replies_[p]);
        }

        DynamicList<overlappingStack> told;
        const List<message> fromOthers(team_.exchange(toOthers));
        forAll(fromOthers, p)
        {
            messageReader reader(fromOthers[p]);
            for (const reply& r : reader.list<reply>())
            {
                told.append({sent_[p][r.place], r.tallest});
            }
        }

        return List<overlappingStack>(std::move(told));
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * *  Layer Overlaps * * * * * * * * * * * * * * * //

//- Notes a pair of findIntersections
static void addPair
(
    const prismLayers& layers,
    const scalarField& thickness,
    const labelPair& pair,
    stackExchange& others,
    DynamicList<overlappingStack>& found
)
{
    const label n = layers.faces.size();
    const auto tallest = [&](const label f)
    {
        return others.isForeign(f) ? others.tallest(f)
          : f >= n ? tallestOf(layers, f - n, thickness) : scalar(0);
    };

    if (others.isForeign(pair.first()))
    {
        // Their processes look for such a pair
        return;
    }

    const scalar height = max(tallest(pair.first()), tallest(pair.second()));
    for (const label f : pair)
    {
        if (others.isForeign(f))
        {
            others.note(f, height);
        }
        else if (f >= n)
        {
            found.append({f - n, height});
        }
    }
}


//- The stacks whose outer faces intersect outer faces or the wall
static DynamicList<overlappingStack> intersectingStacks
(
    const prismLayers& layers,
    const labelUList& outerFaces,
    const stackBoxes& groups,
    const scalarField& thickness,
    const columnTeam& team
)
{
    const labelList own
    (
        subsetList
        (
            outerFaces,
            [&](const label facei) { return team.countsFace(facei); }
        )
    );
    stackExchange others(layers, own, groups, thickness, team);
    DynamicList<overlappingStack> found;

    for
    (
        const labelPair& pair
      : findIntersections(layers, own, groups, others.triangles(), team)
    )
    {
        addPair(layers, thickness, pair, others, found);
    }
    found.append(others.tell());

    return found;
}


scalar tallestOf
(
    const prismLayers& layers,
    const label facei,
    const scalarField& thickness
)
{
    return max(scalarField(thickness, layers.faces[facei]));
}


List<overlappingStack> findOverlaps
(
    const prismLayers& layers,
    const labelUList& outerFaces,
    const layerBodies& bodies,
    const stackBoxes& groups,
    const scalarField& thickness,
    const columnTeam& team
)
{
    if (!team.any(outerFaces.size()))
    {
        return List<overlappingStack>();
    }

    DynamicList<overlappingStack> found
    (
        intersectingStacks(layers, outerFaces, groups, thickness, team)
    );

    // Stacks that overlap what cannot move
    const auto addAlone = [&](const label facei)
    {
        found.append({facei, tallestOf(layers, facei, thickness)});
    };
    for (const label facei : findSideCrossings(layers, outerFaces, team))
    {
        addAlone(facei);
    }
    for (const labelPair& nested : findNestedBodies(layers, outerFaces, bodies))
    {
        addAlone(nested.second() - layers.faces.size());
    }

    return List<overlappingStack>(std::move(found));
}

} // End namespace Foam

// ************************************************************************* //
