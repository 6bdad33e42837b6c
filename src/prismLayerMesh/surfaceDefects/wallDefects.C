/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallDefects.H"
#include "orientation.H"
#include "wallPredicates.H"
#include "wallTopologyDefects.H"
#include "StringStream.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef wallDefect::kind defectKind;

static const char* defectNames[] =
{
    "degenerate faces",
    "duplicate faces",
    "open edges",
    "edges with more than two faces",
    "flipped faces",
    "non-manifold points",
    "self-intersecting face pairs",
    "inside-out components"
};

static const char* defectAdvice[] =
{
    "Collapse or swap the faces without area.",
    "Remove the copies, or one of two coincident components.",
    "Close the holes, or merge the points along the gaps.",
    "Separate the bodies that share an edge, or remove inner faces.",
    "Turn round the faces that are not oriented as their neighbours.",
    "Split the point, or join the surfaces that touch there along an edge.",
    "Unite the overlapping bodies, or move apart the faces that cut or touch.",
    "Turn round the components whose normals do not point into the fluid."
};


//- A repeated point, or a corner or a triangle of the fan without area
static bool isDegenerate(const wallSurface& wall, const face& f)
{
    const label n = f.size();

    for (label i = 0; i < n; ++i)
    {
        if (std::find(f.begin(), f.begin() + i, f[i]) != f.begin() + i)
        {
            return true;
        }
    }

    const pointField& p = wall.points;
    bool flat = (n < 3);

    for (label i = 2; i < n && !flat; ++i)
    {
        flat = isCollinear(p[f[0]], p[f[i - 1]], p[f[i]]);
    }

    for (label i = 0; i < n && n > 3 && !flat; ++i)
    {
        flat = isCollinear(p[f[i]], p[f[f.fcIndex(i)]], p[f[f.rcIndex(i)]]);
    }

    return flat;
}


static bitSet findDegenerateFaces(const wallSurface& wall, defectList& defects)
{
    bitSet degenerate(wall.faces.size());

    forAll(wall.faces, facei)
    {
        if (isDegenerate(wall, wall.faces[facei]))
        {
            degenerate.set(facei);
            defects.addFace(defectKind::degenerateFace, facei);
        }
    }

    return degenerate;
}


static void findInvertedComponents
(
    const wallSurface& wall,
    const wallSides& sides,
    defectList& defects
)
{
    labelList componentOfFace;
    const label n = findComponents(sides, wall.faces.size(), componentOfFace);
    const bitSet inward(findInwardComponents(wall, componentOfFace, n));
    const label nInward = inward.count();

    // Which side the fluid is on is not known here: the majority is right
    const bool minority = (2*nInward <= n);
    label next = 0;

    forAll(componentOfFace, facei)
    {
        if (componentOfFace[facei] == next)
        {
            if (nInward && nInward < n && inward.test(next) == minority)
            {
                defects.addFace(defectKind::invertedComponent, facei);
            }

            ++next;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const char* wallDefect::name() const
{
    return defectNames[int(what)];
}


const char* wallDefect::advice() const
{
    return defectAdvice[int(what)];
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<wallDefect> findWallDefects
(
    const wallSurface& wall,
    const bool mayBeOpen
)
{
    const wallSides sides(makeWallSides(wall));
    defectList defects(wall);

    const bitSet degenerate(findDegenerateFaces(wall, defects));
    findDuplicateFaces(wall, sides, defects);

    if (!findBadEdges(sides, defects, mayBeOpen))
    {
        findFlippedFaces(wall, sides, defects);
    }

    findNonManifoldPoints(wall, sides, defects);

    for (const labelPair& pair : findIntersectingFaces(wall, degenerate))
    {
        defects.addFace(defectKind::selfIntersection, pair.first());
    }

    if (!mayBeOpen && defects.empty() && wall.faces.size())
    {
        findInvertedComponents(wall, sides, defects);
    }

    return defects.found();
}


string describe(const List<wallDefect>& defects)
{
    OStringStream os;

    for (const wallDefect& defect : defects)
    {
        const bool atPoint = (defect.what == defectKind::nonManifoldPoint);

        os  << defect.count << ' ' << defect.name() << ": "
            << defect.advice() << nl;

        forAll(defect.labels, i)
        {
            os  << "    " << (atPoint ? "point " : "face ")
                << defect.labels[i] << " at " << defect.places[i] << nl;
        }

        if (defect.count > defect.labels.size())
        {
            os  << "    and " << defect.count - defect.labels.size()
                << " more" << nl;
        }
    }

    return os.str();
}

} // End namespace Foam

// ************************************************************************* //
