/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeElements.H"

#include <cstdint>
#include <string>
#include <vector>

namespace Foam
{

namespace
{

//- The arrays of a file: they are named in XML, and follow it as bytes
class vtuArrays
{
    std::ostream& os_;
    uint64_t nBytes_ = 0;
    std::vector<std::string> blocks_;

public:

    explicit vtuArrays(std::ostream& os)
    :
        os_(os)
    {}

    //- Names an array with some attributes
    template<class Value>
    void add(const char* attributes, const std::vector<Value>& values)
    {
        os_ << "<DataArray " << attributes
            << " format=\"appended\" offset=\"" << nBytes_ << "\"/>\n";

        const uint64_t n = values.size()*sizeof(Value);
        std::string block(reinterpret_cast<const char*>(&n), sizeof(n));
        block.append(reinterpret_cast<const char*>(values.data()), n);
        nBytes_ += block.size();
        blocks_.push_back(std::move(block));
    }

    void write() const
    {
        os_ << "<AppendedData encoding=\"raw\">\n_";
        for (const std::string& block : blocks_)
        {
            os_.write(block.data(), block.size());
        }
        os_ << "\n</AppendedData>\n";
    }
};

} // End anonymous namespace


//- Writes names as an array of texts: the codes of their characters
static void writeNames
(
    const char* name,
    const UList<elementGroup>& groups,
    std::ostream& os
)
{
    os  << "<DataArray type=\"String\" Name=\"" << name
        << "\" NumberOfTuples=\"" << groups.size() << "\" format=\"ascii\">\n";
    for (const elementGroup& group : groups)
    {
        for (const char c : group.name)
        {
            os  << int(static_cast<unsigned char>(c)) << ' ';
        }
        os  << "0\n";
    }
    os  << "</DataArray>\n";
}


//- Adds, for all elements of the mesh and then of the patches, the position of
//  their group, and -1 for the others
static void addGroups
(
    const char* attributes,
    const UList<elementGroup>& groups,
    const label first,
    const label nElements,
    vtuArrays& arrays
)
{
    std::vector<int32_t> values(nElements, -1);
    forAll(groups, i)
    {
        std::fill_n
        (
            values.begin() + first + groups[i].start, groups[i].size, i
        );
    }
    arrays.add(attributes, values);
}


static void addElements(const elementMesh& mesh, vtuArrays& arrays)
{
    std::vector<int64_t> connectivity, offsets;
    std::vector<uint8_t> types;

    for (const elementList* elements : {&mesh.cells, &mesh.faces})
    {
        for (label i = 0; i < elements->size(); ++i)
        {
            const elementShape shape = elements->shape(i);
            const labelList points(vtkPoints(shape, elements->points(i)));
            connectivity.insert
            (
                connectivity.end(), points.begin(), points.end()
            );
            offsets.push_back(connectivity.size());
            types.push_back(factsOf(shape).vtk);
        }
    }
    arrays.add("type=\"Int64\" Name=\"connectivity\"", connectivity);
    arrays.add("type=\"Int64\" Name=\"offsets\"", offsets);
    arrays.add("type=\"UInt8\" Name=\"types\"", types);
}


void writeVtu(const elementMesh& mesh, std::ostream& os)
{
    const uint16_t one = 1;
    const bool little = *reinterpret_cast<const char*>(&one) == 1;
    const label nElements = mesh.cells.size() + mesh.faces.size();
    vtuArrays arrays(os);

    os  << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\""
        << " version=\"1.0\" byte_order=\""
        << (little ? "LittleEndian" : "BigEndian")
        << "\" header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n";
    writeNames("zoneNames", mesh.zones, os);
    writeNames("patchNames", mesh.patches, os);
    os  << "</FieldData>\n<Piece NumberOfPoints=\"" << mesh.points.size()
        << "\" NumberOfCells=\"" << nElements << "\">\n<CellData>\n";
    addGroups
    (
        "type=\"Int32\" Name=\"zone\"", mesh.zones, 0, nElements, arrays
    );
    addGroups
    (
        "type=\"Int32\" Name=\"patch\"", mesh.patches, mesh.cells.size(),
        nElements, arrays
    );

    std::vector<double> coordinates;
    for (const point& x : mesh.points)
    {
        coordinates.insert(coordinates.end(), x.begin(), x.end());
    }
    os  << "</CellData>\n<Points>\n";
    arrays.add("type=\"Float64\" NumberOfComponents=\"3\"", coordinates);
    os  << "</Points>\n<Cells>\n";
    addElements(mesh, arrays);
    os  << "</Cells>\n</Piece>\n</UnstructuredGrid>\n";
    arrays.write();
    os  << "</VTKFile>\n";
}

} // End namespace Foam

// ************************************************************************* //
