/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "makePrismLayers.H"
#include "prismQuality.H"
#include "wallClearance.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What a round leaves of the height of a column that retreats
static const scalar retreatFactor = 0.8;

//- What it takes of the way back to the axis of the visibility cone
static const scalar straightenShare = 0.25;

//- Bound on the gradient of the heights along the wall
static const scalar heightSlope = 1;

//- A cell is acceptable when its scaled Jacobian is this share of what it is
//  with low columns on the axes of the cones. Relative to that, since slivers
//  of the wall have poor cells at any height.
static const scalar jacobianShare = 0.05;

//- Heights then are below 1e-9 of what they were
static const label maxRounds = 100;


class retreat
{
    const wallSurface& wall_;
    const wallAddressing& addressing_;
    const wallVisibility& visibility_;
    const layerSpacing& spacing_;
    const scalar maxStretch_;

    layerColumns& columns_;
    prismLayers layers_;

    //- How far each column has gone back to the axis, 0 to 1
    scalarField straightened_;

    //- Scaled Jacobians of each front face's cells as they would be with low
    //  columns on the axes
    scalarField bestJacobians_;

    //- Front faces with a column that the last round moved
    labelList candidates_;


    scalar bestJacobian(const face& f) const
    {
        scalar worst = GREAT;

        forAll(f, k)
        {
            const point& p = wall_.points[f[k]];
            const vector next = wall_.points[f.nextLabel(k)] - p;
            const vector prev = wall_.points[f.prevLabel(k)] - p;

            worst = min
            (
                worst,
                ((next ^ prev) & visibility_.cones[f[k]].axis)
               /max(mag(next)*mag(prev), VSMALL)
            );
        }

        return worst;
    }


    //- Candidates with a cell that is not positive or not acceptable
    labelList poorFaces() const
    {
        DynamicList<label> poor;

        for (const label facei : candidates_)
        {
            const scalar smallest = jacobianShare*bestJacobians_[facei];

            for (label i = 1; i <= spacing_.nLayers; ++i)
            {
                if
                (
                    scaledJacobian(layers_, facei, i) < smallest
                 || !isPositive(layers_, facei, i)
                )
                {
                    poor.append(facei);
                    break;
                }
            }
        }

        return labelList(std::move(poor));
    }


    //- Points of a column
    void build(const label p)
    {
        const label n = spacing_.nLayers;
        scalarList heights(n + 1);
        layerHeights
        (
            n,
            spacing_.firstThickness[p],
            spacing_.ratio[p],
            columns_.room[p],
            heights
        );

        const visibilityCone& cone = visibility_.cones[p];
        const vector axis = cone.axis
           /max(visibility_.heightCosine(p, cone.axis), 1/maxStretch_);
        const scalar s = straightened_[p];

        for (label i = 0; i <= n; ++i)
        {
            layers_.points[layers_.pointLabel(p, i)] = wall_.points[p]
              + heights[i]
               *((1 - s)*columns_.offset(p, heights[i]) + s*axis);
        }
    }


    //- Take the columns back, and rebuild those that this moved
    void step(const labelUList& retreating, const squeezeCause cause)
    {
        boolList moved(wall_.points.size(), false);

        for (const label p : retreating)
        {
            columns_.room[p] *= retreatFactor;
            columns_.causes[p] = cause;
            straightened_[p] += straightenShare*(1 - straightened_[p]);
            moved[p] = true;
        }

        for
        (
            const label p
          : limitGradient(wall_, addressing_, heightSlope, columns_.room)
        )
        {
            if (columns_.causes[p] == squeezeCause::none)
            {
                columns_.causes[p] = squeezeCause::neighbour;
            }
            moved[p] = true;
        }

        boolList touched(wall_.faces.size(), false);
        forAll(moved, p)
        {
            if (moved[p])
            {
                build(p);
                for (const label facei : addressing_.pointFaces[p])
                {
                    touched[facei] = true;
                }
            }
        }

        candidates_ = findIndices(touched, true);
    }


    //- Columns of the front faces, each once
    labelList columnsOf(const labelUList& faces) const
    {
        boolList used(wall_.points.size(), false);
        for (const label facei : faces)
        {
            for (const label p : wall_.faces[facei])
            {
                used[p] = true;
            }
        }

        return findIndices(used, true);
    }


    [[noreturn]] void giveUp(const labelUList& points, const char* what) const
    {
        FatalErrorInFunction
            << "Columns at " << points.size() << " points of the wall " << what
            << " at any thickness. The first of them:" << nl;

        for (label i = 0; i < min(points.size(), 10); ++i)
        {
            FatalError
                << "    point " << points[i] << " at "
                << wall_.points[points[i]] << nl;
        }

        FatalError << exit(FatalError);
        ::abort();
    }


public:

    retreat
    (
        const wallSurface& wall,
        const wallAddressing& addressing,
        const wallVisibility& visibility,
        const layerSpacing& spacing,
        const scalar maxStretch,
        layerColumns& columns
    )
    :
        wall_(wall),
        addressing_(addressing),
        visibility_(visibility),
        spacing_(spacing),
        maxStretch_(maxStretch),
        columns_(columns),
        straightened_(wall.points.size(), 0),
        bestJacobians_(wall.faces.size()),
        candidates_(identity(wall.faces.size()))
    {
        layers_.nLayers = spacing.nLayers;
        layers_.faces = wall.faces;
        layers_.patchIDs = wall.patchIDs;
        layers_.patchNames = wall.patchNames;
        layers_.points.setSize(wall.points.size()*(spacing.nLayers + 1));

        forAll(wall.points, p)
        {
            build(p);
        }

        forAll(wall.faces, facei)
        {
            bestJacobians_[facei] = bestJacobian(wall.faces[facei]);
        }
    }


    //- Until all cells are positive and acceptable
    void makePositive()
    {
        for (label round = 0; ; ++round)
        {
            const labelList faces(poorFaces());

            if (faces.empty())
            {
                return;
            }

            const labelList points(columnsOf(faces));

            if (round == maxRounds)
            {
                giveUp(points, "have cells that are not positive");
            }

            step(points, squeezeCause::validity);
        }
    }


    //- Until wall and outer surface are embedded too
    void makeEmbedded()
    {
        for (label round = 0; ; ++round)
        {
            makePositive();

            const List<labelPair> pairs(findIntersections(layers_));

            if (pairs.empty())
            {
                return;
            }

            DynamicList<label> faces(2*pairs.size());
            for (const labelPair& pair : pairs)
            {
                for (const label f : pair)
                {
                    if (f >= wall_.faces.size())
                    {
                        faces.append(f - wall_.faces.size());
                    }
                }
            }

            const labelList points(columnsOf(faces));

            if (round == maxRounds)
            {
                giveUp(points, "intersect");
            }

            step(points, squeezeCause::intersection);
        }
    }


    prismLayers result()
    {
        return std::move(layers_);
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::prismLayers Foam::makePrismLayers
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallVisibility& visibility,
    const layerSpacing& spacing,
    const scalar maxStretch,
    layerColumns& columns
)
{
    retreat layers
    (
        wall, addressing, visibility, spacing, maxStretch, columns
    );
    layers.makeEmbedded();

    return layers.result();
}


// ************************************************************************* //
