/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hidingParts.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Samples that tell whether a part is inside of another
static constexpr label nNestSamples = 32;


//- Whether more than half of a part is inside of another one
static bool isNested(const givenPart& part, const givenPart& other)
{
    const label step = max(label(1), part.samples.size()/nNestSamples);
    label n = 0;
    label nWithin = 0;
    for (label i = 0; i < part.samples.size(); i += step)
    {
        const point& x = part.samples[i].x;
        ++n;
        nWithin += other.box.contains(x) && other.has(x);
    }

    return 2*nWithin > n;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

hidingParts::hidingParts
(
    const PtrList<givenPart>& parts,
    const label parti,
    const bool fluidOutside
)
:
    parts_(parts),
    own_(parts[parti])
{
    forAll(parts, j)
    {
        const givenPart& other = parts[j];
        const bool mayHide =
            j != parti && other.triangles.size()
         && (other.isSheet || own_.box.overlaps(other.box));
        if (mayHide && fluidOutside)
        {
            bodies_.append(j);
        }
        else if (mayHide && other.isClosed)
        {
            (isNested(own_, other) ? around_ : bodies_).append(j);
        }
    }
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

bool hidingParts::has(const label j, const point& x) const
{
    const givenPart& part = parts_[j];

    return (part.isSheet || part.box.contains(x)) && part.has(x);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalar hidingParts::nTriangles() const
{
    scalar n = 2*own_.triangles.size();
    for (const labelUList& some : {bodies_, around_})
    {
        for (const label j : some)
        {
            n += parts_[j].triangles.size();
        }
    }

    return n;
}


bool hidingParts::hide(const point& x, const vector& off) const
{
    const auto hasPlace = [&](const label j) { return has(j, x); };

    return
        anyOf(bodies_, hasPlace)
     || (around_.size() && !anyOf(around_, hasPlace))
     || (own_.isClosed && own_.has(x + off) && own_.has(x - off));
}

} // End namespace Foam

// ************************************************************************* //
