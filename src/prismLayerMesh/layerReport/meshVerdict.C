/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshVerdict.H"
#include "ranges.H"
#include "refusal.H"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- What the causes mean to a user, in the order of squeezeCause
static const char* const causeTexts[nSqueezeCauses] =
{
    "",
    "the opposite wall is too near",
    "columns at sharp corners may not be longer (layers.maxStretch)",
    "it is in the transition to smaller heights",
    "the level sets of the field are nearer",
    "it is beside a place with less room",
    "the wall has concave corners",
    "the wall has acute corners",
    "the wall's faces are too uneven for taller cells",
    "the outer surface would cut itself or the wall",
    "taller cells would be beyond the bounds of quality"
};


//- A number with so many digits
static std::string text(const scalar value, const int digits = 3)
{
    std::ostringstream os;
    os.precision(digits);
    os  << value;

    return os.str();
}


//- The commonest cause of squeezed points. Points that follow neighbours count
//  only if there are no others.
static squeezeCause commonestCause(const patchReport& patch)
{
    FixedList<label, nSqueezeCauses> n(patch.points);
    n[int(squeezeCause::none)] = 0;
    label& nFollowing = n[int(squeezeCause::neighbour)];
    nFollowing = min(nFollowing, label(1));

    return squeezeCause(std::max_element(n.begin(), n.end()) - n.begin());
}


//- The patch with most of the area that a share [%] leaves out
static const patchReport& worstPatch
(
    const layerReport& report,
    scalar patchReport::* share
)
{
    const patchReport* worst = &report.wall;
    scalar most = -1;
    for (const patchReport& patch : report.patches)
    {
        const scalar missing = patch.area*(100 - patch.*share);
        worst = missing > most ? &patch : worst;
        most = max(most, missing);
    }

    return *worst;
}


//- " on the patch <name>" if there are several patches
static std::string onPatch(const layerReport& report, const patchReport& patch)
{
    return report.patches.size() > 1 ? " on the patch " + patch.name : "";
}


static bool isUniform(const MinMax<scalar>& range)
{
    return range.max() <= 1.01*range.min();
}


//- The entry for a patch
static std::string entryOf(const layerReport& report, const patchReport& patch)
{
    return
        report.patches.size() > 1
      ? "layers.patches." + patch.name + '.' : std::string("layers.");
}


//- The share of the room that layers should fill
static constexpr scalar roomShare = 0.9;


//- Entries with which the layers of a patch would fit into the room that half
//  of the patch's area has
static std::string fittingEntries
(
    const layerReport& report,
    const patchReport& patch
)
{
    const layerRequest& asked = patch.request;
    const std::string entry(entryOf(report, patch));
    const scalar room =
        roomShare*patch.thicknessMedian*asked.thickness.max();
    const bool isOne = isUniform(asked.firstThickness)
        && isUniform(asked.ratio) && isUniform(asked.thickness);
    if (!isOne)
    {
        return "a smaller " + entry + "thickness or nSurfaceLayers";
    }

    const scalar first = asked.firstThickness.max();
    label n = patch.layersAsked;
    while (n > 0 && totalThickness(n, first, asked.ratio.max()) > room)
    {
        --n;
    }
    std::string entries;
    if (n > 0)
    {
        entries =
            entry + "nSurfaceLayers " + std::to_string(n)
          + " with this first height";
    }
    if (room >= patch.layersAsked*first || n == 0)
    {
        entries +=
            (n > 0 ? ", or " : "") + entry + "thickness " + text(room, 2);
    }

    return entries;
}


//- One thing to do about a cause
static std::string remedyOf
(
    const layerReport& report,
    const patchReport& patch,
    const squeezeCause cause
)
{
    switch (cause)
    {
        case squeezeCause::none:
            return "";
        case squeezeCause::levelSet:
            return "layers.marchingDistances requested";
        case squeezeCause::quality:
            return "quality.priority thickness";
        case squeezeCause::stretch:
            return "a larger layers.maxStretch";
        default:
            return fittingEntries(report, patch);
    }
}


static std::string causeText(const squeezeCause cause)
{
    return
        cause == squeezeCause::none
      ? std::string() : std::string("; mostly because ")
      + causeTexts[int(cause)];
}


static verdictLine layersLine(const layerReport& report)
{
    verdictLine line;
    line.name = "layers";
    line.text =
        "all " + std::to_string(report.wall.layersReached) + " on "
      + text(report.wall.fullLayersArea) + " % of the wall's area";

    return line;
}


//- The line on a height over its request.
//  share: of the area that has the request [%]
//  percent: within which the area has the request
static verdictLine heightLine
(
    const layerReport& report,
    const word& name,
    scalar patchReport::* share,
    const scalar median,
    const int percent
)
{
    static constexpr scalar most = 50;
    static constexpr scalar all = 99.95;

    verdictLine line;
    line.name = name;
    const scalar area = report.wall.*share;
    line.text =
        "as asked, within " + std::to_string(percent) + " %, on "
      + text(area) + " % of the wall's area";
    if (area < all)
    {
        line.text += "; median " + text(median) + " of the request";
    }
    if (area < most)
    {
        const patchReport& patch = worstPatch(report, share);
        const squeezeCause cause = commonestCause(patch);
        line.grade = verdictLine::grades::poor;
        line.text += causeText(cause) + onPatch(report, patch);
        line.remedy = remedyOf(report, patch, cause);
    }

    return line;
}


static verdictLine firstHeightLine(const layerReport& report)
{
    const scalar median = report.wall.firstHeightMedian;
    verdictLine line
    (
        heightLine
        (
            report, "firstHeight", &patchReport::firstHeightArea, median, 1
        )
    );
    line.place = report.worstFirstHeight;
    if (median*maxHeightFactor < 1 || median > maxHeightFactor)
    {
        line.grade = verdictLine::grades::useless;
    }

    return line;
}


static verdictLine thicknessLine(const layerReport& report)
{
    const patchReport& patch =
        worstPatch(report, &patchReport::thicknessArea);
    verdictLine line
    (
        heightLine
        (
            report, "thickness", &patchReport::thicknessArea,
            report.wall.thicknessMedian, 5
        )
    );
    line.place = report.worstThickness;
    const MinMax<scalar>& asked = patch.request.thickness;
    const bool isLess = patch.thicknessMedian < 0.95;
    if (line.grade != verdictLine::grades::good && isLess && isUniform(asked))
    {
        line.text +=
            "; room is " + text(patch.thicknessMedian*asked.max(), 2) + " m, "
          + text(asked.max(), 2) + " m asked";
    }

    return line;
}


//- The line on heights that vanish beside others in their stack
static verdictLine growthLine(const layerReport& report)
{
    const patchReport& patch =
        worstPatch(report, &patchReport::thicknessArea);
    verdictLine line;
    line.name = "growth";
    line.grade =
        report.wall.vanishingArea > maxVanishing
      ? verdictLine::grades::useless : verdictLine::grades::poor;
    line.text =
        "heights vanish beside the next cell's (factor 1000) on "
      + text(report.wall.vanishingArea) + " % of the wall's area"
      + onPatch(report, patch);
    line.place = report.worstGrowth;
    line.remedy = remedyOf(report, patch, commonestCause(patch));

    return line;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool meshVerdict::isUseless() const
{
    return anyOf(lines, [](const verdictLine& line)
    {
        return line.grade == verdictLine::grades::useless;
    });
}


label meshVerdict::nPoor() const
{
    return countOf(lines, [](const verdictLine& line)
    {
        return line.grade != verdictLine::grades::good;
    });
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

word name(const verdictLine::grades grade)
{
    static const char* const names[] = {"good", "poor", "useless"};

    return names[int(grade)];
}


List<verdictLine> verdictOnLayers(const layerReport& layers)
{
    DynamicList<verdictLine> lines;
    lines.append(layersLine(layers));
    lines.append(firstHeightLine(layers));
    lines.append(thicknessLine(layers));
    if (layers.wall.vanishingArea > 0)
    {
        lines.append(growthLine(layers));
    }

    return List<verdictLine>(std::move(lines));
}


verdictLine verdictOnWall(const wallAccount& account)
{
    const areaAccount& all = account.all;
    const scalar whole = all.area();
    const auto share = [&](const scalar area)
    {
        return text(whole > 0 ? 100*area/whole : 0);
    };

    verdictLine line;
    line.name = "wall";
    const bool isComplete = all.area(areaFate::lost) <= 0;
    line.text =
        (isComplete ? "complete: of the files' " : "of the files' ")
      + text(whole) + " m2 " + share(all.area(areaFate::kept))
      + " % are in the wall";
    const auto add = [&](const scalar area, const char* where)
    {
        if (area > 0)
        {
            line.text += ", " + share(area) + " % " + where;
        }
    };
    add(all.area(areaFate::beyond), "were cut off by sides or lie in sides");
    add(all.area(areaFate::apart), "are not beside surface.inside");
    add
    (
        all.area(areaFate::contact) + all.area(areaFate::inside),
        "are where bodies overlap or touch"
    );
    add(all.area(areaFate::lost), "are LOST");
    if (all.nLost)
    {
        line.grade = verdictLine::grades::poor;
        line.place = all.place;
        line.remedy =
            "a smaller stitchCoeffs.gap, wrapCoeffs.size or remesh.deviation in"
            " surface; the report has surface.account by patch";
    }

    return line;
}


verdictLine verdictOnQuality
(
    const layerReport* layers,
    const farFieldReport* far
)
{
    faceQualityCounts faces;
    if (layers)
    {
        faces += layers->faces;
    }
    if (far)
    {
        faces += far->transition;
        faces += far->farField;
    }

    verdictLine line;
    line.name = "quality";
    line.text = std::to_string(faces.nBeyondAny)
      + " faces between cells are beyond the bounds of quality; largest"
        " non-orthogonality " + text(faces.maxNonOrtho) + " degrees";
    if (faces.nOfWall)
    {
        line.text += "; " + std::to_string(faces.nOfWall)
          + " because of the wall's own faces";
    }
    if (100.0*faces.nBeyondAny > maxBeyond*faces.nFaces)
    {
        line.grade = verdictLine::grades::poor;
        line.place = faces.firstPlace;
        line.remedy =
            2*faces.nOfWall > faces.nBeyondAny
          ? "surface { remesh { } } for better triangles"
          : "smaller edges in surface.remesh, or thinner layers";
    }

    return line;
}


verdictLine verdictOnSolver
(
    const layerReport* layers,
    const farFieldReport* far
)
{
    verdictLine line;
    line.name = "solver";
    if (layers && layers->heightJumps.size())
    {
        line.grade = verdictLine::grades::poor;
        line.place = layers->heightJumps[0];
        line.text =
            "it may diverge where first heights jump from face to face by up"
            " to " + text(layers->firstHeightChange.max) + ", at "
          + std::to_string(layers->heightJumps.size()) + " edges of the wall";
        line.remedy =
            "limited corrected 0.33 for laplacianSchemes and snGradSchemes in"
            " system/fvSchemes; if it diverges, a smaller first height there"
            " by layers.regions";
    }
    else if (far)
    {
        line.text = textOf(far->grade);
        line.place = far->grade.place;
        if (far->grade.factor >= 0.9)
        {
            line.grade = verdictLine::grades::poor;
            line.remedy =
                "limited corrected 0.5 for laplacianSchemes and snGradSchemes"
                " in system/fvSchemes";
        }
    }

    return line;
}


meshVerdict makeVerdict
(
    const layerReport* layers,
    const farFieldReport* far,
    const UList<verdictLine>& wall
)
{
    meshVerdict verdict;
    if (layers)
    {
        verdict.lines.append(verdictOnLayers(*layers));
    }
    verdict.lines.append(wall);
    verdict.lines.append(verdictOnQuality(layers, far));
    if (far || (layers && layers->heightJumps.size()))
    {
        verdict.lines.append(verdictOnSolver(layers, far));
    }

    return verdict;
}


// * * * * * * * * * * * * * *  Verdict IO * * * * * * * * * * * * * * * * * //

//- What follows the text of a line that is not good
static std::string placeAndRemedy(const verdictLine& line)
{
    std::string more;
    if (line.grade != verdictLine::grades::good)
    {
        const point& x = line.place;
        more =
            ". Worst at (" + text(x.x(), 6) + ' ' + text(x.y(), 6) + ' '
          + text(x.z(), 6) + ")";
        more += line.remedy.empty() ? "" : ". Write " + line.remedy;
    }

    return more;
}


//- "firstHeight" as "First height"
static std::string headingOf(const word& name)
{
    std::string heading;
    for (const char c : name)
    {
        heading += std::isupper(c) ? ' ' + std::string(1, std::tolower(c))
          : std::string(1, c);
    }
    heading[0] = std::toupper(heading[0]);

    return heading;
}


dictionary toDictionary(const meshVerdict& verdict)
{
    dictionary dict;
    for (const verdictLine& line : verdict.lines)
    {
        dictionary entries;
        entries.add("grade", name(line.grade));
        entries.add("text", line.text);
        if (line.grade != verdictLine::grades::good)
        {
            entries.add("place", line.place);
            entries.add("remedy", line.remedy);
        }
        dict.add(line.name, entries);
    }

    return dict;
}


void write(Ostream& os, const meshVerdict& verdict)
{
    std::ostringstream text;
    const label nPoor = verdict.nPoor();
    text<< "Verdict: the mesh is written, ";
    if (nPoor)
    {
        text<< nPoor << (nPoor > 1 ? " lines are" : " line is") << " poor\n";
    }
    else
    {
        text<< "no line is poor\n";
    }
    for (const verdictLine& line : verdict.lines)
    {
        text<< "    " << std::left << std::setw(14) << headingOf(line.name);
        if (line.grade != verdictLine::grades::good)
        {
            text<< (line.grade == verdictLine::grades::poor
              ? "POOR: " : "USELESS: ");
        }
        text<< line.text << placeAndRemedy(line) << '\n';
    }
    os  << text.str().c_str();
}


void requireUsable(const layerReport& layers)
{
    for (const verdictLine& line : verdictOnLayers(layers))
    {
        if (line.grade == verdictLine::grades::useless)
        {
            refusal what;
            what.code = refusal::codes::noRoom;
            what.message =
                "The layers are useless. " + headingOf(line.name) + ": "
              + line.text + placeAndRemedy(line)
              + "\nTo get this mesh all the same: allowPoorHeights yes in"
                " layers";
            what.place = pointField(1, line.place);
            what.remedy = line.remedy;
            throw refusalError(what);
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
