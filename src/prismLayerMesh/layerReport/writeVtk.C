/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/


#include "writeVtk.H"
#include "endian.H"
#include "error.H"

#include <cstring>
#include <fstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Numbers as legacy VTK files have them: big-endian
class bigEndianWriter
{
    std::ofstream& os_;
    std::string buffer_;


    template<class Bits>
    void append(const Bits bits)
    {
        char bytes[sizeof(Bits)];
        std::memcpy(bytes, &bits, sizeof(Bits));
        buffer_.append(bytes, sizeof(Bits));

        if (buffer_.size() > 1000000)
        {
            flush();
        }
    }

    void flush()
    {
        os_.write(buffer_.data(), buffer_.size());
        buffer_.clear();
    }


public:

    explicit bigEndianWriter(std::ofstream& os)
    :
        os_(os)
    {}


    void add(const label value)
    {
        uint32_t bits = value;

        #ifdef WM_LITTLE_ENDIAN
        bits = endian::swap32(bits);
        #endif

        append(bits);
    }


    void add(const scalar value)
    {
        const double asDouble = value;
        uint64_t bits;
        std::memcpy(&bits, &asDouble, sizeof(bits));

        #ifdef WM_LITTLE_ENDIAN
        bits = endian::swap64(bits);
        #endif

        append(bits);
    }


    //- To be called after each array
    void end()
    {
        flush();
        os_ << '\n';
    }
};


static void writePoints(std::ofstream& os, const pointField& points)
{
    os << "POINTS " << points.size() << " double\n";

    bigEndianWriter writer(os);
    for (const point& p : points)
    {
        writer.add(p.x());
        writer.add(p.y());
        writer.add(p.z());
    }
    writer.end();
}


static void writeCells(std::ofstream& os, const vtkGrid& grid)
{
    const label nCells = grid.cellTypes.size();

    os << "CELLS " << nCells << ' ' << nCells + grid.cellPoints.size() << '\n';

    bigEndianWriter cells(os);
    for (label celli = 0; celli < nCells; ++celli)
    {
        const label start = grid.cellStarts[celli];
        const label end = grid.cellStarts[celli + 1];

        cells.add(end - start);

        for (label i = start; i < end; ++i)
        {
            cells.add(grid.cellPoints[i]);
        }
    }
    cells.end();

    os << "CELL_TYPES " << nCells << '\n';

    bigEndianWriter types(os);
    for (const vtkCell type : grid.cellTypes)
    {
        types.add(label(type));
    }
    types.end();
}


static void writeFields
(
    std::ofstream& os,
    const char* where,
    const label size,
    const UList<vtkFields::namedValues>& fields
)
{
    if (fields.empty())
    {
        return;
    }

    os  << where << ' ' << size << '\n'
        << "FIELD attributes " << fields.size() << '\n';

    for (const vtkFields::namedValues& field : fields)
    {
        os  << field.name.c_str() << ' ' << field.nComponents << ' '
            << size << " double\n";

        bigEndianWriter writer(os);
        for (const scalar value : field.values)
        {
            writer.add(value);
        }
        writer.end();
    }
}


static void checkSizes
(
    const fileName& file,
    const label size,
    const UList<vtkFields::namedValues>& fields
)
{
    for (const vtkFields::namedValues& field : fields)
    {
        if (field.values.size() != size*field.nComponents)
        {
            FatalErrorInFunction
                << "Field " << field.name << " for " << file << " has "
                << field.values.size()/field.nComponents
                << " values, not " << size << exit(FatalError);
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::vtkFields::add(const word& name, const UList<scalar>& field)
{
    fields_.append(namedValues{name, 1, scalarField(field)});
}


void Foam::vtkFields::add(const word& name, const UList<vector>& field)
{
    scalarField values(3*field.size());

    forAll(field, i)
    {
        for (direction d = 0; d < 3; ++d)
        {
            values[3*i + d] = field[i][d];
        }
    }

    fields_.append(namedValues{name, 3, std::move(values)});
}


void Foam::vtkFields::add(const word& name, const UList<symmTensor>& field)
{
    static const direction components[9] =
    {
        symmTensor::XX, symmTensor::XY, symmTensor::XZ,
        symmTensor::XY, symmTensor::YY, symmTensor::YZ,
        symmTensor::XZ, symmTensor::YZ, symmTensor::ZZ
    };

    scalarField values(9*field.size());

    forAll(field, i)
    {
        for (direction d = 0; d < 9; ++d)
        {
            values[9*i + d] = field[i][components[d]];
        }
    }

    fields_.append(namedValues{name, 9, std::move(values)});
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::writeVtk(const fileName& file, const vtkGrid& grid)
{
    const label nCells = grid.cellTypes.size();

    checkSizes(file, grid.points.size(), grid.pointFields.fields());
    checkSizes(file, nCells, grid.cellFields.fields());

    std::ofstream os(file, std::ios::binary);

    os  << "# vtk DataFile Version 2.0\n"
        << "harmonicPrismMesh\n"
        << "BINARY\n"
        << "DATASET UNSTRUCTURED_GRID\n";

    writePoints(os, grid.points);
    writeCells(os, grid);
    writeFields
    (
        os, "POINT_DATA", grid.points.size(), grid.pointFields.fields()
    );
    writeFields(os, "CELL_DATA", nCells, grid.cellFields.fields());

    os.close();

    if (!os)
    {
        FatalIOErrorInFunction(file)
            << "Cannot write " << file << exit(FatalIOError);
    }
}


// ************************************************************************* //
