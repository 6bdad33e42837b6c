/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exactUnion.H"
#include "faceGroups.H"
#include "ListOps.H"
#include "orientation.H"
#include "readWallSurface.H"
#include "UIndirectList.H"
#include "unionBoundary.H"

#include <algorithm>
#include <array>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Gives faces the first of the points that are equal
void makeEqualPointsOne(const pointField& points, faceList& faces)
{
    std::map<std::array<scalar, 3>, label> firsts;
    labelList first(points.size());
    forAll(points, p)
    {
        const point& x = points[p];
        first[p] = firsts.emplace
        (
            std::array<scalar, 3>{{x.x(), x.y(), x.z()}}, p
        ).first->second;
    }
    for (face& f : faces)
    {
        inplaceRenumber(first, f);
    }
}


//- Faces but for faces with a point twice, and for pairs of faces on the same
//  points that are oriented otherwise
faceList withoutCollapsed(const faceList& faces)
{
    std::vector<bool> isGone(faces.size());
    std::map<std::array<label, 3>, label> single;

    forAll(faces, i)
    {
        const face& f = faces[i];
        isGone[i] = f[0] == f[1] || f[1] == f[2] || f[2] == f[0];
        if (isGone[i])
        {
            continue;
        }

        std::array<label, 3> key{{f[0], f[1], f[2]}};
        std::sort(key.begin(), key.end());
        const auto inserted = single.emplace(key, i);
        const label j = inserted.first->second;
        if (!inserted.second && face::compare(faces[j], f) < 0)
        {
            isGone[i] = isGone[j] = true;
            single.erase(inserted.first);
        }
    }

    faceList result(faces.size());
    label n = 0;
    forAll(faces, i)
    {
        if (!isGone[i])
        {
            result[n++] = faces[i];
        }
    }
    result.setSize(n);

    return result;
}


//- The triangles of a surface but for triangles whose area is zero, exactly
faceList trianglesWithArea(const wallSurface& surface)
{
    labelList faceOf;
    const faceList triangles(wallTriangles(surface, faceOf));

    return subsetList(triangles, [&](const face& f)
    {
        const pointField& x = surface.points;

        return !isCollinear(x[f[0]], x[f[1]], x[f[2]]);
    });
}


struct faceGroup
{
    std::vector<label> faces;

    //- Positive if the normals of a closed group point out of it [m3]
    scalar volume;
};


//- Groups of faces that hang together by edges
std::vector<faceGroup> groupsByEdges
(
    const pointField& points,
    const faceList& faces
)
{
    const edgeFaceMap onEdges
    (
        facesOnEdges
        (
            faces.size(), [&](const label i) -> const face& { return faces[i]; }
        )
    );
    const auto neighbours = [&](const label i, const auto& visit)
    {
        for (const edge& e : faces[i].edges())
        {
            for (const label j : onEdges.at(ordered(e)))
            {
                visit(j);
            }
        }
    };

    std::vector<faceGroup> result;
    for (const std::vector<label>& group : groupsOf(faces.size(), neighbours))
    {
        const point& origin = points[faces[group[0]][0]];
        scalar volume = 0;
        for (const label i : group)
        {
            const face& f = faces[i];
            const point& a = points[f[0]];
            volume +=
                (a - origin) & ((points[f[1]] - a) ^ (points[f[2]] - a))/6;
        }
        result.push_back(faceGroup{group, volume});
    }

    return result;
}


//- Turns groups that have a negative volume
void turnOutwards(const pointField& points, faceList& faces)
{
    for (const faceGroup& group : groupsByEdges(points, faces))
    {
        for (const label i : group.faces)
        {
            if (group.volume < 0)
            {
                faces[i].flip();
            }
        }
    }
}


//- Removes groups that have a negative volume: the boundaries of voids. Returns
//  their number.
label fillVoids(const pointField& points, faceList& faces)
{
    label nVoids = 0;
    labelList kept;
    for (const faceGroup& group : groupsByEdges(points, faces))
    {
        if (group.volume > 0)
        {
            kept.append(labelList(group.faces.begin(), group.faces.end()));
        }
        else
        {
            ++nVoids;
        }
    }
    Foam::sort(kept);
    faces = faceList(UIndirectList<face>(faces, kept));

    return nVoids;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool isBalanced(const faceList& faces)
{
    std::map<std::pair<label, label>, label> balance;
    for (const face& f : faces)
    {
        for (const edge& e : f.edges())
        {
            balance[ordered(e)] += e.start() < e.end() ? 1 : -1;
        }
    }

    return std::all_of
    (
        balance.begin(), balance.end(),
        [](const auto& entry) { return entry.second == 0; }
    );
}


void uniteExactly(wallSurface& surface, repairSteps& steps)
{
    surface.faces = trianglesWithArea(surface);
    turnOutwards(surface.points, surface.faces);

    unionBoundary boundary(findUnionBoundary(surface));
    std::vector<bool> isThere(surface.faces.size(), false);
    for (const label i : boundary.triangleOf)
    {
        isThere[i] = true;
    }
    addStep
    (
        steps, "faces divided where bodies meet",
        std::count
        (
            boundary.isDivided.begin(), boundary.isDivided.end(), true
        )
    );
    addStep
    (
        steps, "faces removed inside of other bodies",
        std::count(isThere.begin(), isThere.end(), false)
    );

    makeEqualPointsOne(boundary.points, boundary.faces);
    surface.points = boundary.points;
    surface.faces = withoutCollapsed(boundary.faces);
    addStep
    (
        steps, "voids between bodies filled",
        fillVoids(surface.points, surface.faces)
    );
    removeUnusedPoints(surface.faces, surface.points);
}

} // End namespace Foam

// ************************************************************************* //
