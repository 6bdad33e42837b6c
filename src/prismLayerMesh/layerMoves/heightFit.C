/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heightFit.H"

#include <algorithm>
#include <Eigen/SparseCholesky>

namespace Foam
{

typedef Eigen::SparseMatrix<double> sparseMatrix;


//- A.sqrt(M): three columns for each column of the layers
static sparseMatrix heightsOfDisplacements
(
    const wallSurface& wall,
    const labelUList& faces,
    const scalarField& mobilities
)
{
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(12*faces.size());

    forAll(faces, i)
    {
        const face& f = wall.faces[faces[i]];
        const vector n(normalised(f.areaNormal(wall.points))/f.size());

        for (const label c : f)
        {
            const scalar mobility = ::sqrt(mobilities[c]);

            for (direction d = 0; d < 3; ++d)
            {
                entries.emplace_back(i, 3*c + d, mobility*n[d]);
            }
        }
    }

    sparseMatrix a(faces.size(), 3*wall.points.size());
    a.setFromTriplets(entries.begin(), entries.end());

    return a;
}


static sparseMatrix damped(const sparseMatrix& a, const scalar lambda)
{
    sparseMatrix identity(a.rows(), a.rows());
    identity.setIdentity();

    return a*sparseMatrix(a.transpose()) + lambda*identity;
}


// * * * * * * * * * * * * * * Private Classes * * * * * * * * * * * * * * * //

struct heightFit::factors
{
    scalarField mobilities;
    sparseMatrix a;
    Eigen::SimplicialLDLT<sparseMatrix> inverse;
};


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

heightFit::heightFit
(
    const wallSurface& wall,
    const labelUList& faces,
    const scalar lambda
)
:
    wall_(wall),
    faces_(faces),
    lambda_(lambda),
    factors_(new factors)
{}


heightFit::~heightFit() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void heightFit::setMobilities(const scalarField& mobilities)
{
    const bool first = factors_->mobilities.empty();
    factors_->mobilities = mobilities;
    factors_->a = heightsOfDisplacements(wall_, faces_, mobilities);

    const sparseMatrix product(damped(factors_->a, lambda_));

    if (first)
    {
        factors_->inverse.analyzePattern(product);
    }
    factors_->inverse.factorize(product);
}


vectorField heightFit::displacements(const scalarField& missing) const
{
    const Eigen::Map<const Eigen::VectorXd> r(missing.cdata(), missing.size());
    const Eigen::VectorXd d(factors_->a.transpose()*factors_->inverse.solve(r));

    vectorField result(d.size()/3);
    forAll(result, c)
    {
        result[c] = ::sqrt(factors_->mobilities[c])
           *vector(d[3*c], d[3*c + 1], d[3*c + 2]);
    }

    return result;
}


// * * * * * * * * * * * * * * *  Fitted Wall  * * * * * * * * * * * * * * * //

namespace
{

//- A corner of a face; labels are those of the whole front
struct fittedCorner
{
    label facei;
    label column;
    point x;
    scalar mobility;
    scalar height;
};

}


static List<fittedCorner> cornersOf
(
    const layerEditor& editor,
    const labelUList& faces,
    const scalarField& mobilities,
    const label level
)
{
    const columnTeam& team = editor.team();
    DynamicList<fittedCorner> corners(3*faces.size());
    for (const label facei : faces)
    {
        for (const label c : editor.layers().faces[facei])
        {
            corners.append
            ({
                team.wholeFace(facei), team.wholeColumn(c),
                editor.layers()(c, 0), mobilities[c], editor.heights(c)[level]
            });
        }
    }

    return List<fittedCorner>(std::move(corners));
}


//- Add the points of a wall, the columns in ascending order. Returns the label
//  in the whole front of each.
static labelList addPoints(const UList<fittedCorner>& corners, fittedWall& w)
{
    labelList columns(corners.size());
    forAll(corners, i)
    {
        columns[i] = corners[i].column;
    }
    inplaceUniqueSort(columns);

    w.wall.points.setSize(columns.size());
    w.mobilities.setSize(columns.size());
    w.heights.setSize(columns.size());
    for (const fittedCorner& corner : corners)
    {
        const label p =
            std::lower_bound(columns.begin(), columns.end(), corner.column)
          - columns.begin();
        w.wall.points[p] = corner.x;
        w.mobilities[p] = corner.mobility;
        w.heights[p] = corner.height;
    }

    return columns;
}


//- Add the faces in the order of the whole front
static void addFaces
(
    const UList<fittedCorner>& corners,
    const labelUList& columns,
    fittedWall& w
)
{
    DynamicList<label> firstCorners, labels;
    forAll(corners, i)
    {
        if (i == 0 || corners[i].facei != corners[i - 1].facei)
        {
            firstCorners.append(i);
            labels.append(corners[i].facei);
        }
    }

    w.order = sortedOrder(labels);
    w.wall.faces.setSize(labels.size());
    forAll(w.order, i)
    {
        DynamicList<label> f;
        for
        (
            label k = firstCorners[w.order[i]];
            k < corners.size() && corners[k].facei == labels[w.order[i]];
            ++k
        )
        {
            f.append
            (
                std::lower_bound
                (
                    columns.begin(), columns.end(), corners[k].column
                )
              - columns.begin()
            );
        }
        w.wall.faces[i] = face(labelList(std::move(f)));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalarField fittedWall::ofAll
(
    const columnTeam& team,
    const scalarField& values
) const
{
    return scalarField(team.gather(values), order);
}


fittedWall makeFittedWall
(
    const layerEditor& editor,
    const labelUList& faces,
    const scalarField& mobilities,
    const label level
)
{
    const columnTeam& team = editor.team();
    const faceList& columnsOf = editor.layers().faces;
    fittedWall w;
    w.counted = subsetList(faces, [&](const label facei)
    {
        // Images of faces are beside own columns, too
        const bool counts =
            team.hasImages()
          ? team.hasOwn(columnsOf[facei]) : team.countsFace(facei);

        return counts
            && max(scalarField(mobilities, columnsOf[facei])) > 0;
    });

    const List<fittedCorner> corners
    (
        team.gather(cornersOf(editor, w.counted, mobilities, level))
    );
    const labelList columns(addPoints(corners, w));
    addFaces(corners, columns, w);

    w.ownColumns.setSize(columns.size());
    forAll(columns, p)
    {
        const label c = team.columns.here(columns[p]);
        w.ownColumns[p] = c >= 0 && team.isOwn(c) ? c : -1;
    }

    return w;
}

} // End namespace Foam

// ************************************************************************* //
