/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellPredicates.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The twelve tetrahedra on four of six points: the three subsets that span a
//  side are left out. Six are the corners, six have one edge below, another
//  one above and the side edge that joins them.
template<class Corner, class Other>
static bool checkPrism
(
    const point* const* p,
    const Corner& corner,
    const Other& other
)
{
    for (label k = 0; k < 3; ++k)
    {
        const label next = (k + 1)%3;
        const label prev = (k + 2)%3;

        const point& a = *p[k];
        const point& b = *p[k + 3];
        const point& aNext = *p[next];
        const point& bNext = *p[next + 3];
        const point& aPrev = *p[prev];
        const point& bPrev = *p[prev + 3];

        if
        (
            !corner(a, aNext, aPrev, b)
         || !corner(a, b, bNext, bPrev)
         || !other(a, aNext, bPrev, b)
         || !other(a, bNext, aPrev, b)
        )
        {
            return false;
        }
    }

    return true;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool isPositivePrism(const point* const* p)
{
    const tetSigns positive(p, 6);

    return checkPrism(p, positive, positive);
}


bool isPositiveCollapsedPrism(const point* const* p)
{
    const tetSigns positive(p, 6);

    const auto none = [](const point& a, const point& b, const point& c)
    {
        return &a == &b || &b == &c || &c == &a;
    };
    const auto positiveOrNone =
        [&](const point& a, const point& b, const point& c, const point& d)
    {
        return none(a, b, c) || none(a, b, d) || positive(a, b, c, d);
    };

    return checkPrism(p, positiveOrNone, positiveOrNone);
}


bool isPositiveLyingPrism(const point* const* p)
{
    const tetSigns positive(p, 6);
    bool any = false;

    return checkPrism
    (
        p,
        positive,
        [&](const point& a, const point& b, const point& c, const point& d)
        {
            any = any || positive(a, b, c, d);
            return true;
        }
    ) && any;
}

} // End namespace Foam

// ************************************************************************* //
