/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "spaceRegions.H"
#include "boundBox.H"
#include "tetrahedralize.H"
#include "treeBoundBox.H"
#include "triangleIndex.H"
#include "wallChanges.H"

#include <queue>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A path has so many places at most
static constexpr label maxPlaces = 10;


namespace
{

//- Tetrahedra between triangles, and the widest paths through them
class tetPaths
{
    const tetMesh mesh_;

    //- The two tetrahedra of each triangle that is not of the surface
    HashTable<labelPair, triFace, triFace::Hash<>> cellsOf_;

public:

    tetPaths(const tetDomain& domain)
    :
        mesh_(tetrahedralize(domain))
    {
        const triangleIndex walls(makeTriangleIndex(domain.facets));
        forAll(mesh_.tets, t)
        {
            for (label i = 0; i < 4; ++i)
            {
                const triFace f(mesh_.tets[t].face(i));
                if (!walls.found(f))
                {
                    auto both = cellsOf_.find(f);
                    if (both.good())
                    {
                        (*both).second() = t;
                    }
                    else
                    {
                        cellsOf_.insert(f, labelPair(t, -1));
                    }
                }
            }
        }
    }

    label cellAt(const label p) const
    {
        forAll(mesh_.tets, t)
        {
            if (mesh_.tets[t].found(p))
            {
                return t;
            }
        }

        return -1;
    }

    //- Sets the width of the widest path from a cell to each cell, 0 if there
    //  is none, and the cell before it and the triangle there
    void findWidths
    (
        const label from,
        scalarField& widths,
        labelList& before,
        List<triFace>& through
    ) const
    {
        widths = scalarField(mesh_.tets.size(), Zero);
        before = labelList(mesh_.tets.size(), -1);
        through.setSize(mesh_.tets.size());
        std::priority_queue<std::pair<scalar, label>> front;
        widths[from] = GREAT;
        front.push({GREAT, from});
        while (!front.empty())
        {
            const std::pair<scalar, label> widest = front.top();
            front.pop();
            const label t = widest.second;
            if (widest.first < widths[t])
            {
                continue;
            }
            for (label i = 0; i < 4; ++i)
            {
                const triFace f(mesh_.tets[t].face(i));
                const auto both = cellsOf_.cfind(f);
                const label other =
                    !both.good() ? -1
                  : (*both).first() == t ? (*both).second() : (*both).first();
                const scalar width = min
                (
                    widths[t],
                    smallestHeight(mesh_.points, f.triFaceFace())
                );
                if (other >= 0 && width > widths[other])
                {
                    widths[other] = width;
                    before[other] = t;
                    through[other] = f;
                    front.push({width, other});
                }
            }
        }
    }

    const pointField& points() const { return mesh_.points; }
};


//- Returns the space around a surface, in a large box. After the points of the
//  surface come from and to.
tetDomain domainAround
(
    const wallSurface& surface,
    const point& from,
    const point& to
)
{
    tetDomain domain;
    domain.points = surface.points;
    domain.facets = surface.faces;
    domain.points.append(from);
    domain.points.append(to);

    boundBox box(domain.points, false);
    const vector wider(box.span() + vector::uniform(0.1*box.mag()));
    const treeBoundBox around(box.min() - wider, box.max() + wider);
    const label corner = domain.points.size();
    domain.points.append(around.points()());
    for (const face& side : treeBoundBox::faces)
    {
        for (label k = 1; k < 3; ++k)
        {
            face f({side[0], side[k], side[k + 1]});
            for (label& p : f)
            {
                p += corner;
            }
            domain.facets.append(f);
        }
    }

    return domain;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

leakPath findLeak
(
    const wallSurface& arrangement,
    const point& from,
    const point& to
)
{
    const label first = arrangement.points.size();
    const tetPaths paths(domainAround(arrangement, from, to));
    scalarField widths;
    labelList before;
    List<triFace> through;
    paths.findWidths(paths.cellAt(first), widths, before, through);

    leakPath path;
    DynamicList<point> places;
    places.append(to);
    label t = paths.cellAt(first + 1);
    for (; t >= 0 && before[t] >= 0; t = before[t])
    {
        const face f(through[t].triFaceFace());
        const scalar width = smallestHeight(paths.points(), f);
        if (width < path.width)
        {
            path.width = width;
            path.narrowest = f.centre(paths.points());
        }
        places.append(f.centre(paths.points()));
    }
    places.append(from);

    const label step = 1 + (places.size() - 1)/maxPlaces;
    DynamicList<point> some;
    for (label i = places.size() - 1; i > 0; i -= step)
    {
        some.append(places[i]);
    }
    some.append(to);
    path.places = some;

    return path;
}

} // End namespace Foam

// ************************************************************************* //
