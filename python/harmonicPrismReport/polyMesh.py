#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""The mesh in constant/polyMesh: ascii or binary, compressed or not."""

import glob
import gzip
import os
import re

import numpy as np


def file_bytes(path):
    """What is in a file, or in its .gz; None if there is neither"""
    if os.path.exists(path):
        with open(path, "rb") as file:
            return file.read()
    if os.path.exists(path + ".gz"):
        with gzip.open(path + ".gz") as file:
            return file.read()
    return None


def _lists(data, kinds):
    """The lists of numbers in a file of OpenFOAM, one for each kind, 'label' or
    'scalar', as flat arrays; in ascii also with parentheses within the list"""
    header = re.search(rb"FoamFile\s*\{.*?\}", data, re.DOTALL)
    binary = b"binary" in re.search(rb"format\s+(\w+)", header.group()).group(1)
    sizes = dict(re.findall(rb"(label|scalar)=(\d+)", header.group()))
    at, found = header.end(), []
    for kind in kinds:
        start = re.compile(rb"(?:^|[\n>])\s*(\d+)\s*([({])").search(data, at)
        count = int(start.group(1))
        kind = kind.split("*")
        number = "<%s%d" % ("i" if kind[0] == "label" else "f",
                            int(sizes.get(kind[0].encode(),
                                b"32" if kind[0] == "label" else b"64"))//8)
        if start.group(2) == b"{":
            value = data[start.end():data.index(b"}", start.end())]
            found.append(np.full(count, float(value)).astype(number))
            at = start.end()
        elif binary:
            n = count*int(kind[1] if len(kind) > 1 else 1)
            found.append(np.frombuffer(data, number, n, start.end()))
            at = start.end() + found[-1].nbytes
        else:
            end = re.compile(rb"\)\s*(?:;|//|$|\n[^\d\s(-])").search(
                data, start.end()).start()
            found.append(_numbers(data[start.end():end], number))
            at = end
    return found


def _numbers(text, number):
    text = text.replace(b"(", b" ").replace(b")", b" ")
    return np.fromstring(text, sep=" ").astype(number)


def _faces(data):
    """Offsets and labels of the points of faces"""
    if b"faceCompactList" in data[:2000] and b"binary" in data[:2000]:
        return _lists(data, ("label", "label"))

    # The size of each face stands before its parenthesis
    start = re.compile(rb"\n\d+\s*\(").search(data)
    end = data.rindex(b")")
    text = data[start.end():end].replace(b"(", b" -1 ").replace(b")", b" ")
    values = np.fromstring(text, dtype=np.int64, sep=" ")
    marks = np.flatnonzero(values == -1)
    offsets = np.concatenate(([0], np.cumsum(values[marks - 1])))
    labels = np.delete(values, np.concatenate((marks, marks - 1)))
    return offsets, labels


def _patches(data):
    """Name, type, number of faces and first face of the patches"""
    text = data.decode(errors="replace")
    text = text[re.search(r"FoamFile\s*\{.*?\}", text, re.DOTALL).end():]
    patches = []
    for name, body in re.findall(r"([^\s{}()]+)\s*\{([^{}]*)\}", text):
        entry = dict(re.findall(r"(\w+)\s+([^;]*);", body))
        patches.append((name.strip('"'), entry["type"],
                        int(entry["nFaces"]), int(entry["startFace"])))
    return patches


def _layer_zone(data, n_cells):
    """Which cells are in the zone boundaryLayer; None without that zone"""
    place = data and re.search(rb"\nboundaryLayer\s*\{", data)
    if not place:
        return None
    header = re.search(rb"FoamFile\s*\{.*?\}", data, re.DOTALL).group()
    labels, = _lists(header + data[place.end():], ("label",))
    inside = np.zeros(n_cells, bool)
    inside[labels] = True
    return inside


def ragged(offsets, rows):
    """Positions of all entries of rows, and for each the index of its row in
    rows"""
    sizes = offsets[rows + 1] - offsets[rows]
    row = np.repeat(np.arange(len(rows)), sizes)
    first = np.cumsum(sizes) - sizes
    return offsets[rows][row] + np.arange(len(row)) - first[row], row


class Mesh:
    """A polyMesh, or the pieces of one in processor folders, one after the
    other. layer_cells: which cells are in layers, None if all are"""

    def __init__(self, folders):
        pieces = [self._read(folder) for folder in folders]
        n_points = np.cumsum([0] + [len(p["points"]) for p in pieces])
        n_cells = np.cumsum([0] + [p["n_cells"] for p in pieces])
        n_faces = np.cumsum([0] + [len(p["owner"]) for p in pieces])
        n_labels = np.cumsum([0] + [len(p["labels"]) for p in pieces])

        def joined(name, shifts):
            return np.concatenate([p[name] + s for p, s in zip(pieces, shifts)])

        self.points = np.concatenate([p["points"] for p in pieces])
        self.labels = joined("labels", n_points)
        self.offsets = np.concatenate(
            [[0]] + [p["offsets"][1:] + s for p, s in zip(pieces, n_labels)])
        self.owner = joined("owner", n_cells)
        self.neighbour = np.concatenate(
            [np.where(p["neighbour"] < 0, -1, p["neighbour"] + s)
             for p, s in zip(pieces, n_cells)])
        self.n_cells = n_cells[-1]
        self.patches = {}
        for piece, shift in zip(pieces, n_faces):
            for name, kind, n, start in piece["patches"]:
                faces = np.arange(start, start + n) + shift
                old = self.patches.get(name, (kind, faces[:0]))[1]
                self.patches[name] = (kind, np.concatenate((old, faces)))
        zones = [p["layers"] for p in pieces]
        self.layer_cells = None if any(z is None for z in zones) \
            else np.concatenate(zones)
        self.sizes = np.diff(self.offsets)

    @staticmethod
    def _read(folder):
        data = {name: file_bytes(os.path.join(folder, name)) for name in
                ("points", "faces", "owner", "neighbour", "boundary",
                 "cellZones")}
        offsets, labels = _faces(data["faces"])
        owner, = _lists(data["owner"], ("label",))
        inner, = _lists(data["neighbour"], ("label",))
        neighbour = np.full(len(owner), -1, np.int64)
        neighbour[:len(inner)] = inner
        n_cells = int(max(owner.max(), neighbour.max())) + 1
        points, = _lists(data["points"], ("scalar*3",))
        return {"points": points.reshape(-1, 3).astype(float),
                "offsets": offsets.astype(np.int64),
                "labels": labels.astype(np.int64),
                "owner": owner.astype(np.int64), "neighbour": neighbour,
                "n_cells": n_cells, "patches": _patches(data["boundary"]),
                "layers": _layer_zone(data["cellZones"], n_cells)}

    def faces_of(self, name):
        return self.patches.get(name, ("", np.zeros(0, np.int64)))[1]

    def boundary(self):
        """Points, offsets and labels of the faces of all patches but the outer
        surface of the layers"""
        faces = np.concatenate([f for name, (_, f) in self.patches.items()
                                if name != "layerOuter"])
        at, _ = ragged(self.offsets, faces)
        offsets = np.concatenate(([0], np.cumsum(self.sizes[faces])))
        return self.points, offsets, self.labels[at]

    def across(self):
        """The direction across a mesh of two dimensions, or None"""
        normals = [self.polygons(faces[:1])[1][0]
                   for kind, faces in self.patches.values()
                   if kind in ("empty", "wedge") and len(faces)]
        if not normals:
            return None
        normals = [n/np.linalg.norm(n) for n in normals]
        normal = normals[0] - (normals[1] if len(normals) > 1 else 0)
        return normal/np.linalg.norm(normal)

    def stacks(self, faces, n_layers):
        """First height, total height [m] and number of layers on faces of the
        wall, and which cells are in these layers. The height of a cell is
        2 V/(A0 + A1), as in the report."""
        pairs = np.concatenate((self.owner, self.neighbour))
        order = np.argsort(pairs, kind="stable")
        starts = np.searchsorted(pairs[order], np.arange(self.n_cells + 1))
        order %= len(self.owner)

        first, total = np.full(len(faces), np.nan), np.zeros(len(faces))
        reached = np.zeros(len(faces), int)
        cells = np.zeros(self.n_cells, bool)
        which, face = np.arange(len(faces)), faces.copy()
        cell = self.owner[face]
        while len(which):
            if self.layer_cells is not None:
                keep = self.layer_cells[cell]
                which, face, cell = which[keep], face[keep], cell[keep]
            top = self._opposite(face, cell, order, starts)
            keep = top >= 0
            which, face, cell, top = (
                a[keep] for a in (which, face, cell, top))
            height = 2*self._volumes(cell, order, starts)/(
                self._areas(face) + self._areas(top))
            cells[cell] = True
            new = reached[which] == 0
            first[which[new]] = height[new]
            total[which] += height
            reached[which] += 1
            other = np.where(self.owner[top] == cell, self.neighbour[top],
                             self.owner[top])
            keep = (other >= 0) & (reached[which] < n_layers[which])
            which, face, cell = which[keep], top[keep], other[keep]
        return first, total, reached, cells

    def polygons(self, faces):
        """Centres and area vectors of faces"""
        at, _ = ragged(self.offsets, faces)
        offsets = np.concatenate(([0], np.cumsum(self.sizes[faces])))
        return areas_of(self.points, offsets, self.labels[at])

    def _areas(self, faces):
        return np.linalg.norm(self.polygons(faces)[1], axis=1)

    def _volumes(self, cells, order, starts):
        at, row = ragged(starts, cells)
        centres, normals = self.polygons(order[at])
        flux = np.einsum("ij,ij->i", centres, normals)/3
        sign = np.where(self.owner[order[at]] == cells[row], 1, -1)
        return np.bincount(row, sign*flux, len(cells))

    def _opposite(self, face, cell, order, starts):
        """Of each cell the one face that shares no point with the given face;
        -1 if there is none, or if there are several"""
        at, row = ragged(starts, cell)
        candidate = order[at]
        n = len(self.points)
        own, own_row = ragged(self.offsets, face)
        keys = own_row*n + self.labels[own]
        points, pair = ragged(self.offsets, candidate)
        shared = np.isin(row[pair]*n + self.labels[points], keys)
        apart = np.bincount(pair, shared, len(candidate)) == 0
        found = np.full(len(face), -1)
        found[row[apart]] = candidate[apart]
        found[np.bincount(row[apart], minlength=len(face)) != 1] = -1
        return found


def areas_of(points, offsets, labels):
    """Centres, which are means of points, and area vectors of polygons"""
    sizes = np.diff(offsets)
    row = np.repeat(np.arange(len(sizes)), sizes)
    following = np.arange(len(labels)) + 1
    following[offsets[1:] - 1] = offsets[:-1]
    p = points[labels]
    centres = np.stack([np.bincount(row, p[:, k], len(sizes))/sizes
                        for k in range(3)], axis=1)
    p = p - centres[row]
    parts = np.cross(p, p[following])/2
    return centres, np.stack([np.bincount(row, parts[:, k], len(sizes))
                              for k in range(3)], axis=1)


def read_mesh(case, region):
    """The mesh of a case, or of a region; None if there is none"""
    inner = os.path.join("constant", region, "polyMesh")
    folders = [os.path.join(case, inner)]
    if not glob.glob(os.path.join(folders[0], "faces*")):
        folders = sorted(
            glob.glob(os.path.join(case, "processor[0-9]*", inner)))
    return Mesh(folders) if folders else None
