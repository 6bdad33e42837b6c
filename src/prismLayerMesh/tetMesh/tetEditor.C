/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetEditor.H"
#include "error.H"
#include "tetAddressing.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Whether the order of the points p q r s of a tetrahedron is an even
//  permutation of its own
static bool isAlike
(
    const tetCell& tet,
    const FixedList<label, 4>& points
)
{
    bool even = true;

    for (label i = 0; i < 4; ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            if (tet.find(points[j]) > tet.find(points[i]))
            {
                even = !even;
            }
        }
    }

    return even;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void tetEditor::connect
(
    const labelUList& tets,
    const UList<triFace>& outerFaces,
    const labelUList& outerTets
)
{
    // Faces that still look for their neighbours
    DynamicList<triFace, 64> faces(outerFaces);
    DynamicList<label, 64> neighbours(outerTets);

    for (const label t : tets)
    {
        for (label i = 0; i < 4; ++i)
        {
            const triFace f(tets_[t].face(i));
            label k = 0;

            while (k < faces.size() && !triFace::compare(faces[k], f))
            {
                ++k;
            }

            if (k == faces.size())
            {
                faces.append(f);
                neighbours.append(t);
                continue;
            }

            const label other = neighbours[k];
            neighbours_[t][i] = other;

            for (label j = 0; other >= 0 && j < 4; ++j)
            {
                if (triFace::compare(triFace(tets_[other].face(j)), f))
                {
                    neighbours_[other][j] = t;
                }
            }

            faces[k] = faces.last();
            neighbours[k] = neighbours.last();
            faces.remove();
            neighbours.remove();
        }
    }

    if (faces.size())
    {
        FatalErrorInFunction
            << "Tetrahedra that replace others have other faces: "
            << faces[0] << abort(FatalError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

tetEditor::tetEditor(const tetCellList& tets, const label nPoints)
:
    tets_(tets),
    neighbours_(tetNeighbours(tets, nPoints)),
    pointTets_(nPoints)
{
    labelList nTets(nPoints, 0);
    for (const tetCell& tet : tets)
    {
        for (const label p : tet)
        {
            ++nTets[p];
        }
    }

    pointTets_.setSize(nPoints);
    forAll(nTets, p)
    {
        pointTets_[p].setCapacity(nTets[p]);
    }

    forAll(tets_, t)
    {
        for (const label p : tets_[t])
        {
            pointTets_[p].append(t);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label tetEditor::addPoint()
{
    pointTets_.append(tetLabels());

    return pointTets_.size() - 1;
}


void tetEditor::removeLastPoint()
{
    pointTets_.remove();
}


void tetEditor::ring
(
    const label tet,
    const edge& e,
    DynamicList<label>& points,
    DynamicList<label>& tets
) const
{
    points.clear();
    tets.clear();

    // The two other points, in the order in which the tetrahedron is alike
    label from = -1;
    label to = -1;
    for (const label p : tets_[tet])
    {
        if (!e.found(p))
        {
            (from < 0 ? from : to) = p;
        }
    }
    if (!isAlike(tets_[tet], {e.first(), e.second(), from, to}))
    {
        Swap(from, to);
    }

    label t = tet;
    do
    {
        points.append(from);
        tets.append(t);

        const label next = neighbours_[t][tets_[t].find(from)];
        if (next < 0)
        {
            points.clear();
            tets.clear();
            return;
        }

        label p = -1;
        for (const label q : tets_[next])
        {
            p = e.found(q) || q == to ? p : q;
        }

        from = to;
        to = p;
        t = next;
    }
    while (t != tet);
}


labelList tetEditor::replace
(
    const labelUList& old,
    const UList<tetCell>& made
)
{
    DynamicList<triFace, 64> outerFaces;
    DynamicList<label, 64> outerTets;

    for (const label t : old)
    {
        for (label i = 0; i < 4; ++i)
        {
            if (neighbours_[t][i] < 0 || !old.found(neighbours_[t][i]))
            {
                outerFaces.append(triFace(tets_[t].face(i)));
                outerTets.append(neighbours_[t][i]);
            }
        }
    }

    for (label k = old.size(); k--;)
    {
        const label t = old[k];

        for (const label p : tets_[t])
        {
            tetLabels& around = pointTets_[p];
            around[around.find(t)] = around.last();
            around.remove();
        }
        tets_[t] = tetCell(-1, -1, -1, -1);
        unused_.append(t);
    }

    labelList labels(made.size());
    forAll(made, k)
    {
        if (unused_.empty())
        {
            unused_.append(tets_.size());
            tets_.append(tetCell());
            neighbours_.append(FixedList<label, 4>(-1));
        }

        const label t = unused_.remove();
        labels[k] = t;
        tets_[t] = made[k];

        for (const label p : made[k])
        {
            pointTets_[p].append(t);
        }
    }
    connect(labels, outerFaces, outerTets);

    return labels;
}


tetCellList tetEditor::remaining() const
{
    DynamicList<tetCell> tets(tets_.size());

    forAll(tets_, t)
    {
        if (!removed(t))
        {
            tets.append(tets_[t]);
        }
    }

    return tetCellList(std::move(tets));
}


List<FixedList<label, 4>> tetEditor::remainingNeighbours() const
{
    labelList positions(size(), -1);
    label n = 0;
    forAll(positions, t)
    {
        positions[t] = removed(t) ? -1 : n++;
    }

    List<FixedList<label, 4>> neighbours(n);
    forAll(positions, t)
    {
        for (label i = 0; !removed(t) && i < 4; ++i)
        {
            const label neighbour = neighbours_[t][i];
            neighbours[positions[t]][i] =
                neighbour < 0 ? -1 : positions[neighbour];
        }
    }

    return neighbours;
}

} // End namespace Foam

// ************************************************************************* //
