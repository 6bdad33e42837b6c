/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "makePrismLayers.H"
#include "poorStacks.H"
#include "tallColumns.H"
#include "prismQuality.H"
#include "wallClearance.H"
#include "wallGraph.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- How often a column turns to its neighbours before it retreats
static const label maxTurns = 10;

//- Share of the tallest room beside which a column retreats too
static const scalar tallShare = 0.8;

//- What a round leaves of the height of a column that retreats
static const scalar retreatFactor = 0.8;

//- What it takes of the way back to the axis of the visibility cone
static const scalar straightenShare = 0.25;

//- Bound on the gradient of the heights along the wall
static const scalar heightSlope = 1;

//- What is left of the height of a column when there is no hope for it
static const scalar hopeless = 1e-9;


class retreat
{
    const wallSurface& wall_;
    const wallAddressing& addressing_;
    const wallVisibility& visibility_;
    const layerSpacing& spacing_;
    const scalar maxStretch_;

    layerColumns& columns_;
    prismLayers layers_;

    const wallGraph graph_;

    //- How often each column has turned
    labelList turns_;

    //- How far each column has gone back to the axis, 0 to 1
    scalarField straightened_;

    //- What the cells of each front face are compared with
    const scalarField bestJacobians_;

    //- Front faces with a column that the last round moved
    labelList candidates_;


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

        const vector axis
        (
            columnOffset
            (
                visibility_, p, visibility_.cones[p].axis, maxStretch_
            )
        );
        const scalar s = straightened_[p];

        for (label i = 0; i <= n; ++i)
        {
            layers_.points[layers_.index(p, i)] = wall_.points[p]
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

        rebuild(moved);
    }


    //- Build the columns that were moved; their faces are the candidates
    void rebuild(const boolList& moved)
    {
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


    //- Turn the columns and their neighbours to the mean of those around them.
    //  False where all of them have done so often enough.
    bool turn(const labelUList& poor)
    {
        boolList moved(wall_.points.size(), false);
        bool any = false;

        for (const label p : poor)
        {
            moved[p] = true;

            if (turns_[p] < maxTurns)
            {
                any = true;
                for (const label q : addressing_.pointPoints[p])
                {
                    moved[q] = true;
                }
            }
        }

        if (!any)
        {
            return false;
        }

        const label n = spacing_.nLayers;
        const labelList turning(findIndices(moved, true));
        vectorField turned(turning.size()*n);

        forAll(turned, k)
        {
            const label p = turning[k/n];
            const vector& own = columns_.offsets[p*n + k % n];
            const vector mean = graph_.mean(columns_.offsets, p, n, k % n);

            // Less so near to the wall, where columns stand upright
            const scalar share = wallGraph::fullPass*::sqrt
            (
                columns_.heights[p*n + k % n]/columns_.heights[p*n + n - 1]
            );

            turned[k] = columnOffset
            (
                visibility_, p, own + share*(mean - own), maxStretch_
            );
        }

        forAll(turned, k)
        {
            columns_.offsets[turning[k/n]*n + k % n] = turned[k];
            turns_[turning[k/n]] += k % n == 0;
        }

        rebuild(moved);

        return true;
    }


    labelList tall(const UList<labelPair>& pairs, const scalar share) const
    {
        return tallColumns(wall_.faces, pairs, columns_.room, share);
    }


    //- Those of the faces whose outer sides intersect
    List<labelPair> intersectingFaces() const
    {
        const label nFaces = wall_.faces.size();
        List<labelPair> pairs(findIntersections(layers_));

        for (labelPair& pair : pairs)
        {
            // A face of the wall cannot move; the other one does
            const label outer = max(pair.first(), pair.second());

            for (label& f : pair)
            {
                f = (f < nFaces ? outer : f) - nFaces;
            }
        }

        return pairs;
    }


    //- FatalError where columns that retreat have no height left
    void giveUpHopeless(const labelUList& points, const char* what) const
    {
        DynamicList<label> lost;
        for (const label p : points)
        {
            if (columns_.room[p] < hopeless*spacing_.thickness[p])
            {
                lost.append(p);
            }
        }

        if (lost.empty())
        {
            return;
        }

        FatalErrorInFunction
            << "Columns at " << lost.size() << " points of the wall " << what
            << " at any thickness. The first of them:" << nl;

        for (label i = 0; i < min(lost.size(), 10); ++i)
        {
            FatalError
                << "    point " << lost[i] << " at " << wall_.points[lost[i]]
                << nl;
        }

        FatalError << exit(FatalError);
    }


public:

    retreat
    (
        const layerFront& front,
        const layerSpacing& spacing,
        const scalar maxStretch,
        layerColumns& columns
    )
    :
        wall_(front.surface),
        addressing_(front.addressing),
        visibility_(front.visibility),
        spacing_(spacing),
        maxStretch_(maxStretch),
        columns_(columns),
        graph_(makeWallGraph(wall_, addressing_)),
        turns_(wall_.points.size(), 0),
        straightened_(wall_.points.size(), 0),
        bestJacobians_(bestJacobians(wall_, visibility_)),
        candidates_(identity(wall_.faces.size()))
    {
        layers_.nLayers = spacing.nLayers;
        layers_.faces = wall_.faces;
        layers_.patchIDs =
            SubList<label>(wall_.patchIDs, front.nWallFaces);
        layers_.patchNames = wall_.patchNames;
        layers_.furtherRoots = front.furtherRoots();
        layers_.points.setSize(wall_.points.size()*(spacing.nLayers + 1));

        forAll(wall_.points, p)
        {
            build(p);
        }
    }


    //- Until all cells are positive and good enough
    void makePositive()
    {
        while (true)
        {
            const labelList poor
            (
                findPoorStacks(layers_, bestJacobians_, candidates_)
            );

            if (poor.empty())
            {
                return;
            }

            List<labelPair> pairs(poor.size());
            forAll(poor, i)
            {
                pairs[i] = labelPair(poor[i], poor[i]);
            }

            if (!turn(tall(pairs, 0)))
            {
                const labelList points(tall(pairs, tallShare));

                giveUpHopeless(points, "have cells that are not positive");
                step(points, squeezeCause::validity);
            }
        }
    }


    //- Until wall and outer surface are embedded too
    void makeEmbedded()
    {
        while (true)
        {
            makePositive();

            const List<labelPair> pairs(intersectingFaces());

            if (pairs.empty())
            {
                return;
            }

            const labelList points(tall(pairs, tallShare));

            giveUpHopeless(points, "intersect");
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
    const layerFront& front,
    const layerSpacing& spacing,
    const scalar maxStretch,
    layerColumns& columns
)
{
    retreat layers(front, spacing, maxStretch, columns);
    layers.makeEmbedded();

    return layers.result();
}


// ************************************************************************* //
