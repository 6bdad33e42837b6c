#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""The sections of the page."""

import json
import math
import os

import numpy as np

from . import FOLDER, page, pictures
from .polyMesh import read_mesh
from .surfaces import (Surface, distances, given_files, wall_of_file,
                       wall_of_mesh, wall_patches)

# Causes of squeezed columns, as wall.vtk counts them, with their colours
CAUSES = (("none", "#dddddd"), ("gap", "#0072b2"), ("stretch", "#56b4e9"),
          ("transition", "#009e73"), ("levelSet", "#999933"),
          ("neighbour", "#f0e442"), ("concaveCorner", "#e69f00"),
          ("visibility", "#cc79a7"), ("validity", "#d55e00"),
          ("intersection", "#882255"), ("quality", "#332288"))

VERDICTS = {"layers": "Layers", "firstHeight": "First height",
            "thickness": "Thickness", "growth": "Growth", "wall": "The wall",
            "solver": "Solver"}


def verdict_section(report):
    """The verdict of report.json, or the numbers of the report"""
    if report.get("verdict"):
        rows = []
        for name, line in report["verdict"].items():
            more = ""
            if line.get("place"):
                more += "<br>At " + page.place(line["place"])
            if line.get("remedy"):
                more += "<br>To do: " + page.text(line["remedy"])
            grade = page.text(line["grade"])
            rows.append(('<b class="%s">%s</b>' % (grade, grade),
                         page.text(VERDICTS.get(name, name)),
                         page.text(line["text"]) + more))
        return page.table((), rows, (0, 1, 2))

    rows = []
    certificate, walls = report["certificate"], report["allPatches"]
    rows.append(("Certificate", "%s, %s cells in layers" % (
        "valid: no layer is missing, every cell is positive, nothing intersects"
        if certificate["valid"] else "<b>NOT valid</b>",
        "{:,}".format(certificate.get("layerCells", certificate["cells"])))))
    rows.append(("Layers", "%s of %s, all of them on %s&nbsp;%% of the area" % (
        walls["layersReached"], walls["layersAsked"],
        page.percent(walls["fullLayersAreaPercent"]))))
    for name, key in (("First height", "firstHeightOverRequest"),
                      ("Thickness", "totalThicknessOverRequest")):
        p = walls[key]
        rows.append((name, "over the request: median %.3f, 98&nbsp;%% of the "
                     "faces within %.3f and %.3f, smallest %.3f"
                     % (p["p50"], p["p1"], p["p99"], p["min"])))
    if report.get("firstHeightJumps"):
        rows.append(("Jumps", "<b>First heights jump by more than 3 from face "
                     "to face at %d edges</b>" % report["firstHeightJumps"]))
    return page.table((), rows, (0, 1))


def refusal_section(refusal):
    """What a run that was refused has written: refused.json"""
    rows = [(page.text(key), page.text(json.dumps(value, ensure_ascii=False)
                               if isinstance(value, (dict, list)) else value))
            for key, value in refusal.items()
            if key not in ("schemaVersion", "version", "status")]
    return ('<h2>The last run was refused</h2><p>It has changed nothing. What '
            'follows, if anything, is of the run before.</p>'
            + page.table((), rows, (0, 1)))


def wall_section(wall, report, thin):
    """Thickness, first heights and causes on the wall, in colours"""
    if wall.causes is None and any(
            b["min"] < b["max"] for p in report["patches"].values()
            for b in p["request"].values()):
        yield ('<p class="note">Requests vary on a patch: here values are over '
               'the largest request of the patch. harmonicPrismMesh '
               '-writeFields writes the request of each point.</p>')
    over = wall.values["thicknessOverRequest"]
    first = np.log2(np.maximum(wall.values["firstHeightOverRequest"], 1e-30))
    for title, values, low, colours, labels in (
            ("Thickness over the request", over, 0, pictures.VIRIDIS,
             ("0", "0.25", "0.5", "0.75", "≥ 1")),
            ("First height over the request", first, -1, pictures.DIVERGING,
             ("≤ 0.5", "0.71", "1", "1.41", "≥ 2"))):
        yield "<h3>%s</h3>" % title
        yield pictures.body_picture(
            wall, pictures.colours_of(values, low, 1, colours), thin)
        yield page.colour_bar(title.lower() + ", by face", labels, colours)
    counts = report["allPatches"].get("squeezedPoints", {})
    key = "".join(
        '<span><i style="background:%s"></i>%s%s</span>'
        % (colour, "full thickness" if name == "none" else name,
           ": {:,} points".format(counts[name]) if name in counts else "")
        for name, colour in CAUSES if name == "none" or counts.get(name))
    yield "<h3>Causes of squeezed columns</h3>"
    if wall.causes is not None:
        cause = np.maximum.reduceat(wall.causes[wall.labels],
                                    wall.offsets[:-1])
        colours = np.array([pictures.rgb(c) for _, c in CAUSES], np.uint8)
        yield pictures.body_picture(wall, colours[cause], thin)
    else:
        yield ('<p class="note">harmonicPrismMesh -writeFields shows them on '
               'the wall.</p>')
    yield '<p class="key">%s</p>' % key


def histogram_section(wall):
    for name, key in (("First height over request", "firstHeightOverRequest"),
                      ("Thickness over request", "thicknessOverRequest")):
        yield page.histogram(name, wall.values[key], wall.areas, 0, 2,
                         ("0", "0.5", "1", "1.5", "≥ 2"))
    heights = np.log10(np.maximum(wall.values["firstHeight"], 1e-30))
    low = math.floor(np.nanmin(heights))
    high = max(math.ceil(np.nanmax(heights)), low + 1)
    yield page.histogram("First height", heights, wall.areas, low, high,
                     [page.length(10.0**e) for e in range(low, high + 1)])
    changes = wall.values.get("firstHeightChange")
    if changes is not None:
        yield page.histogram(
            "Largest change of the first height to a neighbour", changes,
            wall.areas, 1, 3, ("1", "1.5", "2", "2.5", "≥ 3"))


def files_section(case, wall, mesh):
    """The wall over the files, and the files over the mesh's boundary"""
    files, missing = given_files(case)
    if files is None:
        yield ('<p class="note">The wall is not compared with the files here: '
               '%s.</p>' % page.text(
                   "VTK does not read " + ", ".join(missing) if missing
                   else "the dictionary names no file"))
        return
    compared = [("The wall, by its distance from the files", wall,
                 files)]
    if mesh is not None:
        compared.append(("The files, by their distance from the boundary of "
                         "the mesh", files,
                         Surface(*mesh.boundary())))
    found = [(title, surface, distances(surface, other))
             for title, surface, other in compared]
    size = max(wall.diagonal(), files.diagonal())
    if max(d.max() for _, _, d in found) < 1e-6*size:
        yield "<p>The wall is on the files%s: distances are below %s.</p>" % (
            ", and the files are on the boundary of the mesh"
            if len(found) > 1 else "", page.length(1e-6*size))
        return
    scale = max([1e-2*size] + [_share(d, s.areas, 0.98) for _, s, d in found])
    for title, surface, distance in found:
        yield from _distance_picture(title, surface, distance, scale,
                                     surface is files)
    yield page.colour_bar("distance, by face", [
        page.length(scale*k/4) for k in range(4)] + [
            "≥ " + page.length(scale)], pictures.NEAR_TO_FAR)
    yield ('<p class="note">A face of a file may rightly be far from the mesh: '
           'inside another body, beyond a side plane, or left out on '
           'purpose.</p>')


def _distance_picture(title, surface, distance, scale, both_sides):
    far, areas = int(np.argmax(distance)), surface.areas
    yield "<h3>%s</h3>" % title
    yield pictures.body_picture(
        surface, pictures.colours_of(distance, 0, scale, pictures.NEAR_TO_FAR),
        both_sides=both_sides)
    yield ("<p>At most %s, at %s; mean %s. More than %s on %.2f&nbsp;%% of the "
           "area.</p>" % (
               page.length(distance[far]), page.place(surface.centres[far]),
               page.length(np.dot(distance, areas)/areas.sum()),
               page.length(scale),
               100*areas[distance > scale].sum()/areas.sum()))


def _share(values, weights, share):
    """The value below which are this share of the weights"""
    order = np.argsort(values)
    sums = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(sums, share*sums[-1])])


def _badness(wall):
    """How far faces are from the request: a factor's logarithm"""
    first = np.abs(np.log(np.maximum(wall.values["firstHeightOverRequest"],
                                     1e-30)))
    thickness = -np.log(np.maximum(wall.values["thicknessOverRequest"], 1e-30))
    return np.nan_to_num(np.maximum(first, thickness), nan=1e3)


def worst_places(wall, n=10):
    """Faces that are furthest from the request, away from each other"""
    bad, found = _badness(wall), []
    far = np.ones(len(wall), bool)
    for _ in range(n):
        face = int(np.argmax(np.where(far, bad, -1)))
        if not far[face] or bad[face] < 0.01:
            break
        found.append(face)
        away = np.linalg.norm(wall.centres - wall.centres[face], axis=1)
        far &= away > max(0.02*wall.diagonal(), 2*wall.request[face])
    return found


def _axis(i):
    return np.eye(3)[i]


def _up(normal):
    up = _axis(2) if abs(normal[2]) < 0.9 else _axis(1)
    up = up - np.dot(up, normal)*normal
    return up/np.linalg.norm(up)


def _plane_at(wall, face, thin):
    """The normal of a plane through a face that shows its layers: across the
    sharpest edge nearby, and up in it, the normal of the wall"""
    if thin is not None:
        return thin, _up(thin)
    normal = wall.unit[face]
    near = np.linalg.norm(wall.centres - wall.centres[face], axis=1) \
        < 2*max(wall.request[face], math.sqrt(wall.areas[face]))
    others = np.cross(normal, wall.unit[near])
    sines = np.linalg.norm(others, axis=1)
    across = others[np.argmax(sines)]/sines.max() if sines.max() > 0.1 else \
        np.cross(normal, _axis(int(np.argmin(np.abs(normal)))))
    across = across/np.linalg.norm(across)
    return across, np.cross(across, np.cross(normal, across))


def _sharpest(wall, point, normal):
    """Where the wall turns most in a plane: place, and direction away from
    the wall; None if the plane meets no edge"""
    following = np.arange(len(wall.labels)) + 1
    following[wall.offsets[1:] - 1] = wall.offsets[:-1]
    edges = np.sort(np.stack((wall.labels, wall.labels[following]), axis=1),
                    axis=1)
    owner = np.repeat(np.arange(len(wall)), np.diff(wall.offsets))
    order = np.lexsort((edges[:, 1], edges[:, 0]))
    edges, owner = edges[order], owner[order]
    same = np.flatnonzero((edges[1:] == edges[:-1]).all(axis=1))
    a, b = owner[same], owner[same + 1]
    side = (wall.points[edges[same]] - point) @ normal
    turn = np.where(side[:, 0]*side[:, 1] < 0,
                    np.einsum("ij,ij->i", wall.unit[a], wall.unit[b]), 2)
    if not len(turn) or turn.min() > 1:
        return None
    k = int(np.argmin(turn))
    t = side[k, 0]/(side[k, 0] - side[k, 1])
    p, q = wall.points[edges[same[k]]]
    return p + t*(q - p), wall.unit[a[k]] + wall.unit[b[k]], \
        float(wall.request[a[k]]), math.degrees(math.acos(
            max(-1, min(1, turn[k]))))


def _wall_faces(mesh, report):
    return np.concatenate([np.zeros(0, np.int64)] + [
        mesh.faces_of(name) for name in wall_patches(mesh, report)])


def slices_section(wall, mesh, report, thin, worst):
    """Two slices, each as a whole and near to the layers"""
    low, high = wall.points.min(axis=0), wall.points.max(axis=0)
    normal = thin if thin is not None else _axis(int(np.argmin(high - low)))
    # Beside planes of symmetry, which may have edges of the mesh in them
    middle = (low + high)/2 + \
        (0.013*(high - low) if thin is None else 0)*normal
    corner = _sharpest(wall, middle, normal)
    if corner:
        at, away, request, angle = corner
        yield from _slice(
            wall, mesh, report, normal, _up(normal), at, request,
            at + 0.4*request*away/max(np.linalg.norm(away), 1e-9),
            "where the wall turns most in this plane, by %.0f degrees" % angle)
    if worst:
        at, request = wall.centres[worst[0]], float(wall.request[worst[0]])
        across, _ = _plane_at(wall, worst[0], thin)
        yield from _slice(
            wall, mesh, report, across, _up(across), at, request,
            at + 0.5*request*wall.unit[worst[0]],
            "where the layers are furthest from the request")


def _slice(wall, mesh, report, across, up, at, request, centre, title):
    """The plane through a place: all of the wall, and what is around the
    centre in a window that is as high as 2.4 layers"""
    size, zoom = (550, 400), 1.2*request
    right = np.cross(up, across)
    shown = wall.crossed(at, across) - centre
    local = np.stack((shown @ right, shown @ up))
    middle = (local.min(axis=1) + local.max(axis=1))/2
    extent = np.ptp(local, axis=1)/2
    half = 1.1*max(extent[1], extent[0]*size[1]/size[0]) + request
    faces = _wall_faces(mesh, report)
    for half, point, marks, caption in (
            (half, centre + middle[0]*right + middle[1]*up, [(-middle, zoom)],
             "The wall in a plane through %s, normal %s"
             % (page.place(at), page.place(across))),
            (zoom, centre, (), "The square, " + title)):
        cut = pictures.Cut(mesh, point, across, up,
                           (half*size[0]/size[1], half))
        yield "<figure>%s<figcaption>%s</figcaption></figure>" % (
            cut.picture(mesh, faces, size, request, marks), caption)


def worst_section(wall, mesh, report, thin, worst):
    """Coordinates, numbers and a small picture of each of the worst places"""
    if not worst:
        yield ("<p>First height and thickness of every face are within "
               "1&nbsp;% of the request.</p>")
        return
    names = mesh and _patch_names(mesh, report, wall.centres[worst])
    size = (250, 180)
    yield '<div class="places">'
    for i, face in enumerate(worst):
        request, picture = float(wall.request[face]), ""
        if mesh:
            half = 1.3*request
            picture = pictures.Cut(
                mesh, wall.centres[face] + 0.6*request*wall.unit[face],
                *_plane_at(wall, face, thin), (half*size[0]/size[1], half)
            ).picture(mesh, _wall_faces(mesh, report), size, request)
        lines = ["<b>%d</b> at %s" % (i + 1, page.place(wall.centres[face]))]
        if names:
            lines.append("patch " + page.text(names[i]))
        first = wall.values["firstHeightOverRequest"][face]
        lines += ["first height <b>%.3f</b> of %s" % (
            first, page.length(wall.values["firstHeight"][face]/first)),
                  "thickness <b>%.3f</b> of %s" % (
                      wall.values["thicknessOverRequest"][face],
                      page.length(request))]
        if wall.causes is not None:
            causes = wall.causes[
                wall.labels[wall.offsets[face]:wall.offsets[face + 1]]]
            if causes.max():
                lines.append("cause: " + ", ".join(
                    sorted({CAUSES[c][0] for c in causes if c})))
        yield "<div>%s<p>%s</p></div>" % (picture, "<br>".join(lines))
    yield "</div>"


def _patch_names(mesh, report, places):
    """The patch of the face that is nearest to each place"""
    names = list(wall_patches(mesh, report))
    if not names:
        return None
    away = np.stack([np.linalg.norm(
        mesh.polygons(mesh.faces_of(n))[0][:, None] - places, axis=2
    ).min(axis=0) for n in names])
    return [names[i] for i in np.argmin(away, axis=0)]


def _range(bounds):
    low, high = page.length(bounds["min"]), page.length(bounds["max"])
    return low if low == high else "%s to %s" % (low, high)


def patches_section(report):
    rows = []
    for name, p in [*report["patches"].items(),
                    ("all", report["allPatches"])]:
        first = p.get("firstHeightOverRequest", {})
        total = p.get("totalThicknessOverRequest", {})
        request = p["request"]
        rows.append([page.text(name), "{:,}".format(p["faces"]),
                     "%.4g" % p["area"],
                     "%s/%s" % (p["layersReached"], p["layersAsked"]),
                     *(_range(request[k])
                       for k in ("firstLayerThickness", "thickness")),
                     page.percent(p["fullLayersAreaPercent"]),
                     page.percent(p["fullThicknessAreaPercent"])]
                    + ["%.3f" % q[k] if k in q else ""
                       for q in (first, total) for k in ("p1", "p50", "p99")])
    yield page.table((
        "patch", "faces", "area [m²]", "layers", "first height asked",
        "thickness asked", "all layers, % of area", "full, % of area",
        "first height 1&nbsp;%", "50&nbsp;%", "99&nbsp;%", "thickness 1&nbsp;%",
        "50&nbsp;%", "99&nbsp;%"), rows, kind="patches")
    yield ('<p class="note">The last six columns are percentiles over the '
           'faces, over the request.</p>')


def stages_section(report):
    stages = {name: s for name, s in report.get("stages", {}).items()
              if isinstance(s, dict) and "seconds" in s}
    total = sum(s["seconds"] for s in stages.values())
    yield page.table(("stage", "seconds", "share", "peak memory [MB]"), [
        (page.text(name), "%.2f" % s["seconds"],
         "%.0f&nbsp;%%" % (100*s["seconds"]/total if total else 0),
         "%.0f" % s["peakMemoryMB"] if "peakMemoryMB" in s else "")
        for name, s in sorted(stages.items(),
                              key=lambda item: -item[1]["seconds"])
        if s["seconds"] >= 0.005*total] + [("all", "%.2f" % total, "", "")])


def of_region(case, region, report):
    """The sections of one report"""
    yield "<h2>Verdict</h2>"
    yield verdict_section(report)

    mesh = read_mesh(case, region)
    thin = mesh and mesh.across()
    wall = mesh and wall_of_mesh(mesh, report)
    with_causes = wall_of_file(
        os.path.join(case, FOLDER, region, "wall.vtk"), report)
    if with_causes is not None:
        wall = with_causes
    if wall is not None:
        worst = worst_places(wall)
        yield "<h2>On the wall</h2>"
        yield from wall_section(wall, report, thin)
        yield ('<h2>Histograms</h2><p class="note">Shares of the area of the '
               'wall. The axis upwards is in powers of ten.</p>'
               '<div class="row">')
        yield from histogram_section(wall)
        yield "</div><h2>The wall over the files</h2>"
        if thin is None:
            # A region has a part of the files
            yield from files_section(case, wall, None if region else mesh)
        else:
            yield '<p class="note">Not in two dimensions.</p>'
        if mesh is not None:
            yield ('<h2>Slices</h2><p class="note">Layers are blue, the wall '
                   'is black.</p><div class="row">')
            yield from slices_section(wall, mesh, report, thin, worst)
            yield "</div>"
        yield "<h2>The ten worst places</h2>"
        yield from worst_section(wall, mesh, report, thin, worst)
    else:
        yield "<p>No wall with layers in %s, and no wall.vtk.</p>" \
            % page.text(os.path.join("constant", region, "polyMesh"))
    yield "<h2>Patches</h2>"
    yield from patches_section(report)
    if report.get("stages"):
        yield "<h2>Seconds</h2>"
        yield from stages_section(report)
