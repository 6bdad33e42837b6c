/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "packedFaces.H"
#include "DynamicList.H"
#include "SubList.H"

namespace Foam
{

packedFaces::packedFaces(const UList<face>& faces)
:
    sizes(faces.size())
{
    DynamicList<label> all(4*faces.size());
    forAll(faces, i)
    {
        sizes[i] = faces[i].size();
        all.append(faces[i]);
    }
    corners.transfer(all);
}


faceList packedFaces::unpacked() const
{
    faceList faces(sizes.size());
    label start = 0;
    forAll(faces, i)
    {
        faces[i] = face(SubList<label>(corners, sizes[i], start));
        start += sizes[i];
    }

    return faces;
}

} // End namespace Foam

// ************************************************************************* //
