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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::string processTeam::firstReason(const std::string& own) const
{
    message reason;
    reason.addText(own);
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
