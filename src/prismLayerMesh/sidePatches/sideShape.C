/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideShape.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static triSurface trianglesOf(const pointField& points, const faceList& faces)
{
    DynamicList<labelledTri> triangles;
    for (const face& f : faces)
    {
        for (label k = 1; k + 1 < f.size(); ++k)
        {
            triangles.append(labelledTri(f[0], f[k], f[k + 1], 0));
        }
    }

    return triSurface(triangles, points);
}


static vectorField outwardNormals(const triSurface& surface)
{
    vectorField normals(surface.size());
    forAll(normals, i)
    {
        normals[i] = -normalised(surface[i].areaNormal(surface.points()));
    }

    return normals;
}


//- At each point the mean, weighted by the angles there
static vectorField atPoints
(
    const triSurface& surface,
    const vectorField& normals
)
{
    vectorField atPoints(surface.points().size(), vector::zero);

    forAll(surface, i)
    {
        const labelledTri& t = surface[i];
        forAll(t, k)
        {
            const point& x = surface.points()[t[k]];
            const vector a = surface.points()[t[t.fcIndex(k)]] - x;
            const vector b = surface.points()[t[t.rcIndex(k)]] - x;
            atPoints[t[k]] += ::atan2(mag(a ^ b), a & b)*normals[i];
        }
    }
    for (vector& n : atPoints)
    {
        n.normalise();
    }

    return atPoints;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

treeBoundBox searchBox(const pointField& points)
{
    treeBoundBox bounds(points);
    bounds.inflate(1e-3);

    return bounds;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

vector sideShape::normalAt(const label triangle, const point& x) const
{
    const labelledTri& t = surface_[triangle];
    label type, element;
    t.nearestPointClassify(x, surface_.points(), type, element);

    if (type == triPointRef::POINT)
    {
        return pointNormals_[t[element]];
    }

    vector normal(faceNormals_[triangle]);
    if (type == triPointRef::EDGE)
    {
        const edge e(t[element], t[t.fcIndex(element)]);
        const label p = surface_.whichPoint(e[0]);
        for (const label other : surface_.pointFaces()[p])
        {
            if (other != triangle && surface_[other].found(e[1]))
            {
                normal += faceNormals_[other];
            }
        }
    }

    return normalised(normal);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

sideShape::sideShape(const pointField& points, const faceList& faces)
:
    surface_(trianglesOf(points, faces)),
    faceNormals_(outwardNormals(surface_)),
    pointNormals_(atPoints(surface_, faceNormals_)),
    tree_
    (
        treeDataTriSurface(true, surface_, 0), searchBox(points), 12, 10, 3
    )
{
    // Made on demand otherwise, which threads must not do
    surface_.pointFaces();
    surface_.meshPointMap();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

sidePlane sideShape::planeAt(const point& x) const
{
    const pointIndexHit hit(nearest(x));

    return sidePlane{hit.rawPoint(), normalAt(hit.index(), x)};
}


point sideShape::along
(
    const point& x,
    const vector& direction,
    const scalar distance
) const
{
    const vector reach(distance*direction);
    const pointIndexHit ahead(tree_.findLine(x, x + reach));
    const pointIndexHit behind(tree_.findLine(x, x - reach));

    if (!ahead.hit() && !behind.hit())
    {
        return nearest(x).rawPoint();
    }

    const bool isAhead =
        ahead.hit()
     && (
            !behind.hit()
         || magSqr(ahead.rawPoint() - x) < magSqr(behind.rawPoint() - x)
        );

    return isAhead ? ahead.rawPoint() : behind.rawPoint();
}

} // End namespace Foam

// ************************************************************************* //
