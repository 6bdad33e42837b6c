/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polygonFaces.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The area of the smallest triangle of the fan from a corner of a face, seen
//  along a normal of any length
static scalar smallestOfFan
(
    const face& f,
    const label start,
    const UList<point>& points,
    const vector& normal
)
{
    const point& a = points[f[start]];
    scalar least = GREAT;
    for (label k = 1; k + 1 < f.size(); ++k)
    {
        const point& b = points[f[(start + k) % f.size()]];
        const point& c = points[f[(start + k + 1) % f.size()]];
        least = min(least, normal & ((b - a) ^ (c - a)));
    }

    return least;
}


//- Rotates a face so that the smallest triangle of the fan from its first point
//  is as large as can be: certificates cut faces into these fans, and at a
//  straight edge of the wall there are three points in a line. A quadrilateral
//  without such points stays, because the layers have their certificate with
//  this diagonal.
static face withBestFan(const face& f, const UList<point>& points)
{
    const vector normal(f.areaNormal(points));
    const bool isQuad = f.size() == 4;
    if (isQuad && smallestOfFan(f, 0, points, normal) > SMALL*magSqr(normal))
    {
        return f;
    }
    label best = 0;
    scalar most = -GREAT;
    forAll(f, start)
    {
        const scalar least = smallestOfFan(f, start, points, normal);
        if (least > most)
        {
            most = least;
            best = start;
        }
    }

    return face(rotateList(f, -best));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

boolList stayingPoints(const meshBuilder& faces, const cornerPoints& points)
{
    // Two neighbours of each point; a third one makes it stay
    boolList stays(points.size(), false);
    List<labelPair> neighbours(points.size(), labelPair(-1, -1));
    const auto add = [&](const label p, const label q)
    {
        labelPair& known = neighbours[p];
        if (known.first() < 0 || known.first() == q)
        {
            known.first() = q;
        }
        else if (known.second() < 0 || known.second() == q)
        {
            known.second() = q;
        }
        else
        {
            stays[p] = true;
        }
    };
    for (label facei = 0; facei < faces.size(); ++facei)
    {
        const SubList<label> f(faces.pointsOf(facei));
        forAll(f, k)
        {
            const label next = f[f.fcIndex(k)];
            add(f[k], next);
            add(next, f[k]);
            stays[f[k]] = stays[f[k]] || points.isGiven(f[k]);
        }
    }

    return stays;
}


polyMeshParts makePolygonParts
(
    meshBuilder& faces,
    const cornerPoints& points,
    const boolList& stays,
    const bitSet& cells,
    const label nPatches,
    labelList& labels
)
{
    for (label facei = 0; facei < faces.size(); ++facei)
    {
        const labelPair& sides = faces.cellsOf(facei);
        if (!cells.test(sides.first()) && !cells.test(sides.second()))
        {
            faces.leaveOut(facei);
        }
    }
    const labelList order(faces.order(cells.size(), nPatches));
    labelList newLabels(points.size(), -1);
    DynamicList<label> labelsOf;
    for (const label facei : order)
    {
        label n = 0;
        for (const label p : faces.pointsOf(facei))
        {
            n += stays[p];
            if (stays[p] && newLabels[p] < 0)
            {
                newLabels[p] = labelsOf.size();
                labelsOf.append(p);
            }
        }
        if (n < 3)
        {
            FatalErrorInFunction
                << "A face between polygons is a line, at "
                << points.position(faces.pointsOf(facei)[0]) << nl
                << "Use cells triangles" << exit(FatalError);
        }
    }
    labels.transfer(labelsOf);
    faces.renumberPoints(newLabels);

    polyMeshParts mesh;
    mesh.nCells = cells.size();
    mesh.points.setSize(labels.size());
    forAll(labels, p)
    {
        mesh.points[p] = points.position(labels[p]);
    }
    polyMeshTopology& t = mesh.topology = faces.topology(order, nPatches);
    for (label facei = t.neighbour.size(); facei < t.faces.size(); ++facei)
    {
        t.faces[facei] = withBestFan(t.faces[facei], mesh.points);
    }

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
