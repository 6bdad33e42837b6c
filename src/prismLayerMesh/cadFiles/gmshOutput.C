/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gmshOutput.H"
#include "error.H"
#include "DynamicList.H"
#include "ListOps.H"

#include <cmath>
#include <sstream>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
