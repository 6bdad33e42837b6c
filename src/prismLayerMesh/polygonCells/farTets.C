/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farTets.H"
#include "makeFarFieldMesh.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Static Data * * * * * * * * * * * * * * * //

constexpr label farTets::edgeEnds[6][4];


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

label nTetsOf(const farFieldMesh& far)
{
    for (const cellZoneParts& zone : far.cellZones)
    {
        if (zone.name == farFieldName)
        {
            return zone.cells.size();
        }
    }

    return 0;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void farTets::setPoints(const label t)
{
    // The points of the first face, and of the second the other point
    const polyMeshTopology& topology = far_.topology;
    const FixedList<label, 4> faces(faces_[t]);
    FixedList<label, 4>& p = points_[t];
    const face& first = topology.faces[faces[0]];
    const bool owns = topology.owner[faces[0]] == t;
    for (label k = 0; k < 3; ++k)
    {
        p[k] = first[owns ? k : 2 - k];
    }
    for (const label q : topology.faces[faces[1]])
    {
        p[3] = first.found(q) ? p[3] : q;
    }
    for (const label facei : faces)
    {
        for (label k = 0; k < 4; ++k)
        {
            if (!topology.faces[facei].found(p[k]))
            {
                faces_[t][k] = facei;
            }
        }
    }
}


void farTets::setEdges()
{
    std::vector<endsOfEdge> ends;
    ends.reserve(6*size());
    for (const FixedList<label, 4>& p : points_)
    {
        for (const label* e : edgeEnds)
        {
            ends.push_back(std::minmax(p[e[0]], p[e[1]]));
        }
    }
    edges_ = numberedEdges(ends);
    forAll(edgesOf_, t)
    {
        for (label i = 0; i < 6; ++i)
        {
            const endsOfEdge& e = ends[6*t + i];
            edgesOf_[t][i] = edges_.find(e.first, e.second);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

farTets::farTets(const farFieldMesh& far, const label nTets)
:
    far_(far),
    points_(nTets),
    faces_(nTets),
    edgesOf_(nTets)
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

    for (label i = 0; i < nTets; ++i)
    {
        setPoints(i);
    }
    setEdges();
}

} // End namespace Foam

// ************************************************************************* //
