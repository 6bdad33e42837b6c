/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallChanges.H"
#include "ListOps.H"
#include "UIndirectList.H"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <utility>
#include <vector>

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList hilbertOrder(const UList<point>& points)
{
    using kernel = CGAL::Simple_cartesian<double>;
    using place = std::pair<kernel::Point_3, label>;
    using traits = CGAL::Spatial_sort_traits_adapter_3
    <
        kernel, CGAL::First_of_pair_property_map<place>
    >;

    std::vector<place> places;
    places.reserve(points.size());
    forAll(points, p)
    {
        const point& x = points[p];
        places.emplace_back(kernel::Point_3(x.x(), x.y(), x.z()), p);
    }

    CGAL::hilbert_sort(places.begin(), places.end(), traits());

    labelList order(points.size());
    forAll(order, i)
    {
        order[i] = places[i].second;
    }

    return order;
}


void renumberWall(wallSurface& wall)
{
    const labelList order(hilbertOrder(wall.points));
    const labelList newPoints(invert(order.size(), order));

    wall.points = pointField(wall.points, order);

    labelList firstPoints(wall.faces.size());
    forAll(wall.faces, facei)
    {
        inplaceRenumber(newPoints, wall.faces[facei]);
        firstPoints[facei] = min(wall.faces[facei]);
    }

    const labelList faceOrder(sortedOrder(firstPoints));
    wall.faces = faceList(UIndirectList<face>(wall.faces, faceOrder));
    wall.patchIDs = labelList(UIndirectList<label>(wall.patchIDs, faceOrder));

    for (edge& e : wall.border.edges)
    {
        inplaceRenumber(newPoints, e);
    }
}

} // End namespace Foam

// ************************************************************************* //
