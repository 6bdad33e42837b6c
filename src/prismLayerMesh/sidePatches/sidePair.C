/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sidePair.H"
#include "dictionary.H"
#include "DynamicList.H"
#include "error.H"
#include "IOstream.H"
#include "matchPoints.H"
#include "transform.H"
#include "unitConversion.H"

namespace Foam
{

//- Largest difference of the unit normals, and largest distance over the
//  distance from the axis or between the planes, of a plane and the image of
//  its partner
static const scalar imageTolerance = 1e-5;


// * * * * * * * * * * * * * * * Rigid Motion  * * * * * * * * * * * * * * * //

rigidMotion rigidMotion::after(const rigidMotion& first) const
{
    return rigidMotion
    {
        turned(first.translation) + translation, R & first.R,
        turns || first.turns
    };
}


rigidMotion rigidMotion::inverse() const
{
    const tensor back(R.T());

    return rigidMotion
    {
        turns ? -(back & translation) : -translation, back, turns
    };
}


sidePlane moved(const sidePlane& plane, const rigidMotion& motion)
{
    return sidePlane{motion(plane.origin), motion.turned(plane.normal)};
}


labelList imagesAmong
(
    const UList<point>& others,
    const UList<point>& points,
    const rigidMotion& motion,
    const scalar tolerance
)
{
    pointField images(points);
    for (point& x : images)
    {
        x = motion(x);
    }
    labelList places(points.size(), -1);
    if (points.size() && others.size())
    {
        matchPoints
        (
            images, others, scalarField(images.size(), tolerance), false, places
        );
    }

    return places;
}


Map<label> imagesByLabel
(
    const labelUList& labels,
    const labelUList& others,
    const std::function<point(label)>& pointOf,
    const rigidMotion& motion,
    const scalar tolerance,
    label& lone
)
{
    const auto pointsOf = [&](const labelUList& some)
    {
        pointField points(some.size());
        forAll(some, i)
        {
            points[i] = pointOf(some[i]);
        }

        return points;
    };
    const labelList places
    (
        imagesAmong(pointsOf(others), pointsOf(labels), motion, tolerance)
    );

    lone = -1;
    Map<label> images(2*labels.size());
    forAll(labels, i)
    {
        if (places[i] >= 0)
        {
            images.insert(labels[i], others[places[i]]);
        }
        if (lone < 0 && (places[i] < 0 || labels.size() != others.size()))
        {
            lone = labels[i];
        }
    }

    return images;
}


// * * * * * * * * * * * * * * * *  Side Pair  * * * * * * * * * * * * * * * //

//- The one side of type cyclic with a name; -1 if there is none
static label findCyclic(const UList<sidePatch>& sides, const word& name)
{
    forAll(sides, s)
    {
        if (sides[s].name == name && sides[s].type == "cyclic")
        {
            return s;
        }
    }

    return -1;
}


//- Moves a plane to its image
static rigidMotion motionTo(const sidePatch& first, const sidePatch& second)
{
    const cyclicControls& cyclic = first.cyclic;
    if (!(mag(cyclic.axis) > 0))
    {
        const scalar width = -first.distance(second.origin);

        return rigidMotion{-width*first.normal, tensor::I, false};
    }

    // OpenFOAM's Ra turns the coordinates
    const tensor R(Ra(normalised(cyclic.axis), -degToRad(cyclic.angle)));

    return rigidMotion{cyclic.origin - (R & cyclic.origin), R, true};
}


//- Refuses a pair whose second plane is not the image of the first
static void checkImage
(
    const sidePatch& first,
    const sidePatch& second,
    const rigidMotion& motion
)
{
    const sidePlane image(moved(first, motion));
    const scalar size =
        motion.turns
      ? mag(second.origin - first.cyclic.origin) : mag(motion.translation);
    const scalar distance = mag(second.distance(image.origin));

    if
    (
        mag(image.normal + second.normal) > imageTolerance
     || distance > imageTolerance*size
    )
    {
        FatalErrorInFunction
            << "The side patch " << second.name << " is not the image of its"
            << " partner " << first.name << ": the image has the normal "
            << -image.normal << " and is " << distance << " m away" << nl
            << (motion.turns
              ? "Check axis, origin and angle of the rotation"
              : "Planes with a translation are parallel, with opposite normals;"
                " others need a rotation")
            << exit(FatalError);
    }
}


static void requirePlane(const sidePatch& side)
{
    if (side.isPart())
    {
        FatalErrorInFunction
            << "The side patch " << side.name << " of type cyclic is a part of"
            << " the surface. It has to be a plane of surface.sidePlanes, or a"
            << " side of the box" << exit(FatalError);
    }
}


List<sidePair> pairsOf(const UList<sidePatch>& sides)
{
    DynamicList<sidePair> pairs;
    labelList partners(sides.size(), -1);
    forAll(sides, s)
    {
        const sidePatch& side = sides[s];
        if (side.type != "cyclic" || side.cyclic.partner.empty())
        {
            continue;
        }

        requirePlane(side);
        const label t = findCyclic(sides, side.cyclic.partner);
        if (t < 0 || t == s || (partners[t] >= 0 && partners[t] != s))
        {
            FatalErrorInFunction
                << "The side patch " << side.name << " has the partner "
                << side.cyclic.partner
                << (t < 0 || t == s
                  ? ", which is no other side patch of type cyclic on which"
                    " the wall ends"
                  : ", which has another partner") << nl
                << "Write the names of both sides into each other's partner"
                << exit(FatalError);
        }
        requirePlane(sides[t]);

        if (partners[s] < 0)
        {
            const rigidMotion motion(motionTo(side, sides[t]));
            checkImage(side, sides[t], motion);
            pairs.append(sidePair{s, t, motion});
        }
        partners[s] = t;
        partners[t] = s;
    }

    forAll(sides, s)
    {
        if (sides[s].type == "cyclic" && partners[s] < 0)
        {
            FatalErrorInFunction
                << "The side patch " << sides[s].name << " of type cyclic has"
                << " no partner on which the wall ends" << nl
                << "Write partner <name>; of a second side of type cyclic"
                << exit(FatalError);
        }
    }

    return List<sidePair>(std::move(pairs));
}


dictionary sidePair::entries
(
    const UList<sidePatch>& sides,
    const label side
) const
{
    const sidePatch& other = sides[side == first ? second : first];
    const cyclicControls& cyclic = sides[first].cyclic;
    dictionary entries;

    // An entry has the digits of the default
    const unsigned digits = IOstream::defaultPrecision(17);
    entries.add("type", word("cyclic"));
    entries.add("neighbourPatch", other.name);
    if (toSecond.turns)
    {
        entries.add("transform", word("rotational"));
        entries.add("rotationAxis", cyclic.axis);
        entries.add("rotationCentre", cyclic.origin);
    }
    else
    {
        entries.add("transform", word("translational"));
        entries.add
        (
            "separationVector",
            side == first ? toSecond.translation : -toSecond.translation
        );
    }
    IOstream::defaultPrecision(digits);

    return entries;
}

} // End namespace Foam

// ************************************************************************* //
