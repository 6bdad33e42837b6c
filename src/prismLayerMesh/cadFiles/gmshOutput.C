/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gmshOutput.H"
#include "DynamicList.H"
#include "error.H"
#include "ListOps.H"

#include <cmath>
#include <sstream>

namespace Foam
{

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


// * * * * * * * * * * * * * * *  Gmsh Output  * * * * * * * * * * * * * * * //

[[noreturn]] static void failInMesh(const char* what)
{
    FatalErrorInFunction
        << "the mesh of gmsh " << what << exit(FatalError);

    std::abort();
}


//- Goes behind the line that begins a section of a mesh, and the number of
//  entries after it. Returns the number.
static label beginSection(std::istream& is, const std::string& section)
{
    std::string line;
    while (std::getline(is, line) && line != section)
    {}

    label n = -1;
    if (!(is >> n) || n < 0)
    {
        failInMesh("is broken: a section is missing");
    }

    return n;
}


//- Reads the points. Returns for each number of gmsh the label of the point, or
//  -1.
static labelList readPoints(std::istream& is, pointField& points)
{
    const label n = beginSection(is, "$Nodes");
    DynamicList<point> read;
    DynamicList<label> labels;
    for (label i = 0; i < n; ++i)
    {
        label number = -1;
        point p(Zero);
        is >> number >> p.x() >> p.y() >> p.z();

        if (!is || number < 0 || number > 100*(n + 1000))
        {
            failInMesh("has a broken point");
        }
        if (number >= labels.size())
        {
            labels.resize(number + 1, -1);
        }
        labels[number] = i;
        read.append(p);
    }
    points.transfer(read);

    return labelList(labels);
}


//- The rest of a line "solid <label>"
static string textAfter(std::istream& line)
{
    std::string text;
    std::getline(line >> std::ws, text);

    return text;
}


//- The text without what tells terminals about colours
static std::string withoutColours(const std::string& text)
{
    std::string plain;
    for (size_t i = 0; i < text.size(); ++i)
    {
        if (text[i] != '\033')
        {
            plain += text[i];
            continue;
        }
        while (i + 1 < text.size() && !std::isalpha(text[i]))
        {
            ++i;
        }
    }

    return plain;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList cadModel::nSolids() const
{
    label largest = 0;
    for (const label tag : faces)
    {
        largest = max(largest, tag);
    }

    labelList n(largest + 1, Zero);
    for (const labelList& tags : facesOfSolid)
    {
        for (const label tag : labelHashSet(tags))
        {
            if (tag < n.size())
            {
                ++n[tag];
            }
        }
    }

    return n;
}


cadModel readCadModel(std::istream& is)
{
    cadModel model;
    DynamicList<string> solids, labels;
    DynamicList<label> faces;
    DynamicList<labelList> bounds;
    std::string line, key;

    while (std::getline(is, line))
    {
        std::istringstream words(line);
        words >> key;
        label n = -1;

        if (key == "solid")
        {
            solids.append(textAfter(words));
            bounds.append(labelList());
        }
        else if (key == "label" && labels.size() < faces.size())
        {
            labels.append(textAfter(words));
        }
        else if (words >> n && n >= 0 && key == "face")
        {
            faces.append(n);
        }
        else if (n >= 0 && key == "bound" && bounds.size())
        {
            bounds.last().append(n);
        }
        else if (n >= 0 && key == "loose")
        {
            model.nLoose = n;
        }
        else
        {
            FatalErrorInFunction
                << "gmsh writes of the CAD file '" << line.c_str() << "'"
                << exit(FatalError);
        }
    }

    labels.resize(faces.size());
    model.solidLabels.transfer(solids);
    model.facesOfSolid.transfer(bounds);
    model.faces.transfer(faces);
    model.faceLabels.transfer(labels);

    return model;
}


cadTriangles readMsh(std::istream& is)
{
    cadTriangles mesh;
    const labelList labels(readPoints(is, mesh.points));
    const label n = beginSection(is, "$Elements");
    DynamicList<face> faces;
    DynamicList<label> tags;
    std::string line;
    std::getline(is, line);

    for (label i = 0; i < n && std::getline(is, line); ++i)
    {
        std::istringstream words(line);
        label number, type = -1, nTags = 0, group, tag = -1, other;
        words >> number >> type >> nTags >> group >> tag;

        if (type != 2)
        {
            continue;
        }
        for (label j = 2; j < nTags; ++j)
        {
            words >> other;
        }

        face f(3);
        for (label& p : f)
        {
            words >> p;
            if (!words || p < 0 || p >= labels.size() || labels[p] < 0)
            {
                failInMesh("has a broken triangle");
            }
            p = labels[p];
        }
        faces.append(f);
        tags.append(tag);
    }
    if (!is)
    {
        failInMesh("is truncated");
    }
    mesh.faces.transfer(faces);
    mesh.tags.transfer(tags);

    return mesh;
}


string errorsIn(std::istream& log)
{
    std::string line, errors;
    label n = 0;

    while (std::getline(log, line))
    {
        line = withoutColours(line);
        const bool isError =
            line.compare(0, 5, "Error") == 0
         || line.find("** ERR") != std::string::npos;

        if (isError && ++n <= 3)
        {
            errors += (errors.empty() ? "" : "; ") + line;
        }
    }

    return errors;
}


string versionIn(std::istream& log)
{
    const std::string before("[Gmsh ");
    std::string line;

    while (std::getline(log, line))
    {
        const auto start = line.find(before);
        const auto end = line.find_first_of(",]", start);

        if (start != std::string::npos && end != std::string::npos)
        {
            const auto first = start + before.size();

            return line.substr(first, end - first);
        }
    }

    return string();
}

} // End namespace Foam

// ************************************************************************* //
