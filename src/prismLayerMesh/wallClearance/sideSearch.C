/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideSearch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

sideSearch::sideSearch(const List<sidePatch>& sides)
:
    sides_(sides),
    parts_(sides.size())
{
    forAll(sides_, s)
    {
        const sidePatch& side = sides_[s];

        if (side.isPart())
        {
            parts_[s] = side.isCurved()
              ? side.shape
              : std::make_shared<const sideShape>(side.points, side.faces);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool sideSearch::isNear
(
    const label side,
    const point& x,
    const scalar distance
) const
{
    return mag(sides_[side].distance(x)) < distance
     && (!parts_[side] || parts_[side]->nearest(x, distance).hit());
}


bool sideSearch::putOnSides
(
    const point& from,
    const scalar distance,
    point& x,
    labelPair& sides
) const
{
    sides = labelPair(-1, -1);
    DynamicList<label> near;

    forAll(sides_, s)
    {
        const sidePatch& side = sides_[s];

        if (near.size() < 2 && isNear(s, x, distance))
        {
            sides[near.size()] = s;
            near.append(s);
        }
        else if
        (
            side.distance(x) > 0
         && (!parts_[s] || parts_[s]->hit(from, x).hit())
        )
        {
            return false;
        }
    }

    x = onAll(sides_, near, x);

    return true;
}

} // End namespace Foam

// ************************************************************************* //
