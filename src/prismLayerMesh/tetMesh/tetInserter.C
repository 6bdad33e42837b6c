/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetInserter.H"
#include "tetEditor.H"
#include "triangleIndex.H"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Tetrahedra on the way to a point, at most
static constexpr label maxSteps = 1000;


//- States of tetrahedra in cavity.known, and in cavity.reached
static constexpr char inSphere = 1, beyondSphere = 2, excluded = 3;
static constexpr char inCavity = 1, aroundCavity = 2;


// * * * * * * * * * * * * * * * * Tet States  * * * * * * * * * * * * * * * //

tetStates::entry& tetStates::place(const label tet)
{
    const std::size_t mask = table_.size() - 1;
    std::size_t k = (std::size_t(tet)*2654435761u >> 7) & mask;
    while (table_[k].use == use_ && table_[k].tet != tet)
    {
        k = (k + 1) & mask;
    }

    return table_[k];
}


char& tetStates::operator[](const label tet)
{
    entry* found = &place(tet);
    if (found->use != use_)
    {
        if (2*++nUsed_ > label(table_.size()))
        {
            std::vector<entry> old(4*table_.size(), entry{-1, -1, 0});
            old.swap(table_);
            for (const entry& e : old)
            {
                if (e.use == use_)
                {
                    place(e.tet) = e;
                }
            }
            found = &place(tet);
        }
        *found = entry{tet, use_, 0};
    }

    return found->state;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

tetInserter::tetInserter(const tetMesh& mesh, const faceList& facets)
:
    points_(mesh.points.begin(), mesh.points.end()),
    tets_(mesh.tets.size())
{
    const triangleIndex kept(makeTriangleIndex(facets));
    const auto neighbours(tetNeighbours(mesh.tets, mesh.points.size()));
    forAll(mesh.tets, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            tets_[t].points[i] = mesh.tets[t][i];
            tets_[t].neighbours[i] = neighbours[t][i];
            if
            (
                facets.size() && neighbours[t][i] >= 0
             && kept.lookup(triFace(mesh.tets[t].face(i)), -1) >= 0
            )
            {
                tets_[t].neighbours[i] = -1;
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int tetInserter::sideOf(const tetSide& side, const point& x) const
{
    const point* p[4];
    for (label i = 0; i < 4; ++i)
    {
        p[i] = i == side.corner ? &x : &corner(side.tet, i);
    }

    return orientation(*p[0], *p[1], *p[2], *p[3]);
}


label tetInserter::locate(const point& x, label t) const
{
    label before = -1;
    for (label n = 0; t >= 0 && n < maxSteps; ++n)
    {
        const label* across = tets_[t].neighbours;
        label i = 0;
        while
        (
            i < 4
         && (
                (across[i] >= 0 && across[i] == before)
             || sideOf(tetSide{t, i}, x) >= 0
            )
        )
        {
            ++i;
        }
        if (i == 4)
        {
            return t;
        }
        before = t;
        t = across[i];
    }

    return -1;
}


bool tetInserter::goes
(
    const point& x,
    const label t,
    pointCavity& cavity
) const
{
    char& state = cavity.known[t];
    if (state == 0)
    {
        state = isInSphere(t, x) ? inSphere : beyondSphere;
    }

    return state == inSphere;
}


void tetInserter::setCavity
(
    const point& x,
    const label container,
    pointCavity& cavity
) const
{
    cavity.tets.assign(1, container);
    cavity.sides.clear();
    cavity.around.clear();
    cavity.reached.clear();
    cavity.reached[container] = inCavity;
    for (std::size_t k = 0; k < cavity.tets.size(); ++k)
    {
        const label t = cavity.tets[k];
        for (label i = 0; i < 4; ++i)
        {
            const label other = tets_[t].neighbours[i];
            if (other >= 0)
            {
                char& state = cavity.reached[other];
                if (state == 0)
                {
                    state = goes(x, other, cavity) ? inCavity : aroundCavity;
                    (state == inCavity ? cavity.tets : cavity.around)
                        .push_back(other);
                }
                if (state == inCavity)
                {
                    continue;
                }
            }
            cavity.sides.push_back(tetSide{t, i});
        }
    }
}


bool tetInserter::excludeHidden
(
    const point& x,
    pointCavity& cavity
) const
{
    bool found = false;
    for (const tetSide& side : cavity.sides)
    {
        if (sideOf(side, x) <= 0)
        {
            found = true;
            cavity.known[side.tet] = excluded;
        }
    }

    return found;
}


bool tetInserter::findCavity
(
    const point& x,
    const label container,
    pointCavity& cavity
) const
{
    cavity.known.clear();
    cavity.known[container] = inSphere;
    do
    {
        setCavity(x, container, cavity);
    }
    while
    (
        excludeHidden(x, cavity) && cavity.known[container] != excluded
    );

    return cavity.known[container] != excluded;
}


void tetInserter::setLabels(const point& x, pointCavity& cavity)
{
    cavity.added = points_.size();
    points_.push_back(x);
    cavity.made = cavity.tets;
    cavity.made.resize(min(cavity.tets.size(), cavity.sides.size()));
    while (cavity.made.size() < cavity.sides.size())
    {
        cavity.made.push_back(tets_.size());
        tets_.push_back(linkedTet{{-1, -1, -1, -1}, {-1, -1, -1, -1}});
    }
}


void tetInserter::replace(const pointCavity& cavity, workspace& work)
{
    // Neighbours that are to be written: labels of the cavity may be new ones
    work.faces.clear();
    work.tets.clear();
    for (const tetSide& side : cavity.sides)
    {
        linkedTet made(tets_[side.tet]);
        made.points[side.corner] = cavity.added;
        work.tets.push_back(made);

        const label other = made.neighbours[side.corner];
        label i = 0;
        while (other >= 0 && tets_[other].neighbours[i] != side.tet)
        {
            ++i;
        }
        work.faces.push_back(tetSide{other, i});
    }

    for (const label t : cavity.tets)
    {
        tets_[t].points[0] = -1;
    }
    for (std::size_t k = 0; k < cavity.made.size(); ++k)
    {
        tets_[cavity.made[k]] = work.tets[k];
        const tetSide& across = work.faces[k];
        if (across.tet >= 0)
        {
            tets_[across.tet].neighbours[across.corner] = cavity.made[k];
        }
    }
    connect(cavity, work.faces);
}


tetSide& tetInserter::placeOf
(
    std::vector<tetSide>& table,
    const tetSide& side,
    const label added
) const
{
    const auto others = [&](const tetSide& s)
    {
        std::pair<label, label> ends(-1, -1);
        for (label j = 0; j < 4; ++j)
        {
            const label p = tets_[s.tet].points[j];
            if (j != s.corner && p != added)
            {
                ends = std::minmax({ends.first < 0 ? p : ends.first, p});
            }
        }

        return ends;
    };

    const auto ends(others(side));
    const std::size_t mask = table.size() - 1;
    std::size_t k = (31*std::size_t(ends.first) + ends.second) & mask;
    while (table[k].tet >= 0 && others(table[k]) != ends)
    {
        k = (k + 1) & mask;
    }

    return table[k];
}


void tetInserter::connect
(
    const pointCavity& cavity,
    std::vector<tetSide>& table
)
{
    std::size_t size = 16;
    while (size < 4*cavity.made.size())
    {
        size *= 2;
    }
    table.assign(size, tetSide{-1, -1});
    for (const label t : cavity.made)
    {
        for (label i = 0; i < 4; ++i)
        {
            if (tets_[t].points[i] == cavity.added)
            {
                continue;
            }
            tetSide& found = placeOf(table, tetSide{t, i}, cavity.added);
            if (found.tet < 0)
            {
                found = tetSide{t, i};
            }
            else
            {
                tets_[t].neighbours[i] = found.tet;
                tets_[found.tet].neighbours[found.corner] = t;
            }
        }
    }
}


label tetInserter::madeWith(const point& x, const pointCavity& cavity) const
{
    const auto hasPoint = [&](const label t)
    {
        for (label i = 0; i < 4; ++i)
        {
            // Not across the sides of the cavity: other threads work there
            if
            (
                tets_[t].points[i] != cavity.added
             && sideOf(tetSide{t, i}, x) < 0
            )
            {
                return false;
            }
        }

        return true;
    };

    return *std::find_if(cavity.made.begin(), cavity.made.end() - 1, hasPoint);
}


labelListList tetInserter::pointTets() const
{
    labelList sizes(nPoints(), 0);
    const auto forAllCorners = [&](const auto& visit)
    {
        for (label t = 0; t < nTets(); ++t)
        {
            for (label i = 0; i < 4 && !hasGone(t); ++i)
            {
                visit(t, tets_[t].points[i]);
            }
        }
    };
    forAllCorners([&](label, const label p) { ++sizes[p]; });

    labelListList tets(nPoints());
    forAll(tets, p)
    {
        tets[p].setSize(sizes[p]);
    }
    forAllCorners([&](const label t, const label p)
    {
        tets[p][--sizes[p]] = t;
    });

    return tets;
}


tetMesh tetInserter::mesh() const
{
    tetMesh made;
    made.points.setSize(points_.size());
    std::copy(points_.begin(), points_.end(), made.points.begin());
    DynamicList<tetCell> tets(tets_.size());
    for (const linkedTet& t : tets_)
    {
        const label* p = t.points;
        if (p[0] >= 0)
        {
            tets.append(tetCell(p[0], p[1], p[2], p[3]));
        }
    }
    made.tets.transfer(tets);

    return made;
}

} // End namespace Foam

// ************************************************************************* //
