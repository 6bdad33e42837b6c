/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "convexPolyhedron.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

class boxCutter
{
    const scalar tolerance_;
    convexPolyhedron cut_;

    //- The label of a point, which is added if there is none at its place
    label labelOf(const point& x)
    {
        forAll(cut_.points, p)
        {
            if (mag(cut_.points[p] - x) < tolerance_)
            {
                return p;
            }
        }
        cut_.points.append(x);

        return cut_.points.size() - 1;
    }


    //- The part of a face behind a plane
    face behind(const face& f, const sidePatch& plane)
    {
        DynamicList<label> kept;
        forAll(f, k)
        {
            const point a(cut_.points[f[k]]);
            const point b(cut_.points[f.nextLabel(k)]);
            const scalar da = plane.distance(a), db = plane.distance(b);

            if (da <= tolerance_)
            {
                kept.append(f[k]);
            }
            if (mag(da) > tolerance_ && mag(db) > tolerance_ && da*db < 0)
            {
                const point x(a + da/(da - db)*(b - a));
                kept.append(labelOf(x - plane.distance(x)*plane.normal));
            }
        }

        return face(labelList(std::move(kept)));
    }


    //- The points on a plane, around it
    face faceOn(const sidePatch& plane) const
    {
        labelHashSet points;
        point centre(Zero);
        for (const face& f : cut_.faces)
        {
            for (const label p : f)
            {
                if
                (
                    mag(plane.distance(cut_.points[p])) <= tolerance_
                 && points.insert(p)
                )
                {
                    centre += cut_.points[p];
                }
            }
        }

        labelList order(points.sortedToc());
        if (order.size() < 3)
        {
            return face();
        }

        // Seen from inside, against the inward normal
        centre /= order.size();
        const vector e1(normalised(cut_.points[order[0]] - centre));
        const vector e2(-plane.normal ^ e1);
        scalarField angles(order.size());
        forAll(order, i)
        {
            const vector d(cut_.points[order[i]] - centre);
            angles[i] = ::atan2(d & e2, d & e1);
        }

        return face(labelList(labelUIndList(order, sortedOrder(angles))));
    }

public:

    explicit boxCutter(const boundBox& box)
    :
        tolerance_(1e-9*box.mag())
    {
        // In the order of boundBox::points
        cut_.points = box.points();
        cut_.faces = faceList
        ({
            face({0, 3, 7, 4}), face({1, 5, 6, 2}), face({0, 4, 5, 1}),
            face({3, 2, 6, 7}), face({0, 1, 2, 3}), face({4, 7, 6, 5})
        });
        cut_.planes.setSize(cut_.faces.size(), -1);
        cut_.boxSides = identity(cut_.faces.size());
    }


    void cut(const sidePatch& plane, const label planei)
    {
        convexPolyhedron part;

        forAll(cut_.faces, facei)
        {
            const face f(behind(cut_.faces[facei], plane));

            if (f.size() > 2)
            {
                part.faces.append(f);
                part.planes.append(cut_.planes[facei]);
                part.boxSides.append(cut_.boxSides[facei]);
            }
        }

        part.points = cut_.points;
        cut_ = part;
        const face on(faceOn(plane));

        if (on.empty())
        {
            return;
        }

        // A side of the box may be in the plane
        forAll(cut_.faces, facei)
        {
            if (face::sameVertices(cut_.faces[facei], on))
            {
                cut_.planes[facei] = planei;
                cut_.boxSides[facei] = -1;
                return;
            }
        }

        cut_.faces.append(on);
        cut_.planes.append(planei);
        cut_.boxSides.append(-1);
    }


    const convexPolyhedron& result() const { return cut_; }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

convexPolyhedron cutBox(const boundBox& box, const UList<sidePatch>& sides)
{
    boxCutter cutter(box);

    forAll(sides, s)
    {
        if (!sides[s].isPart())
        {
            cutter.cut(sides[s], s);
        }
    }

    return cutter.result();
}

} // End namespace Foam

// ************************************************************************* //
