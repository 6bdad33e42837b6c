#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""Tests of the module, in a case: cube.obj of constant/triSurface, and
system/controlDict. The environment of the programs must be in force."""

import os
import tempfile
import unittest

import harmonicPrismMesh as hpm

ENTRIES = {"surface": {"file": "cube.obj"},
           "layers": {"nSurfaceLayers": 3, "thickness": 0.1,
                      "expansionRatio": 1.2}}


class Dictionary(unittest.TestCase):

    def write(self, entries):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = os.path.join(folder.name, "someDict")
        hpm.write_dictionary(path, entries)
        return path

    def test_is_read_as_it_was_written(self):
        entries = {"word": "outside", "text": 'two "words"', "on": True,
                   "n": 20, "h": 1e-4, "point": [0.5, -1, 2e300],
                   "nested": {"wing.*": {"sides": ["xMin", "y.*"]}, "none": {}},
                   "lists": [[1, 2], [3]]}
        self.assertEqual(hpm.read_dictionary(self.write(entries)), entries)

    def test_has_openfoams_header(self):
        with open(self.write({"a": (1, 2)})) as file:
            text = file.read()
        self.assertIn("class dictionary;", text)
        self.assertIn("object someDict;", text)
        self.assertIn("a (1 2);", text)

    def test_comments_and_sizes_of_lists_are_left_out(self):
        path = self.write({})
        with open(path, "a") as file:
            file.write("/* no { */ a 2(1 2); // b 3;\nc uniform 4;\n")
        self.assertEqual(hpm.read_dictionary(path),
                         {"a": [1, 2], "c": ["uniform", 4]})


class Run(unittest.TestCase):

    def test_returns_the_report(self):
        report = hpm.run(".", ENTRIES, "-overwrite")
        self.assertIs(report["certificate"]["valid"], True)
        self.assertEqual(report["allPatches"]["layersReached"], 3)
        self.assertEqual(report["status"], "ok")
        self.assertEqual(report["verdict"]["layers"]["grade"], "good")

    def test_the_report_of_a_region(self):
        report = hpm.run(".", ENTRIES, "-overwrite", "-region", "air")
        self.assertEqual(report["wall"]["faces"], 12 * 4**2)

    def test_exports_the_mesh(self):
        hpm.run(".", ENTRIES, "-overwrite")
        hpm.export(".", "cube.su2", "-overwrite")
        with open("cube.su2") as file:
            self.assertEqual(file.readline(), "NDIME= 3\n")

    def test_a_refusal_is_raised_with_its_message(self):
        entries = {**ENTRIES, "layers": {**ENTRIES["layers"],
                                         "expansionRatio": -1}}
        with self.assertRaisesRegex(hpm.MeshError, "expansionRatio") as caught:
            hpm.run(".", entries, "-overwrite")
        self.assertEqual(caught.exception.code, "dictionary")
        self.assertEqual(caught.exception.exitStatus, 2)
        self.assertEqual(caught.exception.entry, "layers.expansionRatio")
        self.assertIsNone(caught.exception.place)

    def test_a_refusal_of_a_surface_has_its_stage(self):
        entries = {**ENTRIES, "surface": {"file": "missing.obj"}}
        with self.assertRaises(hpm.MeshError) as caught:
            hpm.run(".", entries, "-overwrite")
        self.assertEqual(caught.exception.code, "surface")
        self.assertEqual(caught.exception.stage, "wallSurface")

    def test_a_program_that_is_missing_is_named(self):
        with self.assertRaisesRegex(hpm.MeshError, "noSuchProgram.*bashrc"):
            hpm.execute(".", "noSuchProgram")


if __name__ == "__main__":
    unittest.main()
