/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallVisibility.H"
#include "FixedList.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Some of the normals, at most three, and the point of their hull that is
//  nearest to the origin
struct supportSet
{
    FixedList<vector, 4> normals;
    label size = 0;
    vector nearest = Zero;
};

} // End anonymous namespace


//- Point nearest to the origin on the line or plane through one to three
//  points; false where it is not inside their hull
static bool nearestInside
(
    const vector& a,
    const vector* b,
    const vector* c,
    vector& nearest
)
{
    if (!b)
    {
        nearest = a;
        return true;
    }

    const vector ab = *b - a;

    if (!c)
    {
        const scalar s = -(a & ab)/max(magSqr(ab), VSMALL);
        nearest = a + s*ab;
        return s > 0 && s < 1;
    }

    const vector ac = *c - a;
    const vector n = ab ^ ac;
    const scalar nn = magSqr(n);

    if (nn < VSMALL)
    {
        return false;
    }

    const scalar s = -((a ^ ac) & n)/nn;
    const scalar t = -((ab ^ a) & n)/nn;
    nearest = a + s*ab + t*ac;

    return s > 0 && t > 0 && s + t < 1;
}


//- Replace the set by its subset of at most three whose hull holds the point
//  of the whole hull nearest to the origin
static supportSet reduced(const supportSet& set)
{
    supportSet best;
    scalar bestSqr = GREAT;

    // A subset contains the normal that came last: without it the nearest
    // point would not have moved
    const vector& last = set.normals[set.size - 1];

    auto consider = [&](const vector* b, const vector* c)
    {
        vector x;
        if (nearestInside(last, b, c, x) && magSqr(x) < bestSqr)
        {
            bestSqr = magSqr(x);
            best.nearest = x;
            best.size = 0;
            if (b) best.normals[best.size++] = *b;
            if (c) best.normals[best.size++] = *c;
            best.normals[best.size++] = last;
        }
    };

    consider(nullptr, nullptr);

    for (label i = 0; i < set.size - 1; ++i)
    {
        consider(&set.normals[i], nullptr);

        for (label j = 0; j < i; ++j)
        {
            consider(&set.normals[i], &set.normals[j]);
        }
    }

    return best;
}


static label lowestAlong(const UList<vector>& normals, const vector& d)
{
    return findMin(scalarField(normals & d));
}


static bool holdsOrigin(const supportSet& set)
{
    if (set.size < 4)
    {
        return false;
    }

    for (label i = 0; i < 4; ++i)
    {
        const vector& a = set.normals[(i + 1) % 4];
        const vector n =
            (set.normals[(i + 2) % 4] - a) ^ (set.normals[(i + 3) % 4] - a);

        // The origin on the same side as the fourth point
        if (((set.normals[i] - a) & n)*(-a & n) <= 0)
        {
            return false;
        }
    }

    return true;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

visibilityCone makeVisibilityCone(const UList<vector>& normals)
{
    const visibilityCone empty{normalised(sum(normals)), 0};

    supportSet set;
    set.size = 1;
    set.normals[0] = normals[lowestAlong(normals, sum(normals))];
    set.nearest = set.normals[0];

    // Each round lowers |nearest|, so no set comes twice; the bound only
    // guards against rounding
    for (label round = 0; round < 4*normals.size() + 16; ++round)
    {
        const vector& added = normals[lowestAlong(normals, set.nearest)];
        const scalar nearestSqr = magSqr(set.nearest);

        if ((added & set.nearest) >= nearestSqr - visibilityControls::rounding)
        {
            break;
        }

        set.normals[set.size++] = added;

        if (holdsOrigin(set))
        {
            return empty;
        }

        set = reduced(set);

        if (magSqr(set.nearest) >= nearestSqr)
        {
            break;
        }
    }

    const vector axis = normalised(set.nearest);
    const scalar cosine = normals[lowestAlong(normals, axis)] & axis;

    // Below this the sign of d.n_f is not above the rounding of the normals
    if (cosine < 1e-9)
    {
        return empty;
    }

    return visibilityCone{axis, cosine};
}

} // End namespace Foam

// ************************************************************************* //
