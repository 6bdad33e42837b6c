/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "readLayerThickness.H"
#include "controlEntries.H"
#include "layerSpacing.H"

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

const Foam::wordList Foam::layerThicknessKeys
({
    "firstLayerThickness",
    "finalLayerThickness",
    "thickness",
    "expansionRatio",
    "yPlus"
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static constexpr scalar minThickness = 1e-12;
static constexpr scalar maxThickness = 1e6;
static constexpr scalar minRatio = 0.5;
static constexpr scalar maxRatio = 3;


//- What the dictionary gives
struct thicknessEntries
{
    bool hasFirst = false;
    bool hasFinal = false;
    bool hasTotal = false;
    bool hasRatio = false;

    scalar first = 0;
    scalar final = 0;
    scalar total = 0;
    scalar ratio = 0;

    label nHeights() const
    {
        return hasFirst + hasFinal + hasTotal;
    }
};


//- "firstLayerThickness, expansionRatio": those that the dictionary has
static string givenKeys(const dictionary& dict)
{
    string keys;

    for (const word& key : layerThicknessKeys)
    {
        if (dict.found(key, keyType::LITERAL))
        {
            keys += (keys.empty() ? "" : ", ") + key;
        }
    }

    return keys.empty() ? string("none") : keys;
}


static scalar readMandatory
(
    const dictionary& dict,
    const word& key,
    const scalar min,
    const scalar max
)
{
    scalar value = 0;

    if (!readBounded(dict, key, min, max, value))
    {
        entryError(dict, key)
            << "The entry " << key << " of " << dict.dictName()
            << " is missing" << exit(FatalIOError);
    }

    return value;
}


static scalar readYPlus(const dictionary& dict)
{
    checkKeys(dict, {"target", "U", "nu", "L"});

    return flatPlateThickness
    (
        readMandatory(dict, "target", 1e-3, 1e4),
        readMandatory(dict, "U", 1e-9, 1e6),
        readMandatory(dict, "nu", 1e-12, 1e3),
        readMandatory(dict, "L", 1e-9, 1e6)
    );
}


static thicknessEntries readEntries(const dictionary& dict)
{
    thicknessEntries given;

    const auto read = [&](const word& key, scalar& value)
    {
        return readBounded(dict, key, minThickness, maxThickness, value);
    };

    given.hasFirst = read("firstLayerThickness", given.first);
    given.hasFinal = read("finalLayerThickness", given.final);
    given.hasTotal = read("thickness", given.total);
    given.hasRatio =
        readBounded(dict, "expansionRatio", minRatio, maxRatio, given.ratio);

    const bool hasYPlus = dict.found("yPlus", keyType::LITERAL);

    if (given.nHeights() + given.hasRatio + hasYPlus > 2)
    {
        entryError(dict, dict.dictName())
            << "The layers of " << dict.dictName() << " are determined twice,"
            << " by " << givenKeys(dict).c_str() << nl
            << "Two of these are enough; yPlus is firstLayerThickness"
            << exit(FatalIOError);
    }

    if (hasYPlus)
    {
        if (given.hasFirst)
        {
            entryError(dict, "yPlus")
                << "Both yPlus and firstLayerThickness determine the first"
                << " layer of " << dict.dictName() << exit(FatalIOError);
        }

        given.first = readYPlus(dict.subDict("yPlus"));
        given.hasFirst = true;
    }

    return given;
}


//- Out of two heights of one layer
static layerThickness fitOneLayer
(
    const dictionary& dict,
    const thicknessEntries& given,
    const scalar ratio
)
{
    const scalar low = min
    (
        given.hasFirst ? given.first : VGREAT,
        min
        (
            given.hasFinal ? given.final : VGREAT,
            given.hasTotal ? given.total : VGREAT
        )
    );
    const scalar high = max(given.first, max(given.final, given.total));

    if (high - low > 1e-9*high)
    {
        entryError(dict, dict.dictName())
            << "One layer has one thickness, but "
            << givenKeys(dict).c_str() << " of " << dict.dictName()
            << " differ: " << low << " and " << high << exit(FatalIOError);
    }

    layerThickness result;
    result.firstLayerThickness = high;
    result.expansionRatio = ratio;

    return result;
}


//- alpha of layers from h1, or counted from the other end, to thickness
static scalar fitToThickness
(
    const dictionary& dict,
    const label n,
    const scalar height,
    const scalar thickness
)
{
    if (thickness <= height*(1 + 1e-9))
    {
        entryError(dict, "thickness")
            << "Value of thickness is " << thickness << "; with "
            << givenKeys(dict).c_str() << " and " << n
            << " layers it must be more than " << height
            << exit(FatalIOError);
    }

    return fittedRatio(n, height, thickness);
}


static layerThickness solve
(
    const dictionary& dict,
    const label n,
    const thicknessEntries& given,
    const scalar defaultRatio
)
{
    const scalar ratio = (given.hasRatio ? given.ratio : defaultRatio);

    if (n == 1)
    {
        return fitOneLayer(dict, given, ratio);
    }

    // Beyond this heights are not numbers
    if (n*mag(::log(ratio)) > 600)
    {
        entryError(dict, "expansionRatio")
            << "Heights of " << n << " layers of expansionRatio " << ratio
            << " are out of all bounds" << exit(FatalIOError);
    }

    layerThickness result;
    scalar& h1 = result.firstLayerThickness;
    scalar& alpha = result.expansionRatio;
    alpha = ratio;

    if (given.nHeights() == 1)
    {
        h1 =
            given.hasFirst ? given.first
          : given.hasFinal ? given.final/::pow(ratio, n - 1)
          : given.total/totalThickness(n, 1, ratio);
    }
    else if (!given.hasTotal)
    {
        h1 = given.first;
        alpha = ::pow(given.final/given.first, 1.0/(n - 1));
    }
    else if (!given.hasFinal)
    {
        h1 = given.first;
        alpha = fitToThickness(dict, n, given.first, given.total);
    }
    else
    {
        // Counted from the last layer the ratio is 1/alpha
        alpha = 1/fitToThickness(dict, n, given.final, given.total);
        h1 = given.final/::pow(alpha, n - 1);
    }

    return result;
}


static void checkDetermined
(
    const dictionary& dict,
    const word& what,
    const scalar value,
    const scalar min,
    const scalar max
)
{
    // Given bounds themselves pass in spite of rounding
    const scalar slack = 1e-9;

    if (!(value >= min*(1 - slack) && value <= max*(1 + slack)))
    {
        entryError(dict, dict.dictName())
            << "The " << what << " of " << dict.dictName()
            << " determined by " << givenKeys(dict).c_str() << " is " << value
            << "; it must be from " << min << " to " << max
            << exit(FatalIOError);
    }
}


static layerThickness determine
(
    const dictionary& dict,
    const label n,
    const thicknessEntries& given,
    const scalar defaultRatio
)
{
    const layerThickness result(solve(dict, n, given, defaultRatio));
    const scalar h1 = result.firstLayerThickness;
    const scalar alpha = result.expansionRatio;

    checkDetermined(dict, "expansionRatio", alpha, minRatio, maxRatio);
    checkDetermined
    (
        dict, "firstLayerThickness", h1, minThickness, maxThickness
    );
    checkDetermined
    (
        dict, "thickness",
        totalThickness(n, h1, alpha), minThickness, maxThickness
    );

    return result;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::layerThickness Foam::readLayerThickness
(
    const dictionary& dict,
    const label n
)
{
    const thicknessEntries given(readEntries(dict));

    if (given.nHeights() == 0)
    {
        entryError(dict, dict.dictName())
            << "The height of the layers of " << dict.dictName()
            << " is missing; given: " << givenKeys(dict).c_str() << nl
            << "Give firstLayerThickness, yPlus, finalLayerThickness or"
            << " thickness" << exit(FatalIOError);
    }

    return determine(dict, n, given, layerThickness().expansionRatio);
}


Foam::layerThickness Foam::readLayerThickness
(
    const dictionary& dict,
    const label n,
    const layerThickness& general
)
{
    thicknessEntries given(readEntries(dict));

    if (given.nHeights() == 0)
    {
        given.hasFirst = true;
        given.first = general.firstLayerThickness;
    }

    return determine(dict, n, given, general.expansionRatio);
}


Foam::scalar Foam::flatPlateThickness
(
    const scalar yPlus,
    const scalar U,
    const scalar nu,
    const scalar L
)
{
    const scalar skinFriction = 0.026/::pow(U*L/nu, 1.0/7);
    const scalar frictionVelocity = U*Foam::sqrt(0.5*skinFriction);

    return 2*yPlus*nu/frictionVelocity;
}


// ************************************************************************* //
