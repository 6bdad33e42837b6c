/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wrapTargets.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

wrapTargets::wrapTargets
(
    const wallSurface& surface,
    const nearestSurface& nearest,
    const snapControls& controls,
    wallSurface& wrap
)
:
    nearest_(nearest),
    faceNormals_(surface.faceNormals()),
    controls_(controls),
    from_(wrap.points)
{
    foot_.minCos = Foam::cos(degToRad(controls.featureAngle));
    const sharpLines lines(surface, foot_.minCos);
    const label nGiven = wrap.points.size();

    setNearest(0);
    const edgeList chamfers(snapToEdges(lines, wrap));
    const pointField targets(splitChamfers(foot_, lines, chamfers, wrap));

    from_ = wrap.points;
    setNearest(nGiven);
    forAll(targets, i)
    {
        onEdges_.set(nGiven + i, targets[i]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void wrapTargets::setNearest(const label start)
{
    const pointField from
    (
        SubList<point>(from_, from_.size() - start, start)
    );
    pointField onFaces;
    labelList faces;
    nearest_.find(from, onFaces, faces);
    foot_.points.setSize(from_.size());
    foot_.normals.setSize(from_.size());
    for (bitSet* const set : {&foot_.areOff, &foot_.onSides, &isFar_})
    {
        set->resize(from_.size());
    }

    forAll(from, i)
    {
        const label p = start + i;
        const vector out(from[i] - onFaces[i]);
        const vector& n = faceNormals_[faces[i]];
        const bool isInside = controls_.inside.test(faces[i]);

        // Faces of the surface need not be oriented alike; around the edge of a
        // sheet planes turn
        foot_.points[p] = isInside ? from[i] : onFaces[i];
        foot_.normals[p] =
            isInside && mag(out) > VSMALL ? vector(normalised(out))
          : (n & out) < 0 ? -n : n;
        foot_.areOff.set(p, isInside);
        foot_.onSides.set(p, controls_.sides.test(faces[i]));
        isFar_.set(p, mag(out) > controls_.distance);
    }
}


pointIndexHit wrapTargets::nearestLine
(
    const sharpLines& lines,
    const label p,
    const edge& e,
    const scalar length
) const
{
    const point& foot = foot_.points[p];
    const pointIndexHit meeting(foot_.meet(labelList(e), foot, lines, length));
    const pointIndexHit hit
    (
        meeting.hit()
     || foot_.areOff.test(e.start()) || foot_.areOff.test(e.end())
      ? meeting : lines.findNearest(foot, 2*controls_.distance)
    );

    return hit.hit() && mag(hit.rawPoint() - foot) < 2*controls_.distance
      ? hit : pointIndexHit();
}


edgeList wrapTargets::snapToEdges
(
    const sharpLines& lines,
    const wallSurface& wrap
)
{
    DynamicList<edge> chamfers;

    for (const face& f : wrap.faces)
    {
        for (const edge& e : f.edges())
        {
            // Each edge is of two faces
            if (e.start() > e.end() || !isAcross(e))
            {
                continue;
            }

            const scalar length = e.mag(wrap.points);
            const pointIndexHit a(nearestLine(lines, e.start(), e, length));
            const pointIndexHit b(nearestLine(lines, e.end(), e, length));
            const scalar da =
                a.hit() ? mag(a.rawPoint() - foot_.points[e.start()]) : GREAT;
            const scalar db =
                b.hit() ? mag(b.rawPoint() - foot_.points[e.end()]) : GREAT;

            if (min(da, db) < GREAT)
            {
                const bool first = da <= db;
                onEdges_.set
                (
                    first ? e.start() : e.end(),
                    first ? a.rawPoint() : b.rawPoint()
                );
            }
            else
            {
                chamfers.append(e);
            }
        }
    }

    return edgeList(std::move(chamfers));
}

} // End namespace Foam

// ************************************************************************* //
