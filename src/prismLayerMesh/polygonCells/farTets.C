/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farTets.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

farTets::farTets(const farFieldMesh& far, const label nTets)
:
    far_(far),
    points_(nTets),
    faces_(nTets)
{
    const polyMeshTopology& t = far.topology;
    labelList nFaces(nTets, Zero);
    const auto add = [&](const label celli, const label facei)
    {
        if (celli < nTets)
        {
            faces_[celli][nFaces[celli]++] = facei;
        }
    };
    forAll(t.faces, facei)
    {
        add(t.owner[facei], facei);
        if (facei < t.neighbour.size())
        {
            add(t.neighbour[facei], facei);
        }
    }

    std::vector<endsOfEdge> ends;
    ends.reserve(6*nTets);
    forAll(points_, i)
    {
        // The points of the first face, and of the second the other point
        FixedList<label, 4>& p = points_[i];
        const face& first = t.faces[faces_[i][0]];
        for (label k = 0; k < 3; ++k)
        {
            p[k] = first[k];
        }
        for (const label q : t.faces[faces_[i][1]])
        {
            p[3] = first.found(q) ? p[3] : q;
        }
        const FixedList<label, 4> faces(faces_[i]);
        for (const label facei : faces)
        {
            for (label k = 0; k < 4; ++k)
            {
                if (!t.faces[facei].found(p[k]))
                {
                    faces_[i][k] = facei;
                }
            }
        }
        for (label k = 0; k < 4; ++k)
        {
            for (label l = k + 1; l < 4; ++l)
            {
                ends.push_back(std::minmax(p[k], p[l]));
            }
        }
    }
    edges_ = numberedEdges(std::move(ends));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label farTets::across(const label facei, const label t) const
{
    const polyMeshTopology& topology = far_.topology;
    if (facei >= topology.neighbour.size())
    {
        return -1;
    }

    return
        topology.owner[facei] == t
      ? topology.neighbour[facei] : topology.owner[facei];
}


labelPair farTets::facesAt(const label t, const label i, const label j) const
{
    labelPair found;
    for (label k = 0; k < 4; ++k)
    {
        if (k != i && k != j)
        {
            const label facei = faces_[t][k];
            const edge e(points_[t][i], points_[t][j]);
            const bool forth =
                (far_.topology.faces[facei].edgeDirection(e) > 0)
             == (far_.topology.owner[facei] == t);
            found[forth] = facei;
        }
    }

    return found;
}

} // End namespace Foam

// ************************************************************************* //
