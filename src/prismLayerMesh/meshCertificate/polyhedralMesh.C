/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polyhedralMesh.H"
#include "HashSet.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Number of the faces of each cell
static labelList nFacesOfCells
(
    const labelList& owner,
    const labelList& neighbour
)
{
    DynamicList<label> n;

    for (const labelList* side : {&owner, &neighbour})
    {
        for (const label celli : *side)
        {
            n.setSize(max(n.size(), celli + 1), 0);
            ++n[celli];
        }
    }

    return labelList(std::move(n));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

polyhedralMesh::polyhedralMesh
(
    const pointField& points,
    const faceList& faces,
    const labelList& owner,
    const labelList& neighbour
)
:
    points_(points),
    faces_(faces),
    owner_(owner),
    neighbour_(neighbour),
    cellFaces_(nFacesOfCells(owner, neighbour))
{
    labelList n(nCells(), Zero);

    for (const labelList* side : {&owner_, &neighbour_})
    {
        forAll(*side, facei)
        {
            const label celli = (*side)[facei];
            cellFaces_(celli, n[celli]++) = facei;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label polyhedralMesh::across(const label facei, const label celli) const
{
    if (facei >= neighbour_.size())
    {
        return -1;
    }

    return owner_[facei] == celli ? neighbour_[facei] : owner_[facei];
}


bool polyhedralMesh::isOfTriangles(const label celli) const
{
    label nTriangles = 0;
    for (const label facei : cellFaces(celli))
    {
        nTriangles += faces_[facei].size() == 3;
    }

    return isOfTriangles(nTriangles, cellFaces(celli).size());
}


labelList polyhedralMesh::apart(const label facei, const label celli) const
{
    DynamicList<label> found;
    for (const label other : cellFaces(celli))
    {
        const face& f = faces_[other];

        if
        (
            !anyOf(f, [&](const label p) { return faces_[facei].found(p); })
        )
        {
            found.append(other);
        }
    }

    return labelList(std::move(found));
}


label polyhedralMesh::opposite(const label facei, const label celli) const
{
    const labelList faces(apart(facei, celli));

    return faces.size() == 1 && !isOfTriangles(celli) ? faces[0] : -1;
}


bool polyhedralMesh::hasCutTop(const label facei, const label celli) const
{
    const labelList faces(apart(facei, celli));
    labelHashSet points;

    for (const label other : faces)
    {
        points.insert(faces_[other]);
    }

    return
        faces.size() > 1 && points.size() == faces_[facei].size()
     && !isOfTriangles(celli);
}


vector polyhedralMesh::outwardArea(const label facei, const label celli) const
{
    const vector area(faces_[facei].areaNormal(points_));

    return owner_[facei] == celli ? area : -area;
}


scalar polyhedralMesh::pyramidVolume
(
    const label facei,
    const label celli,
    const point& apex
) const
{
    const vector height(faces_[facei].centre(points_) - apex);

    return (outwardArea(facei, celli) & height)/3;
}


point polyhedralMesh::centre(const label celli) const
{
    labelHashSet labels;
    point sum(Zero);

    for (const label facei : cellFaces(celli))
    {
        for (const label p : faces_[facei])
        {
            if (labels.insert(p))
            {
                sum += points_[p];
            }
        }
    }

    return sum/max(labels.size(), 1);
}

} // End namespace Foam

// ************************************************************************* //
