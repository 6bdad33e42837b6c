/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnTeam.H"
#include "ListOps.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Index in an ascending list, -1 if it is not found
static label indexOf(const labelUList& ascending, const label value)
{
    const auto at =
        std::lower_bound(ascending.begin(), ascending.end(), value);

    return at != ascending.end() && *at == value ? at - ascending.begin() : -1;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const columnTeam& columnTeam::alone()
{
    static const columnTeam team;

    return team;
}


bool columnTeam::hasOwn(const labelUList& columns) const
{
    return std::any_of
    (
        columns.begin(), columns.end(),
        [&](const label c) { return isOwn(c); }
    );
}


label columnTeam::columnHere(const label whole) const
{
    return share_ ? indexOf(share_->columns, whole) : whole;
}


labelList columnTeam::ownOf(const labelUList& columns) const
{
    return share_
      ? subsetList(columns, [&](const label c) { return isOwn(c); })
      : labelList(columns);
}


labelList columnTeam::withOwn
(
    const labelUList& which,
    const UList<face>& faces
) const
{
    return share_
      ? subsetList
        (
            which, [&](const label facei) { return hasOwn(faces[facei]); }
        )
      : labelList(which);
}


string columnTeam::textOfMaster(const string& text) const
{
    List<char> characters(text.size());
    std::copy(text.begin(), text.end(), characters.begin());
    broadcast(characters);

    return string(std::string(characters.cdata(), characters.size()));
}


void columnTeam::unite(boolList& columns) const
{
    if (isAlone())
    {
        return;
    }

    // From copies to owners, then from owners to all copies
    List<message> toOwners(size());
    forAll(toOwners, p)
    {
        toOwners[p].addList
        (
            List<bool>(UIndirectList<bool>(columns, share_->received[p]))
        );
    }

    const List<message> messages(exchange(toOwners));
    forAll(messages, p)
    {
        messageReader reader(messages[p]);
        const List<bool> found(reader.list<bool>());
        forAll(found, i)
        {
            bool& own = columns[share_->sent[p][i]];
            own = own || found[i];
        }
    }
    update(columns);
}

} // End namespace Foam

// ************************************************************************* //
