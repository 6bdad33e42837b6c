/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnTeam.H"
#include "ranges.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Index in an ascending list, -1 if it is not found
static label indexOf(const labelUList& ascending, const label value)
{
    const auto at = std::lower_bound(ascending.begin(), ascending.end(), value);

    return at != ascending.end() && *at == value ? at - ascending.begin() : -1;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label shareTable::here(const label whole) const
{
    return isAlone_ ? whole : indexOf(labels_.whole, whole);
}


void shareTable::unite(boolList& set) const
{
    if (isAlone_)
    {
        return;
    }

    // From copies to owners, then from owners to all copies
    const List<boolList> ofCopies(exchanged(set, labels_.received));
    forAll(ofCopies, p)
    {
        forAll(ofCopies[p], i)
        {
            bool& own = set[labels_.sent[p][i]];
            own = own || ofCopies[p][i];
        }
    }
    update(set);
}


columnTeam::columnTeam(const shareLabels& share, const processTeam& processes)
:
    share_(share),
    processes_(processes),
    isAlone_(processes.size() == 1 && share.columns.whole.empty()),
    columns(share.columns, processes),
    points(share.points, processes),
    faces(share.faces, processes)
{}


const columnTeam& columnTeam::alone()
{
    static const shareLabels all;
    static const columnTeam team(all, processTeam::alone());

    return team;
}


bool columnTeam::hasOwn(const labelUList& columns) const
{
    return anyOf(columns, [&](const label c) { return isOwn(c); });
}


labelList columnTeam::ownOf(const labelUList& columns) const
{
    return isAlone_ ? labelList(columns)
      : subsetList(columns, [&](const label c) { return isOwn(c); });
}


labelList columnTeam::withOwn
(
    const labelUList& which,
    const UList<face>& faces
) const
{
    return isAlone_ ? labelList(which) : subsetList
    (
        which, [&](const label facei) { return hasOwn(faces[facei]); }
    );
}


string columnTeam::textOfMaster(const string& text) const
{
    List<char> characters(text.size());
    std::copy(text.begin(), text.end(), characters.begin());
    broadcast(characters);

    return string(std::string(characters.cdata(), characters.size()));
}

} // End namespace Foam

// ************************************************************************* //
