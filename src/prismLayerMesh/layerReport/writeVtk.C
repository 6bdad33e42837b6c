/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeVtk.H"
#include "error.H"
#include "tensor.H"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Write values as Numbers, big-endian: what legacy VTK files have. OpenFOAM's
//  own writer of such files makes doubles floats, too coarse for thin layers
template<class Number, class Type>
static void writeNumbers(std::ostream& os, const UList<Type>& values)
{
    std::string bytes;
    bytes.reserve(values.size()*sizeof(Number));

    for (const Type& value : values)
    {
        const Number number = static_cast<Number>(value);
        char digits[sizeof(Number)];
        std::memcpy(digits, &number, sizeof(Number));

        #if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
        std::reverse(std::begin(digits), std::end(digits));
        #endif

        bytes.append(digits, sizeof(Number));
    }

    os.write(bytes.data(), bytes.size());
    os << '\n';
}


//- The components of vectors or tensors, one after the other
template<class Type>
static scalarField componentsOf(const UList<Type>& field)
{
    const direction n = pTraits<Type>::nComponents;
    scalarField values(n*field.size());
    forAll(field, i)
    {
        for (direction d = 0; d < n; ++d)
        {
            values[n*i + d] = field[i][d];
        }
    }

    return values;
}


static void writeFields
(
    std::ostream& os,
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
        writeNumbers<double>(os, field.values);
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void vtkFields::add(const word& name, const UList<scalar>& field)
{
    fields.append(namedValues{name, 1, scalarField(field)});
}


void vtkFields::add(const word& name, const UList<vector>& field)
{
    fields.append(namedValues{name, 3, componentsOf(field)});
}


void vtkFields::add(const word& name, const UList<symmTensor>& field)
{
    List<tensor> full(field.size());
    std::copy(field.begin(), field.end(), full.begin());
    fields.append(namedValues{name, 9, componentsOf(full)});
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void writeVtk(const fileName& file, const vtkGrid& grid)
{
    const label nCells = grid.cellTypes.size();

    checkSizes(file, grid.points.size(), grid.pointFields.fields);
    checkSizes(file, nCells, grid.cellFields.fields);

    std::ofstream os(file, std::ios::binary);

    os  << "# vtk DataFile Version 2.0\n"
        << "harmonicPrismMesh\n"
        << "BINARY\n"
        << "DATASET UNSTRUCTURED_GRID\n"
        << "POINTS " << grid.points.size() << " double\n";

    writeNumbers<double>(os, componentsOf(grid.points));
    os << "CELLS " << nCells << ' ' << grid.cells.size() << '\n';
    writeNumbers<int32_t>(os, grid.cells);
    os << "CELL_TYPES " << nCells << '\n';
    writeNumbers<int32_t>(os, grid.cellTypes);
    writeFields(os, "POINT_DATA", grid.points.size(), grid.pointFields.fields);
    writeFields(os, "CELL_DATA", nCells, grid.cellFields.fields);

    os.close();

    if (!os)
    {
        FatalIOErrorInFunction(file)
            << "Cannot write " << file << exit(FatalIOError);
    }
}

} // End namespace Foam

// ************************************************************************* //
