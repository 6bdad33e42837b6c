/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#ifdef HAVE_CGNS
#include <cgnslib.h>
#endif

#include "writeCgns.H"
#include "error.H"
#include "HashSet.H"

#include <vector>

#ifndef HAVE_CGNS

void Foam::writeCgns(const elementMesh& mesh, const fileName& file)
{
    FatalErrorInFunction
        << "This program was built without the library libcgns (package"
        << " libcgns-dev of Debian). Install libcgns, and run ./Allwmake again:"
        << " it builds the program anew."
        << exit(FatalError);
}

#else

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- An open file, and its base and zone
class cgnsFile
{
    int file_ = 0;
    int base_ = 0;
    int zone_ = 0;

    static void check(int status);

public:

    cgnsFile(const fileName& file, const elementMesh& mesh);

    void writePoints(const elementMesh& mesh);

    //- Writes a group of elements. The first element of the list has the number
    //  first.
    void writeSection
    (
        const elementGroup& group,
        const elementList& elements,
        label first
    );

    //- Writes the condition of a patch, described by the name of the patch
    void writeBoundary
    (
        const elementGroup& patch,
        const word& fullName,
        label first,
        label dimension
    );

    void close() { check(cg_close(file_)); }
};

} // End anonymous namespace


static ElementType_t cgnsType(const elementShape shape)
{
    static const ElementType_t types[nElementShapes] =
    {
        BAR_2, TRI_3, QUAD_4, TETRA_4, PYRA_5, PENTA_6, HEXA_8
    };

    return types[int(shape)];
}


//- Returns the groups with names as CGNS allows them: a name of more than 32
//  characters ends with the number of the group. Adds all names to those given.
static List<elementGroup> withShortNames
(
    const UList<elementGroup>& groups,
    HashSet<word>& names
)
{
    const label longest = 32;
    List<elementGroup> named(groups);

    forAll(named, i)
    {
        word& name = named[i].name;
        if (label(name.size()) > longest)
        {
            const word end("~" + Foam::name(i + 1));
            name = name.substr(0, longest - end.size()) + end;
            WarningInFunction
                << "The names of CGNS have 32 characters: "
                << groups[i].name << " is called " << name << endl;
        }
        if (!names.insert(name))
        {
            FatalErrorInFunction
                << "Of the patches and cellZones, two are called " << name
                << ": CGNS needs different names" << exit(FatalError);
        }
    }

    return named;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void cgnsFile::check(const int status)
{
    if (status != CG_OK)
    {
        FatalErrorInFunction
            << "libcgns: " << cg_get_error() << exit(FatalError);
    }
}


cgnsFile::cgnsFile(const fileName& file, const elementMesh& mesh)
{
    const cgsize_t sizes[3] = {mesh.points.size(), mesh.cells.size(), 0};

    check(cg_set_file_type(CG_FILE_HDF5));
    check(cg_open(file.c_str(), CG_MODE_WRITE, &file_));
    check
    (
        cg_base_write(file_, "Base", mesh.dimension, mesh.dimension, &base_)
    );
    check(cg_goto(file_, base_, "end"));
    check(cg_dataclass_write(Dimensional));
    check(cg_units_write(Kilogram, Meter, Second, Kelvin, Radian));
    check(cg_zone_write(file_, base_, "Zone", sizes, Unstructured, &zone_));
}


void cgnsFile::writePoints(const elementMesh& mesh)
{
    const char* names[] = {"CoordinateX", "CoordinateY", "CoordinateZ"};
    const double length[] = {0, 1, 0, 0, 0};
    std::vector<double> values(mesh.points.size());

    for (direction i = 0; i < mesh.dimension; ++i)
    {
        forAll(mesh.points, p)
        {
            values[p] = mesh.points[p][i];
        }
        int coordinate;
        check
        (
            cg_coord_write
            (
                file_, base_, zone_, RealDouble, names[i], values.data(),
                &coordinate
            )
        );
        check
        (
            cg_goto
            (
                file_, base_, "Zone_t", zone_, "GridCoordinates_t", 1,
                names[i], 0, "end"
            )
        );
        check(cg_exponents_write(RealDouble, length));
    }
}


void cgnsFile::writeSection
(
    const elementGroup& group,
    const elementList& elements,
    const label first
)
{
    const cgsize_t start = first + group.start;
    const cgsize_t end = start + group.size - 1;
    std::vector<cgsize_t> labels, mixed, offsets(1, 0);
    bool isMixed = false;

    for (label i = group.start; i < group.start + group.size; ++i)
    {
        isMixed = isMixed || elements.shape(i) != elements.shape(group.start);
        mixed.push_back(cgnsType(elements.shape(i)));
        for (const label p : elements.points(i))
        {
            labels.push_back(p + 1);
            mixed.push_back(p + 1);
        }
        offsets.push_back(mixed.size());
    }

    int section;
    const char* name = group.name.c_str();
    check
    (
        isMixed
      ? cg_poly_section_write
        (
            file_, base_, zone_, name, MIXED, start, end, 0, mixed.data(),
            offsets.data(), &section
        )
      : cg_section_write
        (
            file_, base_, zone_, name, cgnsType(elements.shape(group.start)),
            start, end, 0, labels.data(), &section
        )
    );
}


void cgnsFile::writeBoundary
(
    const elementGroup& patch,
    const word& fullName,
    const label first,
    const label dimension
)
{
    const cgsize_t start = first + patch.start;
    const cgsize_t range[2] = {start, start + patch.size - 1};
    const char* name = patch.name.c_str();
    int family, boundary;

    check(cg_family_write(file_, base_, name, &family));
    check
    (
        cg_boco_write
        (
            file_, base_, zone_, name, FamilySpecified, PointRange, 2, range,
            &boundary
        )
    );
    check
    (
        cg_boco_gridlocation_write
        (
            file_, base_, zone_, boundary,
            dimension == 3 ? FaceCenter : EdgeCenter
        )
    );
    check
    (
        cg_goto
        (
            file_, base_, "Zone_t", zone_, "ZoneBC_t", 1, "BC_t", boundary,
            "end"
        )
    );
    check(cg_famname_write(name));
    check(cg_descriptor_write("Name", fullName.c_str()));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void writeCgns(const elementMesh& mesh, const fileName& file)
{
    HashSet<word> names;
    const List<elementGroup> zones(withShortNames(mesh.zones, names));
    const List<elementGroup> patches(withShortNames(mesh.patches, names));

    cgnsFile cgns(file, mesh);
    cgns.writePoints(mesh);

    for (const elementGroup& zone : zones)
    {
        cgns.writeSection(zone, mesh.cells, 1);
    }
    const label first = mesh.cells.size() + 1;
    forAll(patches, i)
    {
        cgns.writeSection(patches[i], mesh.faces, first);
        cgns.writeBoundary
        (
            patches[i], mesh.patches[i].name, first, mesh.dimension
        );
    }
    cgns.close();
}

} // End namespace Foam

#endif

// ************************************************************************* //
