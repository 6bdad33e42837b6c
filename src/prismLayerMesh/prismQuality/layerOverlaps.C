/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerOverlaps.H"
#include "prismQuality.H"
#include "sideCrossings.H"
#include "labelledTriangle.H"
#include "markedGrid.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The outer faces that other processes have sent
struct foreignStacks
{
    //- Labels of their faces count on from the front and outer faces of here
    std::vector<labelledTriangle> triangles;

    //- By face: the process that it is from, its place in what the process has
    //  sent, and the thickness of its thickest column
    DynamicList<label> processes;
    DynamicList<label> places;
    DynamicList<scalar> tallest;
};


//- What a process is told of a stack that it has sent
struct overlapReply
{
    label place;
    scalar tallest;
};


//- The search for intersections of outer faces of all processes
class overlapSearch
{
    const prismLayers& layers_;
    const stackBoxes& groups_;
    const scalarField& thickness_;
    const columnTeam& team_;

    //- The outer faces of the list that this process counts
    const labelList own_;

    //- By process, the faces that were sent to it
    List<DynamicList<label>> sent_;

    DynamicList<overlappingStack> found_;

    scalar tallestOf(const label facei) const
    {
        return max(scalarField(thickness_, layers_.faces[facei]));
    }

    //- Corners of the boxes of the stacks of this process
    pointField boxCorners() const;

    //- Outer faces near to the boxes of process p
    message facesFor(label p, const message& boxesOf);

    //- Send outer faces to the processes whose boxes they may touch
    foreignStacks exchange();

    //- Note a pair of findIntersections
    void note
    (
        const labelPair& pair,
        const foreignStacks& others,
        List<DynamicList<overlapReply>>& replies
    );

public:

    overlapSearch
    (
        const prismLayers& layers,
        const labelUList& outerFaces,
        const stackBoxes& groups,
        const scalarField& thickness,
        const columnTeam& team
    );

    //- Look for intersections
    void intersect();

    //- Note a stack that overlaps what cannot move
    void noteAlone(const label facei)
    {
        found_.append({facei, tallestOf(facei)});
    }

    List<overlappingStack> release()
    {
        return List<overlappingStack>(std::move(found_));
    }
};


overlapSearch::overlapSearch
(
    const prismLayers& layers,
    const labelUList& outerFaces,
    const stackBoxes& groups,
    const scalarField& thickness,
    const columnTeam& team
)
:
    layers_(layers),
    groups_(groups),
    thickness_(thickness),
    team_(team),
    own_
    (
        subsetList
        (
            outerFaces,
            [&](const label facei) { return team.counts(layers.faces[facei]); }
        )
    ),
    sent_(team.size())
{}


pointField overlapSearch::boxCorners() const
{
    pointField corners(2*groups_.all().size());
    forAll(groups_.all(), group)
    {
        corners[2*group] = groups_.all()[group].min();
        corners[2*group + 1] = groups_.all()[group].max();
    }

    return corners;
}


message overlapSearch::facesFor(const label p, const message& boxesOf)
{
    std::vector<boundBox> near;
    messageReader reader(boxesOf);
    const List<point> corners(reader.list<point>());
    for (label i = 0; i < corners.size(); i += 2)
    {
        near.push_back(boundBox(corners[i], corners[i + 1]));
    }

    const markedGrid grid(near);
    DynamicList<labelledTriangle> triangles;
    DynamicList<scalar> tallest;

    for (const label facei : own_)
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
            tallest.append(tallestOf(facei));
        }
    }

    message toOther;
    toOther.addList(triangles);
    toOther.addList(tallest);

    return toOther;
}


foreignStacks overlapSearch::exchange()
{
    foreignStacks others;
    if (team_.isAlone())
    {
        return others;
    }

    message noBoxes, ownBoxes;
    noBoxes.addList(pointField());
    ownBoxes.addList(boxCorners());
    const List<message> boxesOf
    (
        team_.exchange(List<message>(team_.size(), ownBoxes))
    );

    List<message> toOthers(team_.size());
    forAll(toOthers, p)
    {
        toOthers[p] = facesFor(p, p == team_.rank() ? noBoxes : boxesOf[p]);
    }

    const List<message> fromOthers(team_.exchange(toOthers));
    forAll(fromOthers, p)
    {
        const label before = 2*layers_.faces.size() + others.places.size();
        messageReader reader(fromOthers[p]);
        for (labelledTriangle& t : reader.list<labelledTriangle>())
        {
            t.facei += before;
            others.triangles.push_back(t);
        }
        const scalarList tallest(reader.list<scalar>());
        forAll(tallest, place)
        {
            others.processes.append(p);
            others.places.append(place);
        }
        others.tallest.append(tallest);
    }

    return others;
}


void overlapSearch::note
(
    const labelPair& pair,
    const foreignStacks& others,
    List<DynamicList<overlapReply>>& replies
)
{
    const label n = layers_.faces.size();
    const auto isOuter = [&](const label f) { return f >= n; };
    const auto isForeign = [&](const label f) { return f >= 2*n; };
    const auto tallest = [&](const label f)
    {
        return isForeign(f) ? others.tallest[f - 2*n]
          : isOuter(f) ? tallestOf(f - n) : scalar(0);
    };

    if (isForeign(pair.first()))
    {
        // Their processes look for such a pair
        return;
    }

    const scalar height = max(tallest(pair.first()), tallest(pair.second()));
    for (const label f : pair)
    {
        if (isForeign(f))
        {
            replies[others.processes[f - 2*n]].append
            (
                {others.places[f - 2*n], height}
            );
        }
        else if (isOuter(f))
        {
            found_.append({f - n, height});
        }
    }
}


void overlapSearch::intersect()
{
    const foreignStacks others(exchange());
    List<DynamicList<overlapReply>> replies(team_.size());

    for
    (
        const labelPair& pair
      : findIntersections(layers_, own_, groups_, others.triangles, team_)
    )
    {
        note(pair, others, replies);
    }
    if (team_.isAlone())
    {
        return;
    }

    List<message> toOthers(team_.size());
    forAll(toOthers, p)
    {
        toOthers[p].addList(replies[p]);
    }

    const List<message> fromOthers(team_.exchange(toOthers));
    forAll(fromOthers, p)
    {
        messageReader reader(fromOthers[p]);
        for (const overlapReply& reply : reader.list<overlapReply>())
        {
            found_.append({sent_[p][reply.place], reply.tallest});
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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

    overlapSearch search(layers, outerFaces, groups, thickness, team);
    search.intersect();

    for (const label facei : findSideCrossings(layers, outerFaces, team))
    {
        search.noteAlone(facei);
    }
    for (const labelPair& nested : findNestedBodies(layers, outerFaces, bodies))
    {
        search.noteAlone(nested.second() - layers.faces.size());
    }

    return search.release();
}

} // End namespace Foam

// ************************************************************************* //
