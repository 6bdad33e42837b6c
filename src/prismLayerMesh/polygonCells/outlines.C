/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "outlines.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void outlineFinder::setBoundary(const UList<cornerQuad>& quads)
{
    // An edge goes together with its opposite
    rest_.clear();
    walk_.clear();
    for (const cornerQuad& quad : quads)
    {
        for (label k = 0; k < 4; ++k)
        {
            const labelPair e(quad[k], quad[(k + 1) % 4]);
            if (e.first() == e.second())
            {
                continue;
            }
            const label opposite = rest_.find(labelPair(e.second(), e.first()));
            if (opposite >= 0)
            {
                rest_[opposite] = rest_.last();
                rest_.remove();
            }
            else
            {
                rest_.append(e);
            }
        }
    }
}


bool outlineFinder::setNext()
{
    // A walk along the edges. Where it comes to a point for the second time, it
    // has gone round an outline.
    while (rest_.size())
    {
        label next = 0;
        while
        (
            walk_.size() && next < rest_.size()
         && rest_[next].first() != walk_.last()
        )
        {
            ++next;
        }
        if (next == rest_.size())
        {
            walk_.clear();
            continue;
        }
        const labelPair e(rest_[next]);
        rest_[next] = rest_.last();
        rest_.remove();
        if (walk_.empty())
        {
            walk_.append(e.first());
        }
        const label met = walk_.find(e.second());
        if (met < 0)
        {
            walk_.append(e.second());
            continue;
        }
        outline_ = SubList<label>(walk_, walk_.size() - met, met);
        walk_.setSize(met);
        if (met > 0)
        {
            walk_.append(e.second());
        }

        return true;
    }

    return false;
}

} // End namespace Foam

// ************************************************************************* //
