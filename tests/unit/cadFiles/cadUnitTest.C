/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepFaceNames.H"

#include <gtest/gtest.h>

#include <sstream>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static word unitOf(const std::string& text, const word& type = "step")
{
    std::istringstream is(text);

    return cadUnit(is, type);
}


//- A line of the global section of an IGES file
static std::string globalLine(const std::string& text)
{
    std::string line(text);
    line.resize(72, ' ');

    return line + "G      1\n";
}


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(cadUnit, ofStepFiles)
{
    const std::string length("DATA;\n#3=(LENGTH_UNIT()NAMED_UNIT(*)\n");

    EXPECT_EQ(unitOf(length + " SI_UNIT( .MILLI., .METRE.));"), "millimetre");
    EXPECT_EQ(unitOf(length + "SI_UNIT($,.METRE.));"), "metre");
    EXPECT_EQ(unitOf("ISO-10303-21;\n#1=PRODUCT('a');"), "");
}


TEST(cadUnit, anInchIsDefinedByMillimetres)
{
    const std::string millimetre
    (
        "#1=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
    );
    const std::string inch
    (
        "#3=(CONVERSION_BASED_UNIT('INCH',#2)LENGTH_UNIT()NAMED_UNIT(#4));\n"
    );

    EXPECT_EQ(unitOf(millimetre + inch), "inch");
    EXPECT_EQ(unitOf(inch + millimetre), "inch");
}


TEST(cadUnit, ofIgesFiles)
{
    const std::string start("1H,,1H;,4Hbody,");

    EXPECT_EQ(unitOf(globalLine(start + "1.,2,2HMM,1,"), "iges"), "millimetre");
    EXPECT_EQ(unitOf(globalLine(start + "1.,1,4HINCH,1,"), "iges"), "inch");
    EXPECT_EQ(unitOf(globalLine(start), "iges"), "");
}


TEST(cadUnit, brepHasNone)
{
    EXPECT_EQ(unitOf("SI_UNIT(.MILLI.,.METRE.) LENGTH_UNIT", "brep"), "");
}


// ************************************************************************* //
