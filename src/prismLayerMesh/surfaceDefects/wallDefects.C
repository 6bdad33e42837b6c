/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallDefects.H"
#include "cellPredicates.H"
#include "disjointSets.H"
#include "invertCompact.H"
#include "StringStream.H"
#include "wallPredicates.H"

#include <algorithm>

namespace Foam
{

static bool haveSamePoints(const face& f, const face& g)
{
    return
        f.size() == g.size()
     && std::is_permutation(f.begin(), f.end(), g.begin());
}


//- For each face its neighbours over edges with two faces, and whether they
//  are oriented otherwise
static List<DynamicList<std::pair<label, bool>>> neighbours
(
    const wallSides& sides,
    const label nFaces
)
{
    List<DynamicList<std::pair<label, bool>>> result(nFaces);

    for (label e = 0; e < sides.nEdges(); ++e)
    {
        const SubList<wallSide> both(sides.on(e));

        if (both.size() == 2)
        {
            const wallSide& s = both[0];
            const wallSide& t = both[1];
            result[s.facei].append({t.facei, s.up == t.up});
            result[t.facei].append({s.facei, s.up == t.up});
        }
    }

    return result;
}


//- Adds each face that has the same points as a face before it
static void findDuplicateFaces
(
    const wallSurface& wall,
    const wallSides& sides,
    defectList& defects
)
{
    bitSet duplicate(wall.faces.size());

    // Duplicates meet at an edge, where the sides are in the order of faces
    for (label e = 0; e < sides.nEdges(); ++e)
    {
        const SubList<wallSide> all(sides.on(e));

        forAll(all, i)
        {
            const label f = all[i].facei;

            for (label j = 0; j < i; ++j)
            {
                const label g = all[j].facei;

                if (f != g && haveSamePoints(wall.faces[f], wall.faces[g]))
                {
                    duplicate.set(f);
                }
            }
        }
    }

    for (const label facei : duplicate)
    {
        defects.addFace(wallDefect::kind::duplicateFace, facei);
    }
}


bool findBadEdges
(
    const wallSides& sides,
    defectList& defects,
    const bool mayBeOpen
)
{
    bool oriented = true;

    for (label e = 0; e < sides.nEdges(); ++e)
    {
        const SubList<wallSide> all(sides.on(e));

        if (all.size() == 1)
        {
            if (!mayBeOpen)
            {
                defects.addEdge(wallDefect::kind::openEdge, all[0]);
            }
        }
        else if (all.size() > 2)
        {
            defects.addEdge(wallDefect::kind::nonManifoldEdge, all[0]);
        }
        else if (all[0].up == all[1].up)
        {
            oriented = false;
        }
    }

    return oriented;
}


namespace
{

//- Where the walk over the faces is
struct faceWalk
{
    bitSet visited, turned, flipped;

    explicit faceWalk(const label nFaces)
    :
        visited(nFaces),
        turned(nFaces),
        flipped(nFaces)
    {}
};

} // End anonymous namespace


//- The faces that are joined to a seed. Marks those that are turned against the
//  seed, and one of each two for which it depends on the way.
template<class Neighbours>
static labelList walkFrom
(
    const label seed,
    const Neighbours& adjacent,
    faceWalk& walk
)
{
    DynamicList<label> component;
    component.append(seed);
    walk.visited.set(seed);

    for (label i = 0; i < component.size(); ++i)
    {
        const label f = component[i];

        for (const auto& next : adjacent[f])
        {
            const bool turn = (walk.turned.test(f) != next.second);

            if (walk.visited.set(next.first))
            {
                walk.turned.set(next.first, turn);
                component.append(next.first);
            }
            else if (walk.turned.test(next.first) != turn)
            {
                walk.flipped.set(max(f, next.first));
            }
        }
    }

    return labelList(std::move(component));
}


bitSet findTurnedFaces(const wallSides& sides, const label nFaces)
{
    const auto adjacent(neighbours(sides, nFaces));
    faceWalk walk(nFaces);

    for (label seed = 0; seed < nFaces; ++seed)
    {
        if (walk.visited.test(seed))
        {
            continue;
        }

        const labelList component(walkFrom(seed, adjacent, walk));
        label nTurned = 0;
        for (const label f : component)
        {
            nTurned += walk.turned.test(f);
        }

        const bool minority = (2*nTurned <= component.size());
        for (const label f : component)
        {
            if (walk.turned.test(f) == minority)
            {
                walk.flipped.set(f);
            }
        }
    }

    return walk.flipped;
}


//- Adds the faces that findTurnedFaces returns
static void findFlippedFaces
(
    const wallSurface& wall,
    const wallSides& sides,
    defectList& defects
)
{
    for (const label facei : findTurnedFaces(sides, wall.faces.size()))
    {
        defects.addFace(wallDefect::kind::flippedFace, facei);
    }
}


//- The number of groups of corners at a point that edges connect.
//  faces: the faces of the corners, ascending
static label nFansAt
(
    const wallSurface& wall,
    const label p,
    const UList<label>& faces
)
{
    // The other end of each edge, and the first corner of the edge's face
    DynamicList<labelPair> ends(2*faces.size());
    label first = 0;
    forAll(faces, i)
    {
        if (faces[i] == faces[first] && i > 0)
        {
            continue;
        }
        first = i;

        const face& f = wall.faces[faces[i]];
        forAll(f, k)
        {
            for (const label q : {f.nextLabel(k), f.prevLabel(k)})
            {
                if (f[k] == p && q != p)
                {
                    ends.append(labelPair(q, first));
                }
            }
        }
    }
    std::sort(ends.begin(), ends.end());

    disjointSets fans(faces.size());
    for (label i = 1; i < ends.size(); ++i)
    {
        if (ends[i].first() == ends[i - 1].first())
        {
            fans.join(ends[i].second(), ends[i - 1].second());
        }
    }

    label n = 0;
    forAll(faces, i)
    {
        n += fans.find(i) == i;
    }

    return n;
}


labelList countFans(const wallSurface& wall)
{
    const CompactListList<label> pointFaces
    (
        invertCompact(wall.points.size(), wall.faces)
    );

    labelList nFans(wall.points.size());
    #pragma omp parallel for schedule(static, 256)
    forAll(nFans, p)
    {
        nFans[p] = nFansAt(wall, p, pointFaces[p]);
    }

    return nFans;
}


void findNonManifoldPoints(const wallSurface& wall, defectList& defects)
{
    const labelList nFans(countFans(wall));

    forAll(nFans, p)
    {
        if (nFans[p] > 1)
        {
            defects.add(wallDefect::kind::nonManifoldPoint, p, wall.points[p]);
        }
    }
}


// * * * * * * * * * * * * * * *  Wall Defects * * * * * * * * * * * * * * * //

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
    boolList flat(wall.faces.size());
    #pragma omp parallel for schedule(static, 256)
    forAll(flat, facei)
    {
        flat[facei] = isDegenerate(wall, wall.faces[facei]);
    }

    const bitSet degenerate(flat);
    for (const label facei : degenerate)
    {
        defects.addFace(defectKind::degenerateFace, facei);
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


List<wallDefect> findWallDefects(const wallSurface& wall, const bool mayBeOpen)
{
    const wallSides sides(makeWallSides(wall));
    defectList defects(wall);

    const bitSet degenerate(findDegenerateFaces(wall, defects));
    findDuplicateFaces(wall, sides, defects);

    if (!findBadEdges(sides, defects, mayBeOpen))
    {
        findFlippedFaces(wall, sides, defects);
    }

    findNonManifoldPoints(wall, defects);

    for (const labelPair& pair : findIntersectingFaces(wall, degenerate))
    {
        defects.addFace
        (
            defectKind::selfIntersection, pair.first(), pair.second()
        );
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
            os  << "    " << (atPoint ? "point " : "face ") << defect.labels[i];
            if (defect.partners[i] >= 0)
            {
                os  << " and face " << defect.partners[i];
            }
            os  << " at " << defect.places[i] << nl;
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
