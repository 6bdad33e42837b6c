/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gmshScript.H"

#include <sstream>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Lengths in metres. The unit of IGES cannot be set: it is a millimetre.
static const char* const unit = "Geometry.OCCTargetUnit = \"M\";\n";
static const char* const lengthUnit = "Geometry.OCCScaling = 0.001;\n";


//- Faces of no solid go if there are solids
static const char* const leaveOutLoose = R"(
solids() = Volume{:};
faces() = Surface{:};
loose() = {};
If (#solids() > 0)
    bounds() = Boundary{ Volume{solids()}; };
    For i In {0 : #bounds() - 1}
        bounds(i) = Fabs(bounds(i));
    EndFor
    loose() = faces();
    loose() -= bounds();
    faces() -= loose();
EndIf
If (#loose() > 0)
    Recursive Delete { Surface{loose()}; }
EndIf
)";


//- Solids that touch or overlap are divided, so that they share faces
static const char* const uniteSolids = R"(
If (#solids() > 1)
    Coherence;
    solids() = Volume{:};
    faces() = Surface{:};
EndIf
)";


//- Formats of gmsh are not for labels with a percent sign
static const char* const writeModel = R"(
Printf("loose %.0f", #loose()) > model;
For i In {0 : #solids() - 1}
    label = StrReplace(Str(Volume{solids(i)}), "%", "");
    Printf(StrCat("solid ", label)) >> model;
    bounds() = Boundary{ Volume{solids(i)}; };
    For j In {0 : #bounds() - 1}
        Printf("bound %.0f", Fabs(bounds(j))) >> model;
    EndFor
EndFor
For i In {0 : #faces() - 1}
    label = StrReplace(Str(Surface{faces(i)}), "%", "");
    Printf("face %.0f", faces(i)) >> model;
    Printf(StrCat("label ", label)) >> model;
EndFor
)";


static const char* const defaultEdge = R"(
maxEdge = 1;
If (#faces() > 0)
    box() = BoundingBox Surface{faces()};
    dx = box(3) - box(0);
    dy = box(4) - box(1);
    dz = box(5) - box(2);
    maxEdge = 0.03*Sqrt(dx*dx + dy*dy + dz*dz);
EndIf
)";


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

std::string gmshScript
(
    const word& file,
    const word& model,
    const bool unite,
    const scalar maxEdge,
    const label nPerCircle,
    const label algorithm
)
{
    std::ostringstream os;
    os.precision(17);

    os  << "General.NumThreads = 1;\n"
        << "SetFactory(\"OpenCASCADE\");\n"
        << (file.ext() == "iges" ? lengthUnit : unit)
        << "model = \"" << model << "\";\n"
        << "Merge \"" << file << "\";\n"
        << leaveOutLoose << (unite ? uniteSolids : "") << writeModel;

    if (maxEdge > 0)
    {
        os  << "maxEdge = " << maxEdge << ";\n";
    }
    else
    {
        os  << defaultEdge;
    }

    os  << "Mesh.MshFileVersion = 2.2;\n"
        << "Mesh.MeshSizeMax = maxEdge;\n"
        << "Mesh.MeshSizeMin = maxEdge/20;\n"
        << "Mesh.MeshSizeFromCurvature = " << nPerCircle << ";\n"
        << "Mesh.Algorithm = " << algorithm << ";\n";

    return os.str();
}

} // End namespace Foam

// ************************************************************************* //
