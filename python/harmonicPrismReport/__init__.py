#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""Makes report.html of a case that harmonicPrismMesh has meshed: one file with
pictures, for any browser. See README.md."""

import argparse
import json
import os
import sys
import time

import harmonicPrismMesh as hpm

__all__ = ["FOLDER", "main", "read_report", "write_html"]

FOLDER = os.path.join("postProcessing", "harmonicPrismMesh")


def read_json(path):
    """None if the file is not there"""
    if not os.path.exists(path):
        return None
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def read_report(folder):
    """report.json, or otherwise the dictionary report; None if there is
    neither"""
    report = read_json(os.path.join(folder, "report.json"))
    if report is not None:
        return report
    path = os.path.join(folder, "report")
    return hpm.read_dictionary(path) if os.path.exists(path) else None


def write_html(case=".", path=None):
    """Writes the report of a case as one file for a browser, and returns its
    path: postProcessing/harmonicPrismMesh/report.html unless it is given.
    Raises MeshError if there is no report, or no VTK."""
    try:
        from . import sections
        from .page import STYLE, text
        from .pictures import display
    except ImportError as error:
        raise hpm.MeshError(
            "%s: %s. VTK and NumPy make the pictures. On Debian: sudo apt-get "
            "install python3-vtk9 python3-numpy xvfb, and /usr/bin/python3 %s; "
            "elsewhere: pip install vtk numpy"
            % (sys.executable, error, sys.argv[0])) from error
    case = os.path.abspath(case)
    folder = os.path.join(case, FOLDER)
    reports = [(region, read_report(os.path.join(folder, region)),
                read_json(os.path.join(folder, region, "refused.json")))
               for region in [""] + sorted(
                   name for name in (os.listdir(folder)
                                     if os.path.isdir(folder) else ())
                   if os.path.isdir(os.path.join(folder, name)))]
    reports = [(region, report, refusal)
               for region, report, refusal in reports if report or refusal]
    if not reports:
        raise hpm.MeshError("no report in %s; run harmonicPrismMesh" % folder)

    name = text(os.path.basename(case))
    page = ['<!DOCTYPE html><html lang="en"><head><meta charset="utf-8">'
            '<title>Layers of %s</title><style>%s</style></head><body>'
            '<h1>Layers of %s</h1><p class="note">%s, '
            'harmonicPrismMesh %s, %s</p>'
            % (name, STYLE, name, text(case),
               text((reports[0][1] or reports[0][2]).get("version", "")),
               time.strftime("%Y-%m-%d %H:%M"))]
    with display():
        for region, report, refusal in reports:
            if region:
                page.append("<h1>Region %s</h1>" % text(region))
            if refusal:
                page.append(sections.refusal_section(refusal))
            if report:
                page.extend(sections.of_region(case, region, report))
    page.append("</body></html>\n")
    path = path or os.path.join(folder, "report.html")
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(page))
    return path


def main():
    parser = argparse.ArgumentParser(
        description="Writes the report of a case that harmonicPrismMesh has "
        "meshed as one file for a browser, with pictures.")
    parser.add_argument("case", nargs="?", default=".",
                        help="default: the current folder")
    parser.add_argument("-o", "--output", metavar="FILE", help="default: "
                        "postProcessing/harmonicPrismMesh/report.html")
    parser.add_argument("-version", action="version",
                        version="harmonicPrismMesh " + hpm.__version__)
    options = parser.parse_args()
    try:
        print(write_html(options.case, options.output))
    except hpm.MeshError as error:
        sys.exit("harmonicPrismReport: %s" % error)
