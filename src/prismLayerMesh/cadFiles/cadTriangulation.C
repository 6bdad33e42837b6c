/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cadTriangulation.H"
#include "bitSet.H"
#include "boundBox.H"
#include "cadPatches.H"
#include "HashSet.H"
#include "StringStream.H"
#include "triFace.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- For each tag the patch of its face, -1 if the face is between two solids
static labelList findPatches(const cadModel& model, label& nBetween)
{
    const labelList nSolids(model.nSolids());
    labelList patchOfTag(nSolids.size(), -1);

    forAll(model.faces, i)
    {
        const label tag = model.faces[i];

        if (nSolids[tag] < 2)
        {
            patchOfTag[tag] = i;
        }
        else
        {
            ++nBetween;
        }
    }

    return patchOfTag;
}


static void countFaults(cadTriangulation& made)
{
    const wallSurface& wall = made.wall;
    HashSet<triFace, triFace::Hash<>> triangles;
    bitSet hasTriangles(wall.patchNames.size());
    hasTriangles.set(wall.patchIDs);

    for (const face& f : wall.faces)
    {
        made.nTwins += !triangles.insert(triFace(f));
    }
    made.nOpen =
        made.model.solidLabels.size() ? outline(wall.faces).size() : 0;
    made.nBare =
        wall.patchNames.size() - made.nBetween - hasTriangles.count();
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

cadTriangulation makeCadTriangulation
(
    const cadModel& model,
    const cadTriangles& mesh
)
{
    cadTriangulation made;
    made.model = model;
    const labelList patchOfTag(findPatches(model, made.nBetween));

    DynamicList<face> faces(mesh.faces.size());
    DynamicList<label> patchIDs(mesh.faces.size());

    forAll(mesh.faces, i)
    {
        const label tag = mesh.tags[i];
        const label patchi =
            tag >= 0 && tag < patchOfTag.size() ? patchOfTag[tag] : -1;

        if (patchi >= 0)
        {
            faces.append(mesh.faces[i]);
            patchIDs.append(patchi);
        }
    }

    made.wall.points = mesh.points;
    made.wall.patchNames = cadPatchNames(model);
    made.wall.faces.transfer(faces);
    made.wall.patchIDs.transfer(patchIDs);
    countFaults(made);

    return made;
}


string describe
(
    const cadTriangulation& made,
    const word& unit,
    const scalar scale,
    const string& by
)
{
    boundBox box;
    for (const face& f : made.wall.faces)
    {
        for (const label p : f)
        {
            box.add(made.wall.points[p]);
        }
    }
    const vector size(scale*box.span());

    OStringStream os;
    os  << "unit: " << (unit.empty() ? "none, taken for metres" : unit.c_str())
        << (scale < 1 || scale > 1 ? ", scaled" : "")
        << "; " << size.x() << " x " << size.y() << " x " << size.z()
        << " m; solids " << made.model.solidLabels.size()
        << ", faces " << made.model.faces.size()
        << ", triangles " << made.wall.faces.size()
        << " by gmsh " << by.c_str();

    const auto add = [&](const label n, const char* what)
    {
        if (n)
        {
            os << "; " << what << ' ' << n;
        }
    };
    add(made.model.nLoose, "faces of no solid, left out");
    add(made.nBetween, "faces between two solids, left out");
    add(made.nBare, "faces without triangles");
    add(made.nOpen, "open edges of solids");
    add(made.nTwins, "triangles on each other");

    return os.str();
}

} // End namespace Foam

// ************************************************************************* //
