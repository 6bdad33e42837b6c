/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pstreamTeam.H"
#include "UIPstream.H"
#include "UOPstream.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const auto nonBlocking = UPstream::commsTypes::nonBlocking;


namespace
{

//- Switches communication on while it exists
class communicating
{
    const bool was_;

public:

    communicating()
    :
        was_(UPstream::parRun())
    {
        setParallel(true);
    }

    ~communicating()
    {
        setParallel(was_);
    }
};

}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

labelList pstreamTeam::exchangeLabels(const labelList& sent) const
{
    const communicating on;
    labelList received(size_);
    UPstream::allToAll(sent, received);

    return received;
}


void pstreamTeam::exchangeMessages
(
    const List<message>& sent,
    List<message>& received
) const
{
    const communicating on;
    const label start = UPstream::nRequests();

    forAll(received, p)
    {
        if (p != rank_ && received[p].size())
        {
            UIPstream::read
            (
                nonBlocking, p, received[p].data(), received[p].size()
            );
        }
    }
    forAll(sent, p)
    {
        if (p != rank_ && sent[p].size())
        {
            UOPstream::write
            (
                nonBlocking, p, sent[p].cdata(), sent[p].size()
            );
        }
    }
    received[rank_] = sent[rank_];
    UPstream::waitRequests(start);
}


void setParallel(const bool on)
{
    #if OPENFOAM >= 2106
    UPstream::parRun(on);
    #else
    UPstream::parRun() = on;
    #endif
}

} // End namespace Foam

// ************************************************************************* //
