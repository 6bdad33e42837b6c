/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "columnStates.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::columnStates::columnStates(const message& states)
{
    messageReader reader(states);
    places_ = reader.list<label>();
    points_ = reader.list<point>();
    thickness_ = reader.list<scalar>();
    causes_ = reader.list<squeezeCause>();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::columnState Foam::columnStates::operator[](const label i) const
{
    const label n = points_.size()/places_.size();

    return columnState
    {
        pointField(SubList<point>(points_, n, i*n)), thickness_[i], causes_[i]
    };
}


void Foam::columnStates::append(const label place, const columnState& state)
{
    places_.append(place);
    points_.append(state.points);
    thickness_.append(state.thickness);
    causes_.append(state.cause);
}


void Foam::columnStates::addTo(message& toOther) const
{
    toOther.addList(places_);
    toOther.addList(points_);
    toOther.addList(thickness_);
    toOther.addList(causes_);
}


// ************************************************************************* //
