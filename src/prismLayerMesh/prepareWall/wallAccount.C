/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallAccount.H"
#include "boundBox.H"
#include "hidingParts.H"
#include "HashSet.H"
#include "ListOps.H"
#include "nearestSurface.H"
#include "OStringStream.H"
#include "ranges.H"
#include "waysOnSurface.H"

#include <numeric>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The tolerance of a part is at most this share of its diagonal: a part that
//  is gone is not near to what it stood on
static constexpr scalar partShare = 0.02;

//- Less than this share of all area does not count as lost: stray facets
static constexpr scalar strayShare = 2e-4;

//- A patch without faces is missing if more than this share of its area is kept
//  or lost. At the rim of a patch in a side plane places are near to the wall.
static constexpr scalar missingShare = 0.1;

//- Solid angles of triangles that a part may take; of more samples each n-th is
//  tested
static constexpr scalar maxAngles = 1e8;


scalar areaAccount::area() const
{
    return std::accumulate(areas.begin(), areas.end(), scalar(0));
}


scalar areaAccount::lostShare() const
{
    const scalar counted = area(areaFate::kept) + area(areaFate::lost);

    return counted > 0 ? area(areaFate::lost)/counted : 0;
}


void areaAccount::add
(
    const areaFate fate,
    const scalar area,
    const scalar distance,
    const point& x
)
{
    areas[label(fate)] += area;
    if (fate == areaFate::lost)
    {
        ++nLost;
        if (distance > farthest)
        {
            farthest = distance;
            place = x;
        }
    }
}


namespace
{

//- Distance [m] of the points of a polygon from its mean plane: polygons
//  are cut into triangles in one way or another
scalar warpOf(const face& f, const pointField& points)
{
    if (f.size() == 3)
    {
        return 0;
    }
    const point centre(f.centre(points));
    const vector normal(f.unitNormal(points));
    scalar warp = 0;
    for (const label p : f)
    {
        warp = max(warp, mag((points[p] - centre) & normal));
    }

    return 2*warp;
}


class accountant
{
    const wallSurface& given_;
    const wallSurface& wall_;
    const nearestSurface nearest_;
    const accountControls& controls_;
    const PtrList<givenPart> parts_;
    PtrList<nearestSurface> nearestOf_;

    //- Of what is apart from the fluid; empty if nothing is
    autoPtr<nearestSurface> apart_;

    //- Sets the fate of samples that are inside of others, or of their own part
    void setInside
    (
        const label parti,
        const scalar offset,
        List<areaFate>& fates
    ) const
    {
        const List<surfaceSample>& samples = parts_[parti].samples;
        const labelList lost
        (
            subsetList(identity(samples.size()), [&](const label i)
            {
                return fates[i] == areaFate::lost;
            })
        );
        if (lost.empty())
        {
            return;
        }

        const hidingParts hiding(parts_, parti, controls_.fluidOutside);
        const label step = 1 + lost.size()*hiding.nTriangles()/maxAngles;

        #pragma omp parallel for schedule(dynamic)
        for (label i = 0; i < lost.size(); i += step)
        {
            const surfaceSample& s = samples[lost[i]];
            const face& f = given_.faces[s.facei];
            if (hiding.hide(s.x, offset*f.unitNormal(given_.points)))
            {
                for (label k = i; k < min(i + step, lost.size()); ++k)
                {
                    fates[lost[k]] = areaFate::inside;
                }
            }
        }
    }

    //- Sets the fate of samples that other parts touch
    void setContacts
    (
        const label parti,
        const scalar tolerance,
        List<areaFate>& fates
    )
    {
        const List<surfaceSample>& samples = parts_[parti].samples;
        forAll(parts_, j)
        {
            const vector off(tolerance*vector::one);
            const boundBox& box = parts_[j].box;
            const boundBox around(box.min() - off, box.max() + off);
            DynamicList<label> some;
            DynamicList<point> places;
            forAll(samples, i)
            {
                const point& x = samples[i].x;
                if
                (
                    j != parti && fates[i] == areaFate::lost
                 && parts_[j].triangles.size() && around.contains(x)
                )
                {
                    some.append(i);
                    places.append(x);
                }
            }
            if (some.empty())
            {
                continue;
            }
            if (!nearestOf_.set(j))
            {
                nearestOf_.set(j, new nearestSurface(parts_[j].surface));
            }
            pointField nearest;
            labelList faces;
            nearestOf_[j].find(pointField(places), nearest, faces);
            forAll(some, i)
            {
                if (mag(nearest[i] - places[i]) <= tolerance)
                {
                    fates[some[i]] = areaFate::contact;
                }
            }
        }
    }

    //- Sets the fate of samples near to what is apart from the fluid
    void setApart
    (
        const pointField& x,
        const scalar tolerance,
        List<areaFate>& fates
    ) const
    {
        if (!apart_)
        {
            return;
        }
        pointField nearest;
        labelList faces;
        apart_->find(x, nearest, faces);
        forAll(fates, i)
        {
            if
            (
                fates[i] == areaFate::lost
             && mag(nearest[i] - x[i]) <= tolerance
            )
            {
                fates[i] = areaFate::apart;
            }
        }
    }

    areaFate fateOf
    (
        const surfaceSample& sample,
        const scalar distance,
        const scalar tolerance
    ) const
    {
        if (distance <= tolerance)
        {
            return areaFate::kept;
        }

        return
            anyOf(controls_.planes, [&](const sidePatch& plane)
            {
                return plane.distance(sample.x) > -tolerance;
            })
          ? areaFate::beyond : areaFate::lost;
    }

    void addPart(const label parti, wallAccount& account)
    {
        const givenPart& part = parts_[parti];
        const scalar tolerance = max
        (
            controls_.move, min(account.tolerance, partShare*part.box.mag())
        );
        pointField x(part.samples.size());
        forAll(x, i)
        {
            x[i] = part.samples[i].x;
        }
        pointField nearest;
        labelList faces;
        nearest_.find(x, nearest, faces);
        const scalarField distances(mag(nearest - x));
        List<areaFate> fates(x.size());
        forAll(fates, i)
        {
            fates[i] = fateOf
            (
                part.samples[i], distances[i],
                tolerance
              + warpOf(given_.faces[part.samples[i].facei], given_.points)
            );
        }
        setApart(x, tolerance, fates);
        setContacts(parti, tolerance, fates);
        setInside(parti, tolerance, fates);

        areaAccount& ofPart = account.parts[parti];
        ofPart.isPart = true;
        ofPart.patch = given_.patchNames[given_.patchIDs[part.faces[0]]];
        forAll(fates, i)
        {
            const surfaceSample& s = part.samples[i];
            account.closeArea +=
                fates[i] == areaFate::kept
             && distances[i] <= account.closeDistance ? s.area : 0;
            areaAccount& ofPatch = account.patches[given_.patchIDs[s.facei]];
            for (areaAccount* a : {&account.all, &ofPart, &ofPatch})
            {
                a->add(fates[i], s.area, distances[i], s.x);
            }
        }
    }

    void setMissingPatches(wallAccount& account) const
    {
        wordHashSet there;
        for (const label patchi : wall_.patchIDs)
        {
            there.insert(wall_.patchNames[patchi]);
        }
        for (const areaAccount& patch : account.patches)
        {
            const scalar counted =
                patch.area(areaFate::kept) + patch.area(areaFate::lost);
            if
            (
                counted > missingShare*patch.area()
             && counted > strayShare*account.all.area()
             && !there.found(patch.patch)
            )
            {
                account.missingPatches.append(patch.patch);
            }
        }
    }

public:

    accountant
    (
        const wallSurface& given,
        const wallSurface& wall,
        const accountControls& controls
    )
    :
        given_(given),
        wall_(wall),
        nearest_(wall),
        controls_(controls),
        parts_(makeGivenParts(given, controls.planes))
    {
        if (controls.apart.faces.size())
        {
            apart_.reset(new nearestSurface(controls.apart));
        }
        nearestOf_.setSize(parts_.size());
    }

    wallAccount make()
    {
        wallAccount account;
        account.closeDistance =
            wallAccount::closeShare
           *diagonalInFront(given_.points, controls_.planes);
        account.tolerance = max(account.closeDistance, controls_.move);
        account.parts.setSize(parts_.size());
        account.patches.setSize(given_.patchNames.size());
        forAll(account.patches, i)
        {
            account.patches[i].patch = given_.patchNames[i];
        }
        forAll(parts_, i)
        {
            if (parts_[i].samples.size())
            {
                addPart(i, account);
            }
        }
        setMissingPatches(account);

        return account;
    }
};


//- Whether an account is worse than a share, and not accepted
bool isWorse
(
    const areaAccount& account,
    const wordRes& accepted,
    const scalar share,
    const scalar least
)
{
    return
        account.area(areaFate::lost) > least && account.lostShare() > share
     && !accepted.match(account.patch);
}


scalar percent(const scalar part, const scalar whole)
{
    return whole > 0 ? 100*part/whole : 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

wallAccount makeWallAccount
(
    const wallSurface& given,
    const wallSurface& surface,
    const accountControls& controls
)
{
    return accountant(given, surface, controls).make();
}


wallAccount makeWallAccount(const wallSurface& given)
{
    wallAccount account;
    account.patches.setSize(given.patchNames.size());
    forAll(account.patches, i)
    {
        account.patches[i].patch = given.patchNames[i];
    }
    forAll(given.faces, i)
    {
        const scalar area = given.faces[i].mag(given.points);
        account.patches[given.patchIDs[i]].add
        (
            areaFate::kept, area, 0, Zero
        );
        account.all.add(areaFate::kept, area, 0, Zero);
    }
    account.closeArea = account.all.area();

    return account;
}


string describeLosses
(
    const wallAccount& account,
    const wordRes& accepted,
    const scalar share,
    const bool ofParts
)
{
    const scalar least = strayShare*account.all.area();
    OStringStream os;
    for (const word& patch : account.missingPatches)
    {
        if (!accepted.match(patch))
        {
            os  << "The wall has no face of the patch " << patch
                << " of the files." << nl;
        }
    }

    const areaAccount* worst = nullptr;
    for (const List<areaAccount>* accounts : {&account.parts, &account.patches})
    {
        for (const areaAccount& a : *accounts)
        {
            const scalar most = worst ? worst->area(areaFate::lost) : 0;
            if
            (
                (ofParts || !a.isPart) && isWorse(a, accepted, share, least)
             && a.area(areaFate::lost) > most
            )
            {
                worst = &a;
            }
        }
    }
    if (worst)
    {
        os  << "The wall misses " << 100*worst->lostShare() << " % ("
            << worst->area(areaFate::lost) << " m2) of "
            << (worst->isPart ? "a part of the patch " : "the patch ")
            << worst->patch << " of the files, up to " << worst->farthest
            << " m from the wall at " << worst->place << '.' << nl
            << "No other body is there, and no side." << nl;
    }

    return os.str();
}


string describe(const wallAccount& account)
{
    const areaAccount& all = account.all;
    const scalar whole = all.area();
    OStringStream os;
    os  << "of " << whole << " m2 in the files "
        << percent(all.area(areaFate::kept), whole) << " % are in the wall";
    if (account.closeArea < (1 - 1e-6)*all.area(areaFate::kept))
    {
        os  << " (" << percent(account.closeArea, whole) << " % within "
            << account.closeDistance << " m, the others within "
            << account.tolerance << " m)";
    }
    const auto tell = [&](const areaFate fate, const char* what)
    {
        if (all.area(fate) > 0)
        {
            os  << ", " << percent(all.area(fate), whole) << " % " << what;
        }
    };
    tell(areaFate::beyond, "beyond the box or side planes, or in them");
    tell(areaFate::apart, "not beside the fluid of surface.inside");
    tell(areaFate::contact, "where parts touch");
    tell(areaFate::inside, "inside of other bodies");
    tell(areaFate::lost, "LOST");
    if (all.nLost)
    {
        os  << ", up to " << all.farthest << " m from the wall at "
            << all.place;
    }

    return os.str();
}


static dictionary toDictionary(const areaAccount& account)
{
    const scalar whole = account.area();
    const auto share = [&](const areaFate fate)
    {
        return percent(account.area(fate), whole);
    };
    dictionary dict;
    dict.add("area", whole);
    dict.add("keptPercent", share(areaFate::kept));
    dict.add("beyondSidesPercent", share(areaFate::beyond));
    dict.add("apartPercent", share(areaFate::apart));
    dict.add("contactPercent", share(areaFate::contact));
    dict.add("insidePercent", share(areaFate::inside));
    dict.add("lostPercent", share(areaFate::lost));
    if (account.nLost)
    {
        dict.add("lostPlace", account.place);
        dict.add("lostDistance", account.farthest);
    }

    return dict;
}


dictionary toDictionary(const wallAccount& account)
{
    dictionary dict(toDictionary(account.all));
    dict.add
    (
        "closePercent", percent(account.closeArea, account.all.area())
    );
    dict.add("closeDistance", account.closeDistance);
    dict.add("tolerance", account.tolerance);
    dictionary patches;
    for (const areaAccount& patch : account.patches)
    {
        patches.add(patch.patch, toDictionary(patch));
    }
    dict.add("patches", patches);

    return dict;
}

} // End namespace Foam

// ************************************************************************* //
