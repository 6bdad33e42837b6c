/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fuzzTally.H"
#include "ListOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Shares of all values, from the least to the largest
static void writeShares(const char* what, scalarList values)
{
    Foam::sort(values);
    const label last = values.size() - 1;
    Info<< "    " << what << ": least " << values[0]
        << ", 10 % " << values[last/10] << ", median " << values[last/2]
        << ", 90 % " << values[last - last/10] << ", largest " << values[last]
        << endl;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fuzzTally::fuzzTally()
:
    nRun_(randomSurfaces::nKinds, Zero),
    nFailed_(randomSurfaces::nKinds, Zero)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fuzzTally::writeFarFields() const
{
    Info<< "Far fields, refused/made:";
    for (const auto& kind : farFields_)
    {
        Info<< ' ' << kind.first.c_str() << ' ' << kind.second.nRefused << '/'
            << kind.second.n << (&kind == &*farFields_.rbegin() ? "" : ",");
    }

    Info<< nl << "    refused with good reason:";
    for (const auto& refusal : refusals_)
    {
        Info<< ' ' << refusal.first.c_str() << ' ' << refusal.second.n
            << " (-index " << refusal.second.first << ", ...)";
    }
    Info<< endl;

    if (weights_.size())
    {
        writeShares("largest non-orthogonality at the cut", nonOrthos_);
        writeShares("least weight at the cut", weights_);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fuzzTally::add(const fuzzCase& one, const fuzzResult& result)
{
    typedef fuzzResult::verdict verdict;

    nRun_[int(one.kind)] += 1;
    nFailed_[int(one.kind)] += result.what == verdict::failed;
    nSkipped_ += result.what == verdict::skipped;
    nNoField_ += result.noField.size() > 0;

    if (result.farField.size())
    {
        tally& kind = farFields_[result.farField];
        ++kind.n;
        kind.nRefused += result.refused.size() > 0;
    }
    if (result.refused.size())
    {
        tally& refusal = refusals_[result.refused];
        refusal.first = refusal.n ? refusal.first : one.index;
        ++refusal.n;
    }
    if (result.cut.n)
    {
        nonOrthos_.append(result.cut.maxNonOrtho);
        weights_.append(result.cut.minWeight);
    }
}


Foam::label Foam::fuzzTally::nRun() const
{
    return sum(nRun_);
}


Foam::label Foam::fuzzTally::nFailed() const
{
    return sum(nFailed_);
}


void Foam::fuzzTally::write(const scalar seconds) const
{
    Info<< nRun() << " cases (";

    forAll(nRun_, i)
    {
        Info<< (i ? ", " : "")
            << randomSurfaces::name(randomSurfaces::kind(i)) << ' '
            << nFailed_[i] << '/' << nRun_[i];
    }

    Info<< "), " << nSkipped_ << " skipped, " << nNoField_
        << " without field, " << nFailed() << " failed, "
        << label(seconds + 0.5) << " s" << endl;

    if (farFields_.size())
    {
        writeFarFields();
    }
}


// ************************************************************************* //
