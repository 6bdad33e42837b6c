/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomSurface.H"
#include "boolList.H"
#include "labelVector.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace randomSurfaces
{

//- Cells of a grid, some of them filled. Those beyond it are empty.
class filledCells
{
    labelVector size_;
    boolList filled_;


public:

    explicit filledCells(const labelVector& size)
    :
        size_(size),
        filled_(cmptProduct(size), false)
    {}

    const labelVector& size() const
    {
        return size_;
    }

    bool inside(const labelVector& v) const
    {
        return cmptMin(v) >= 0 && cmptMin(size_ - v) > 0;
    }

    label cellLabel(const labelVector& v) const
    {
        return (v.x()*size_.y() + v.y())*size_.z() + v.z();
    }

    bool operator()(const labelVector& v) const
    {
        return inside(v) && filled_[cellLabel(v)];
    }

    void fill(const labelVector& v)
    {
        filled_[cellLabel(v)] = true;
    }
};


static labelVector randomCell(const labelVector& size, Random& random)
{
    labelVector v(0, 0, 0);

    for (direction d = 0; d < 3; ++d)
    {
        v[d] = random.position<label>(0, size[d] - 1);
    }

    return v;
}


//- Cells that hang together by faces
static void grow(filledCells& cells, const label nCells, Random& random)
{
    cells.fill(randomCell(cells.size(), random));

    for (label n = 1; n < nCells;)
    {
        const labelVector v(randomCell(cells.size(), random));
        labelVector beside(v);
        beside[random.position<label>(0, 2)] += random.bit() ? 1 : -1;

        if (!cells(v) && cells(beside))
        {
            cells.fill(v);
            ++n;
        }
    }
}


//- The eight cells around a point of the grid, as bits 4x + 2y + z
static label around(const filledCells& cells, const labelVector& corner)
{
    label bits = 0;

    for (label i = 0; i < 8; ++i)
    {
        const labelVector v(corner - labelVector(1 - i/4, 1 - i/2%2, 1 - i%2));
        bits |= label(cells(v)) << i;
    }

    return bits;
}


//- Whether the set of cells hangs together by faces
static bool connected(const label bits)
{
    label reached = bits & -bits;

    for (label pass = 0; pass < 8; ++pass)
    {
        for (label i = 0; i < 8; ++i)
        {
            for (label step = 1; (reached >> i & 1) && step < 8; step *= 2)
            {
                reached |= bits & (1 << (i ^ step));
            }
        }
    }

    return reached == bits;
}


//- Fill cells where others meet in no more than an edge or a point, inside or
//  outside, until there are none. A full grid has none.
static void makeManifold(filledCells& cells, Random& random)
{
    const labelVector n(cells.size());

    for (bool changed = true; changed;)
    {
        changed = false;

        for (label c = 0; c < (n.x() + 1)*(n.y() + 1)*(n.z() + 1); ++c)
        {
            const labelVector corner
            (
                c/(n.z() + 1)/(n.y() + 1), c/(n.z() + 1)%(n.y() + 1),
                c%(n.z() + 1)
            );
            const label bits = around(cells, corner);

            if (connected(bits) && connected(255 & ~bits))
            {
                continue;
            }

            // Any of the empty cells that are in the grid
            labelVector v(-1, -1, -1);
            while (!cells.inside(v) || cells(v))
            {
                v = corner - randomCell(labelVector(2, 2, 2), random);
            }

            cells.fill(v);
            changed = true;
        }
    }
}


//- Positions of n + 1 planes: even, uneven or some of them very close
static scalarList planes(const label n, Random& random)
{
    const scalar thinnest = logUniform(random, 0.005, 1);
    scalarList x(n + 1, Zero);

    for (label i = 0; i < n; ++i)
    {
        x[i + 1] = x[i] + logUniform(random, thinnest, 1);
    }

    return x;
}


//- The points moved, by less than would make neighbours meet: saddle corners
//  at all angles
static void shake(wallSurface& wall, Random& random)
{
    vector gap(GREAT, GREAT, GREAT);

    for (const face& f : wall.faces)
    {
        forAll(f, i)
        {
            const edge e(f[i], f.nextLabel(i));
            const vector v(cmptMag(e.vec(wall.points)));

            for (direction d = 0; d < 3; ++d)
            {
                gap[d] = v[d] > 0 ? min(gap[d], v[d]) : gap[d];
            }
        }
    }

    const scalar share = random.position<scalar>(0, 0.4);

    for (point& p : wall.points)
    {
        const scalar distance = share*random.sample01<scalar>();
        p += distance*cmptMultiply(gap, unitVector(random));
    }
}


//- The squares between filled cells and others
static wallSurface boundary(const filledCells& cells, Random& random)
{
    const labelVector n(cells.size());
    FixedList<scalarList, 3> x;
    for (direction d = 0; d < 3; ++d)
    {
        x[d] = planes(n[d], random);
    }

    const labelVector nPoints(n + labelVector(1, 1, 1));
    labelList pointOf(cmptProduct(nPoints), -1);
    DynamicList<point> points;
    DynamicList<face> faces;

    for (label c = 0; c < cmptProduct(n); ++c)
    {
        const labelVector v(c/n.z()/n.y(), c/n.z()%n.y(), c%n.z());

        for (label side = 0; cells(v) && side < 6; ++side)
        {
            const direction d = side/2;
            labelVector out(0, 0, 0), u(0, 0, 0), w(0, 0, 0);
            out[d] = side%2 ? 1 : -1;
            u[(d + 2 - side%2) % 3] = 1;
            w[(d + 1 + side%2) % 3] = 1;

            if (cells(v + out))
            {
                continue;
            }

            labelVector a(v);
            a[d] += side%2;
            face f(4);
            label i = 0;

            for (const labelVector& q : {a, a + u, a + u + w, a + w})
            {
                label& p = pointOf
                [
                    (q.x()*nPoints.y() + q.y())*nPoints.z() + q.z()
                ];

                if (p < 0)
                {
                    p = points.size();
                    points.append(point(x[0][q.x()], x[1][q.y()], x[2][q.z()]));
                }

                f[i++] = p;
            }

            faces.append(f);
        }
    }

    return surfaceOf(points, faces);
}

} // End namespace randomSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::randomSurfaces::boxUnion(Random& random)
{
    labelVector size(0, 0, 0);
    for (direction d = 0; d < 3; ++d)
    {
        size[d] = random.position<label>(1, 5);
    }

    filledCells cells(size);
    const scalar share = random.position<scalar>(0.1, 0.7);
    grow(cells, max(label(1), label(share*cmptProduct(size))), random);
    makeManifold(cells, random);

    wallSurface wall(boundary(cells, random));

    while (wall.faces.size() < 300 && chance(random, 0.5))
    {
        wall = refined(wall);
    }

    if (chance(random, 0.5))
    {
        shake(wall, random);
    }

    return chance(random, 0.3) ? wall : randomlyCut(wall, random);
}


// ************************************************************************* //
