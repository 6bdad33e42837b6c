/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stackExchange.H"
#include "markedGrid.H"
#include "prismQuality.H"

namespace Foam
{

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

message stackExchange::facesFor
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
    toOther.addList(triangles);
    toOther.addList(tallest);

    return toOther;
}


void stackExchange::take(const label p, const message& faces)
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

stackExchange::stackExchange
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
    noBoxes.addList(List<boundBox>());
    ownBoxes.addList(groups.all());
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void stackExchange::note(const label facei, const scalar tallest)
{
    const label i = indexOf(facei);
    replies_[processes_[i]].append({places_[i], tallest});
}


List<overlappingStack> stackExchange::tell() const
{
    if (team_.isAlone())
    {
        return List<overlappingStack>();
    }

    List<message> toOthers(team_.size());
    forAll(toOthers, p)
    {
        toOthers[p].addList(replies_[p]);
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

} // End namespace Foam

// ************************************************************************* //
