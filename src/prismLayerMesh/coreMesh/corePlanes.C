/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "corePlanes.H"
#include "boundBox.H"
#include "edgeHashes.H"
#include "HashSet.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

corePlanes::corePlanes
(
    const polyMeshParts& core,
    const UList<sidePatch>& planes
)
:
    core_(core),
    planes_(planes),
    tolerance_(1e-9*boundBox(core.points, false).mag())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label corePlanes::planeOf(const label facei) const
{
    forAll(planes_, s)
    {
        bool isInside = true;
        for (const label p : core_.topology.faces[facei])
        {
            isInside = isInside && isIn(s, p);
        }
        if (isInside)
        {
            return s;
        }
    }

    return -1;
}


bitSet corePlanes::pointsIn(const label plane) const
{
    bitSet points(core_.points.size());
    forAll(core_.points, p)
    {
        points.set(p, isIn(plane, p));
    }

    return points;
}


labelList corePlanes::facesTouching
(
    const label plane,
    const std::function<bool(label)>& stays
) const
{
    const polyMeshTopology& t = core_.topology;
    const bitSet isInPlane(pointsIn(plane));
    labelHashSet points;
    edgeHashSet edges;
    for (label i = t.neighbour.size(); i < t.faces.size(); ++i)
    {
        if (stays(t.owner[i]) && planeOf(i) == plane)
        {
            points.insert(t.faces[i]);
            edges.insert(t.faces[i].edges());
        }
    }

    // The plane is triangulated beside these faces alone
    const auto isBeside = [&](const edge& e)
    {
        return points.found(e.start())
         && (!isInPlane.test(e.end()) || edges.found(e));
    };

    DynamicList<label> touching;
    forAll(t.faces, facei)
    {
        const face& f = t.faces[facei];
        bool touches = false;
        forAll(f, k)
        {
            touches = touches
             || (
                    isInPlane.test(f[k])
                 && !isBeside(edge(f[k], f.nextLabel(k)))
                );
        }

        if (touches)
        {
            touching.append(facei);
        }
    }

    return labelList(std::move(touching));
}

} // End namespace Foam

// ************************************************************************* //
