/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

namespace Foam
{

// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

template<class Type>
List<message> columnTeam::toCopies(const UList<Type>& values) const
{
    List<message> all(size());
    forAll(all, p)
    {
        all[p].addList
        (
            List<Type>(UIndirectList<Type>(values, share_->sent[p]))
        );
    }

    return all;
}


template<class Type>
void columnTeam::update(UList<Type>& values) const
{
    if (isAlone())
    {
        return;
    }

    const List<message> messages(exchange(toCopies(values)));
    forAll(messages, p)
    {
        messageReader reader(messages[p]);
        UIndirectList<Type>(values, share_->received[p]) =
            reader.list<Type>();
    }
}


template<class Type>
bool columnTeam::lowerToOwners(UList<Type>& values) const
{
    if (isAlone())
    {
        return false;
    }

    List<Type> ofOwners(values);
    update(ofOwners);

    bool lower = false;
    forAll(values, c)
    {
        lower = lower || ofOwners[c] < values[c];
        values[c] = min(values[c], ofOwners[c]);
    }

    return any(lower);
}


template<class Type, class Operation>
Type columnTeam::reduce(const Type& value, const Operation& op) const
{
    const List<Type> all(gather(List<Type>(1, value)));
    Type result(all[0]);
    for (label p = 1; p < all.size(); ++p)
    {
        result = op(result, all[p]);
    }

    return result;
}


template<class Type>
List<Type> columnTeam::pointsOnMaster(const UList<Type>& values) const
{
    if (isAlone())
    {
        return List<Type>(values);
    }

    const labelList points(share_->wallPoints());
    labelList own(findIndices(share_->isOwn, true));
    inplaceSubsetList
    (
        own, [&](const label c) { return c < points.size(); }
    );

    return toMaster(values, own, points, share_->nWallPoints, 1);
}


template<class Type>
List<Type> columnTeam::pointsFromMaster
(
    const UList<Type>& whole,
    const label nEach
) const
{
    return isAlone()
      ? List<Type>(whole) : askMaster(share_->wallPoints(), whole, nEach);
}


template<class Type>
void columnTeam::updatePoints(UList<Type>& values) const
{
    if (!isAlone())
    {
        List<Type> ofColumns
        (
            UIndirectList<Type>(values, share_->front.wallPoints)
        );
        update(ofColumns);
        std::copy_n(ofColumns.begin(), values.size(), values.begin());
    }
}


template<class Type>
bool columnTeam::lowerPointsToOwners(UList<Type>& values) const
{
    if (isAlone())
    {
        return false;
    }

    List<Type> ofColumns(UIndirectList<Type>(values, share_->front.wallPoints));
    const bool lower = lowerToOwners(ofColumns);
    std::copy_n(ofColumns.begin(), values.size(), values.begin());

    return lower;
}


template<class Type>
List<Type> columnTeam::some
(
    const UList<Type>& values,
    const labelUList& which,
    const label nEach
)
{
    List<Type> result(which.size()*nEach);
    forAll(which, i)
    {
        SubList<Type>(result, nEach, i*nEach) =
            SubList<Type>(values, nEach, which[i]*nEach);
    }

    return result;
}


template<class Type>
List<Type> columnTeam::askMaster
(
    const labelUList& labels,
    const UList<Type>& whole,
    const label nEach
) const
{
    List<message> asked(size());
    forAll(asked, p)
    {
        asked[p].addList(p == 0 ? labels : labelUList::null());
    }
    asked = exchange(asked);

    List<message> answers(size());
    forAll(answers, p)
    {
        messageReader reader(asked[p]);
        answers[p].addList(some(whole, reader.list<label>(), nEach));
    }
    const List<message> received(exchange(answers));
    messageReader reader(received[0]);

    return reader.list<Type>();
}


template<class Type>
List<Type> columnTeam::fromMaster
(
    const UList<Type>& whole,
    const label nEach
) const
{
    return isAlone()
      ? List<Type>(whole) : askMaster(share_->columns, whole, nEach);
}


template<class Type>
List<Type> columnTeam::valuesOf
(
    const labelUList& wholeColumns,
    const labelUList& owners,
    const UList<Type>& values,
    const label nEach
) const
{
    const labelListList places(invertOneToMany(size(), owners));
    List<message> asked(size());
    forAll(asked, p)
    {
        asked[p].addList
        (
            labelList(UIndirectList<label>(wholeColumns, places[p]))
        );
    }
    asked = exchange(asked);

    List<message> answers(size());
    forAll(answers, p)
    {
        messageReader reader(asked[p]);
        labelList columns(reader.list<label>());
        for (label& c : columns)
        {
            c = columnHere(c);
        }
        answers[p].addList(some(values, columns, nEach));
    }
    answers = exchange(answers);

    List<Type> result(wholeColumns.size()*nEach);
    forAll(answers, p)
    {
        messageReader reader(answers[p]);
        const List<Type> received(reader.list<Type>());
        forAll(places[p], i)
        {
            SubList<Type>(result, nEach, places[p][i]*nEach) =
                SubList<Type>(received, nEach, i*nEach);
        }
    }

    return result;
}


template<class Type>
List<Type> columnTeam::toMaster
(
    const UList<Type>& values,
    const labelUList& which,
    const labelUList& wholeLabels,
    const label nWhole,
    const label nEach
) const
{
    List<message> sent(size());
    forAll(sent, p)
    {
        const labelList own(p == 0 ? which : labelUList::null());
        sent[p].addList(labelList(UIndirectList<label>(wholeLabels, own)));
        sent[p].addList(some(values, own, nEach));
    }

    List<Type> result(isMaster() ? nWhole*nEach : 0);
    for (const message& m : exchange(sent))
    {
        messageReader reader(m);
        const labelList labels(reader.list<label>());
        const List<Type> received(reader.list<Type>());
        forAll(labels, i)
        {
            SubList<Type>(result, nEach, labels[i]*nEach) =
                SubList<Type>(received, nEach, i*nEach);
        }
    }

    return result;
}


template<class Type>
List<Type> columnTeam::onMaster
(
    const UList<Type>& values,
    const label nEach
) const
{
    return isAlone() ? List<Type>(values) : toMaster
    (
        values, findIndices(share_->isOwn, true), share_->columns,
        share_->nColumns, nEach
    );
}


template<class Type>
List<Type> columnTeam::facesOnMaster
(
    const UList<Type>& values,
    const UList<face>& columns
) const
{
    if (isAlone())
    {
        return List<Type>(values);
    }

    const labelList counted
    (
        subsetList
        (
            identity(columns.size()),
            [&](const label facei) { return counts(columns[facei]); }
        )
    );

    return toMaster(values, counted, share_->faces, share_->nFaces, 1);
}


template<class Type>
Map<Type> columnTeam::fromOwners(const Map<Type>& values) const
{
    if (isAlone())
    {
        return Map<Type>();
    }

    List<message> toOthers(size());
    forAll(toOthers, p)
    {
        DynamicList<label> places;
        DynamicList<Type> some;
        forAll(share_->sent[p], i)
        {
            const auto found = values.cfind(share_->sent[p][i]);
            if (found.found())
            {
                places.append(i);
                some.append(found.val());
            }
        }
        toOthers[p].addList(places);
        toOthers[p].addList(some);
    }

    Map<Type> result;
    const List<message> fromOthers(exchange(toOthers));
    forAll(fromOthers, p)
    {
        messageReader reader(fromOthers[p]);
        const labelList places(reader.list<label>());
        const List<Type> some(reader.list<Type>());
        forAll(places, i)
        {
            result.set(share_->received[p][places[i]], some[i]);
        }
    }

    return result;
}

} // End namespace Foam

// ************************************************************************* //
