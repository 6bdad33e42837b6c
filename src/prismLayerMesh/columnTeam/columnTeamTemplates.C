/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

namespace Foam
{

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

template<class Type>
List<Type> shareTable::valuesAt
(
    const UList<Type>& values,
    const labelUList& places,
    const label nEach
)
{
    List<Type> result(places.size()*nEach);
    forAll(places, i)
    {
        SubList<Type>(result, nEach, i*nEach) =
            SubList<Type>(values, nEach, places[i]*nEach);
    }

    return result;
}


template<class Type>
void shareTable::setValues
(
    const UList<Type>& values,
    const labelUList& places,
    const label nEach,
    UList<Type>& all
)
{
    forAll(places, i)
    {
        SubList<Type>(all, nEach, places[i]*nEach) =
            SubList<Type>(values, nEach, i*nEach);
    }
}


template<class Type>
List<List<Type>> shareTable::exchanged
(
    const UList<Type>& values,
    const labelListList& places
) const
{
    List<List<Type>> lists(places.size());
    forAll(lists, p)
    {
        lists[p] = valuesAt(values, places[p], 1);
    }

    return processes_.exchangeLists(std::move(lists));
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

template<class Type>
void shareTable::update(UList<Type>& values) const
{
    if (isAlone_)
    {
        return;
    }

    const List<List<Type>> ofOwners(exchanged(values, labels_.sent));
    forAll(ofOwners, p)
    {
        setValues(ofOwners[p], labels_.received[p], 1, values);
    }
}


template<class Type>
bool shareTable::lower(UList<Type>& values) const
{
    if (isAlone_)
    {
        return false;
    }

    List<Type> ofOwners(values);
    update(ofOwners);

    bool isLower = false;
    forAll(values, i)
    {
        isLower = isLower || ofOwners[i] < values[i];
        values[i] = min(values[i], ofOwners[i]);
    }

    return processes_.any(isLower);
}


template<class Type>
Map<Type> shareTable::ofOwners(const Map<Type>& values) const
{
    Map<Type> result;
    if (isAlone_)
    {
        return result;
    }

    // Places in the lists of copies, with values
    List<List<std::pair<label, Type>>> lists(processes_.size());
    forAll(lists, p)
    {
        DynamicList<std::pair<label, Type>> items;
        forAll(labels_.sent[p], i)
        {
            const auto found = values.cfind(labels_.sent[p][i]);
            if (found.found())
            {
                items.append(std::pair<label, Type>(i, found.val()));
            }
        }
        lists[p] = std::move(items);
    }

    lists = processes_.exchangeLists(std::move(lists));
    forAll(lists, p)
    {
        for (const auto& item : lists[p])
        {
            result.set(labels_.received[p][item.first], item.second);
        }
    }

    return result;
}


template<class Type>
List<Type> shareTable::fromMaster(List<Type> whole, const label nEach) const
{
    if (isAlone_)
    {
        return whole;
    }

    labelListList asked(processes_.size());
    asked[0] = labels_.whole;
    asked = processes_.exchangeLists(std::move(asked));

    List<List<Type>> answers(asked.size());
    forAll(answers, p)
    {
        answers[p] = valuesAt(whole, asked[p], nEach);
    }

    return processes_.exchangeLists(std::move(answers))[0];
}


template<class Type>
List<Type> shareTable::onMaster
(
    const UList<Type>& values,
    const label nEach
) const
{
    if (isAlone_)
    {
        return List<Type>(values);
    }

    const labelList own(findIndices(labels_.isOwn, true));
    labelListList places(processes_.size());
    List<List<Type>> items(processes_.size());
    places[0] = UIndirectList<label>(labels_.whole, own);
    items[0] = valuesAt(values, own, nEach);
    places = processes_.exchangeLists(std::move(places));
    items = processes_.exchangeLists(std::move(items));

    List<Type> whole(processes_.isMaster() ? labels_.nWhole*nEach : 0);
    forAll(items, p)
    {
        setValues(items[p], places[p], nEach, whole);
    }

    return whole;
}


template<class Type>
List<Type> shareTable::at
(
    const labelUList& whole,
    const labelUList& owners,
    const UList<Type>& values,
    const label nEach
) const
{
    const labelListList places(invertOneToMany(processes_.size(), owners));
    labelListList asked(exchanged(whole, places));

    List<List<Type>> answers(asked.size());
    forAll(answers, p)
    {
        for (label& i : asked[p])
        {
            i = here(i);
        }
        answers[p] = valuesAt(values, asked[p], nEach);
    }
    answers = processes_.exchangeLists(std::move(answers));

    List<Type> result(whole.size()*nEach);
    forAll(answers, p)
    {
        setValues(answers[p], places[p], nEach, result);
    }

    return result;
}

} // End namespace Foam

// ************************************************************************* //
