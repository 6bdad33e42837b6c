#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""Tests of the page of a case: cube.obj, of side 1, is in
constant/triSurface. The environment of the programs must be in force."""

import html.parser
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import harmonicPrismMesh as hpm
import harmonicPrismReport as page
from harmonicPrismReport import pictures, polyMesh, sections, surfaces

ENTRIES = {"surface": {"file": "cube.obj"},
           "layers": {"nSurfaceLayers": 3, "thickness": 0.1,
                      "expansionRatio": 1.2}}
BOX = {"type": "tet", "boundary": {"type": "box", "min": (-2, -2, -2),
                                   "max": (2, 2, 2)}}
HEIGHTS = (("firstHeightOverRequest", "firstHeightOverRequest"),
           ("thicknessOverRequest", "totalThicknessOverRequest"))


def heights(wall):
    return {name: np.sort(wall.values[name]) for name, _ in HEIGHTS}


class Case(unittest.TestCase):
    """A copy of the case for each test"""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.case = os.path.join(folder.name, "cube")
        for name in ("constant/triSurface", "system"):
            shutil.copytree(name, os.path.join(self.case, name))

    def run_mesher(self, entries=ENTRIES, *options):
        return hpm.run(self.case, entries, *options)

    def wall_of_mesh(self, report):
        return surfaces.wall_of_mesh(polyMesh.read_mesh(self.case, ""), report)

    def written_as(self, **entries):
        path = os.path.join(self.case, "system", "controlDict")
        hpm.write_dictionary(path, {**hpm.read_dictionary(path), **entries})


class Mesh(Case):

    def agrees_with_the_report(self, report):
        wall = self.wall_of_mesh(report)
        self.assertEqual(len(wall), report["allPatches"]["faces"])
        # The report has six digits
        self.assertAlmostEqual(wall.areas.sum(), 6, 5)
        for name, key in HEIGHTS:
            self.assertAlmostEqual(wall.values[name].min(),
                                   report["allPatches"][key]["min"], 5)
            self.assertAlmostEqual(wall.values[name].mean(),
                                   report["allPatches"][key]["mean"], 5)

    def test_in_ascii_has_the_heights_of_the_report(self):
        self.written_as(writeFormat="ascii", writePrecision=12)
        self.agrees_with_the_report(self.run_mesher())

    def test_in_binary_has_the_heights_of_the_report(self):
        self.written_as(writeFormat="binary")
        self.agrees_with_the_report(
            self.run_mesher({**ENTRIES, "farField": BOX}))

    def test_compressed_has_the_heights_of_the_report(self):
        self.written_as(writeFormat="ascii", writePrecision=12,
                        writeCompression="on")
        self.agrees_with_the_report(self.run_mesher())

    def test_in_pieces_has_the_heights_of_the_report(self):
        path = os.path.join(self.case, "system", "decomposeParDict")
        hpm.write_dictionary(path, {
            "numberOfSubdomains": 2, "method": "hierarchical",
            "hierarchicalCoeffs": {"n": (2, 1, 1), "delta": 0.001,
                                   "order": "xyz"}})
        hpm.write_dictionary(os.path.join(
            self.case, "system", "harmonicPrismMeshDict"), ENTRIES)
        os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1",
                          OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
        hpm.execute(self.case, "mpirun", "-np", "2", "--oversubscribe",
                    "--bind-to", "none", shutil.which("harmonicPrismMesh"),
                    "-parallel")
        self.agrees_with_the_report(
            page.read_report(os.path.join(self.case, page.FOLDER)))

    def test_has_the_heights_of_the_file_of_the_wall(self):
        report = self.run_mesher(ENTRIES, "-writeFields")
        wall = surfaces.wall_of_file(
            os.path.join(self.case, page.FOLDER, "wall.vtk"), report)
        mesh = self.wall_of_mesh(report)
        for name, _ in HEIGHTS:
            np.testing.assert_allclose(heights(wall)[name],
                                       heights(mesh)[name], atol=1e-5)
        # Both have normals into the fluid, away from the cube's centre
        for one in (wall, mesh):
            away = one.centres - np.ptp(one.points, axis=0)/2 \
                - one.points.min(axis=0)
            self.assertTrue((np.einsum("ij,ij->i", one.unit, away)
                             > 0.49).all())

    def test_a_cut_fills_the_box_but_for_the_cube(self):
        self.written_as(writeFormat="binary")
        # Merged tetrahedra need not be convex, and a cut is a fan of triangles
        self.run_mesher({**ENTRIES, "farField": {**BOX, "polyhedra": False}})
        cut = pictures.Cut(
            polyMesh.read_mesh(self.case, ""), (0.011, 0.013, 0.017),
            np.array((0.0, 0.0, 1.0)), np.array((0.0, 1.0, 0.0)), (3, 3))
        a, b, c = (cut.triangles[:, i] for i in range(3))
        areas = np.abs(np.cross(b - a, c - a))/2
        self.assertAlmostEqual(areas.sum(), 4*4 - 1, 6)


class Files(Case):

    def test_are_as_far_as_they_were_moved(self):
        report = self.run_mesher()
        wall = self.wall_of_mesh(report)
        files, missing = surfaces.given_files(self.case)
        self.assertEqual(missing, [])
        self.assertLess(surfaces.distances(wall, files).max(), 1e-6)
        moved = surfaces.Surface(files.points + (0.2, 0, 0), files.offsets,
                                 files.labels)
        self.assertAlmostEqual(surfaces.distances(wall, moved).max(), 0.2, 6)

    def test_have_the_scale_of_the_dictionary(self):
        hpm.write_dictionary(
            os.path.join(self.case, "system", "harmonicPrismMeshDict"),
            {"surface": {"file": "cube.obj", "scale": 0.001}})
        files, _ = surfaces.given_files(self.case)
        self.assertAlmostEqual(files.areas.sum(), 6e-6, 12)

    def test_that_cannot_be_read_are_named(self):
        hpm.write_dictionary(
            os.path.join(self.case, "system", "harmonicPrismMeshDict"),
            {"surface": {"files": ["cube.obj", "duct.step"]}})
        self.assertEqual(surfaces.given_files(self.case),
                         (None, ["duct.step"]))


class Parser(html.parser.HTMLParser):
    """Elements that are open, and attributes that lead elsewhere"""

    def __init__(self):
        super().__init__()
        self.open, self.links, self.pictures = [], [], 0

    def handle_starttag(self, tag, attributes):
        if tag not in ("meta", "br", "path", "rect", "stop", "image"):
            self.open.append(tag)
        for name, value in attributes:
            if name in ("href", "src"):
                inside = value.startswith("data:image/png;base64,")
                self.pictures += inside
                if not inside:
                    self.links.append(value)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if self.open[-1] == tag:
            self.open.pop()

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag


class Page(Case):

    def read(self):
        path = page.write_html(self.case)
        self.assertEqual(path, os.path.join(self.case, page.FOLDER,
                                            "report.html"))
        self.assertLess(os.path.getsize(path), 5e6)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        parser = Parser()
        parser.feed(text)
        self.assertEqual(parser.open, [])
        self.assertEqual(parser.links, [])
        return re.sub(r"base64,[^\"]*", "", text), parser.pictures

    def write_json(self, name, entries):
        folder = os.path.join(self.case, page.FOLDER)
        os.makedirs(folder, exist_ok=True)
        with open(os.path.join(folder, name), "w") as file:
            json.dump(entries, file)

    def test_has_all_sections_of_a_run(self):
        self.run_mesher({**ENTRIES, "farField": BOX}, "-writeFields")
        text, n_pictures = self.read()
        for title in ("Verdict", "On the wall", "Histograms",
                      "The wall over the files", "Slices",
                      "The ten worst places", "Patches", "Seconds"):
            self.assertIn("<h2>%s</h2>" % title, text)
        self.assertIn("all 3 on 100 % of the wall", text)
        # Three of the wall, two of a slice; no place misses the request
        self.assertEqual(n_pictures, 5)

    def test_has_pictures_of_places_that_miss_the_request(self):
        self.run_mesher({"surface": {"file": "cube.obj", "fluid": "inside"},
                         "layers": {**ENTRIES["layers"], "thickness": 0.6}},
                        "-writeFields")
        text, n_pictures = self.read()
        places = re.findall(r"<b>\d+</b> at \(", text)
        self.assertGreaterEqual(len(places), 1)
        self.assertIn("cause: ", text)
        self.assertEqual(n_pictures, 7 + len(places))

    def test_has_the_verdict_of_the_json(self):
        report = self.run_mesher()
        self.write_json("report.json", {**report, "verdict": {"thickness": {
            "grade": "poor", "text": "half of <b>", "place": [1, 2.5, 3],
            "remedy": "layers.thickness 0.05"}}})
        text, _ = self.read()
        self.assertIn('<b class="poor">poor</b>', text)
        self.assertIn("half of &lt;b&gt;<br>At (1 2.5 3)<br>To do: "
                      "layers.thickness 0.05", text)

    def test_of_a_refused_run_has_its_reason(self):
        refusal = {"status": "refused", "stage": "wallDefects",
                   "message": "the wall is open at (0 0 1)"}
        self.write_json("refused.json", refusal)
        text, n_pictures = self.read()
        self.assertIn("the wall is open at (0 0 1)", text)
        self.assertEqual(n_pictures, 0)

        # The mesh of an earlier run follows
        self.run_mesher()
        self.write_json("refused.json", refusal)
        text, n_pictures = self.read()
        self.assertIn("the wall is open at (0 0 1)", text)
        self.assertGreater(n_pictures, 0)

    def test_without_a_report_says_what_to_run(self):
        with self.assertRaisesRegex(hpm.MeshError, "run harmonicPrismMesh"):
            page.write_html(self.case)

    def test_without_vtk_says_how_to_get_it(self):
        script = ("import sys; sys.modules['vtk'] = None\n"
                  "import harmonicPrismReport; harmonicPrismReport.main()")
        result = subprocess.run(
            [sys.executable, "-c", script, self.case], stderr=subprocess.PIPE,
            universal_newlines=True)
        self.assertEqual(result.returncode, 1)
        self.assertIn("apt-get install python3-vtk9", result.stderr)
        self.assertNotIn("Traceback", result.stderr)


class Worst(unittest.TestCase):

    def test_are_the_furthest_from_the_request_and_apart(self):
        # A strip of squares of side 1
        n = 100
        x = np.arange(n + 1.0)
        points = np.concatenate([np.stack((x, 0*x + y, 0*x), axis=1)
                                 for y in (0, 1)])
        i = np.arange(n)
        wall = surfaces.Surface(
            points, 4*np.arange(n + 1),
            np.stack((i, i + 1, i + n + 2, i + n + 1), axis=1).ravel())
        over = np.ones(n)
        over[[20, 21, 60, 90]] = 0.1, 0.2, 0.5, 0.995
        wall.values = {"firstHeightOverRequest": np.ones(n),
                       "thicknessOverRequest": over}
        wall.request = np.full(n, 0.1)
        # Face 21 is beside a worse one, face 90 is within 1 %
        self.assertEqual(sections.worst_places(wall), [20, 60])


class Version(unittest.TestCase):

    def test_is_the_programs(self):
        version = subprocess.check_output(
            ["harmonicPrismMesh", "-version"], universal_newlines=True)
        self.assertTrue(version.startswith(
            "harmonicPrismMesh %s," % hpm.__version__), version)


if __name__ == "__main__":
    unittest.main()
