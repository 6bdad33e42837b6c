/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "processTeam.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The label of a process that has failed
static const label failed = -1;


namespace
{

class onlyProcess
:
    public processTeam
{
protected:

    virtual labelList exchangeLabels(const labelList& sent) const
    {
        return sent;
    }

    virtual void exchangeMessages
    (
        const List<message>& sent,
        List<message>& received
    ) const
    {
        received = sent;
    }

public:

    virtual label size() const { return 1; }

    virtual label rank() const { return 0; }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::string processTeam::firstReason(const std::string& own) const
{
    message reason;
    reason(own);
    const List<message> sent(size(), reason);
    List<message> received(size());

    labelList sizes(size(), reason.size());
    sizes = exchangeLabels(sizes);
    forAll(received, p)
    {
        received[p].setSize(sizes[p]);
    }
    exchangeMessages(sent, received);

    for (const message& m : received)
    {
        messageReader reader(m);
        const std::string text(reader.text());
        if (text.size())
        {
            return text;
        }
    }

    return std::string();
}


void processTeam::requireNoFailure(const labelList& received) const
{
    if (received.found(failed))
    {
        throw teamError(firstReason(std::string()));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const processTeam& processTeam::alone()
{
    static const onlyProcess team;

    return team;
}


bool processTeam::any(const bool isSo) const
{
    const labelList said(exchangeLabels(labelList(size(), label(isSo))));
    requireNoFailure(said);
    ++nCalls_;

    return said.found(label(true));
}


List<message> processTeam::exchange(const List<message>& sent) const
{
    labelList sizes(size());
    forAll(sizes, p)
    {
        sizes[p] = sent[p].size();
        nBytesSent_ += p == rank() ? 0 : sizes[p];
    }
    ++nCalls_;
    sizes = exchangeLabels(sizes);
    requireNoFailure(sizes);

    List<message> received(size());
    forAll(received, p)
    {
        received[p].setSize(sizes[p]);
    }
    exchangeMessages(sent, received);

    return received;
}


std::string processTeam::fail(const std::string& reason) const
{
    exchangeLabels(labelList(size(), failed));

    return firstReason(reason.empty() ? "unknown reason" : reason);
}

} // End namespace Foam

// ************************************************************************* //
