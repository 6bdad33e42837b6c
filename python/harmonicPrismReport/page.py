#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""Pieces of a page: texts, tables, figures, histograms."""

import base64
import html
import math
import zlib

import numpy as np


STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; color: #222; max-width: 1140px;
    margin: 0 auto; padding: 0 16px 40px }
h1 { font-size: 25px; margin: 24px 0 4px }
h2 { font-size: 20px; margin: 34px 0 6px; border-bottom: 2px solid #3b528b }
h3 { font-size: 16px; margin: 20px 0 4px }
p { margin: 6px 0; max-width: 95ch }
svg { max-width: 100%; height: auto; display: block }
figure { margin: 8px 0; break-inside: avoid }
figcaption, .note { color: #555; font-size: 13px }
table { border-collapse: collapse; margin: 8px 0; width: 100% }
th, td { padding: 3px 8px; text-align: right; vertical-align: top;
    border-bottom: 1px solid #ddd; font-variant-numeric: tabular-nums }
th { background: #f0f2f6; font-weight: 600 }
.text { text-align: left; overflow-wrap: break-word }
.patches { font-size: 13px } .patches .text { min-width: 13em }
.good, .poor, .useless { color: #fff; border-radius: 3px; padding: 0 7px }
.good { background: #1b7837 } .poor { background: #b35806 }
.useless { background: #a50026 }
.row { display: flex; flex-wrap: wrap; gap: 12px }
.row figure { flex: 1 1 48% }
.places { display: grid; grid-template-columns: 1fr 1fr; gap: 10px 24px }
.places > div { break-inside: avoid; border-top: 1px solid #ddd;
    padding-top: 6px; display: flex; gap: 12px }
.places svg { flex: none }
.key span { display: inline-block; margin-right: 16px }
.key i { display: inline-block; width: 12px; height: 12px; margin-right: 5px;
    border: 1px solid #999 }
@media print { body { font-size: 11px; max-width: none }
    * { print-color-adjust: exact; -webkit-print-color-adjust: exact } }
"""


def text(value):
    return html.escape(str(value))


def length(x):
    """A length that reads well"""
    for unit, size in (("m", 1), ("mm", 1e-3), ("µm", 1e-6), ("nm", 1e-9)):
        if abs(x) >= 0.9995*size:
            return "%.3g %s" % (x/size, unit)
    return "0 m" if x == 0 else "%.1e m" % x


def place(point):
    size = max(abs(x) for x in point)
    return "(%s)" % " ".join("%.5g" % (x if abs(x) > 1e-9*size else 0)
                             for x in point)


def percent(x):
    """100 is only what is all"""
    return "100" if x == 100 else "%.1f" % min(x, 99.9)


def figure(png, width, height, size, marks=()):
    """A picture with a scale; size: of a pixel [m]; marks: squares, as x, y and
    half of the width [pixels]"""
    digit = 10**math.floor(math.log10(width*size/5))
    bar = max(k*digit for k in (1, 2, 5) if k*digit <= width*size/5)
    squares = "".join(
        '<rect x="%.1f" y="%.1f" width="%.1f" height="%.1f" fill="none" '
        'stroke="#d00" stroke-width="2"/>' % (x - r, y - r, 2*r, 2*r)
        for x, y, r in ((x, y, max(r, 7)) for x, y, r in marks))
    return (
        '<svg viewBox="0 0 {w} {h}" width="{w}" height="{h}">'
        '<image width="{w}" height="{h}" href="data:image/png;base64,{png}"/>'
        '{squares}<rect x="0" y="{box}" width="{width}" height="34" '
        'fill="#fff" fill-opacity="0.85"/><path d="M8 {line}h{bar:.1f}" '
        'stroke="#000" stroke-width="4"/><text x="8" y="{base}" '
        'font-size="13">{label}</text></svg>'.format(
            w=width, h=height, png=base64.b64encode(png).decode(),
            squares=squares, box=height - 34,
            width=max(bar/size, 7*len(length(bar))) + 16,
            line=height - 7, bar=bar/size, base=height - 14,
            label=length(bar)))


def colour_bar(title, labels, colours):
    """labels: at even distances, from low to high"""
    width, n = 420, len(labels) - 1
    stops = "".join('<stop offset="%g" stop-color="%s"/>'
                    % (i/(len(colours) - 1), c) for i, c in enumerate(colours))
    name = "g%08x" % zlib.crc32((title + "".join(colours)).encode())
    ticks = "".join('<text x="%.0f" y="33" font-size="13" text-anchor="middle">'
                    '%s</text>' % (40 + i*width/n, text(label))
                    for i, label in enumerate(labels))
    return ('<svg viewBox="0 0 1120 38" width="1120" height="38"><defs>'
            '<linearGradient id="{0}">{1}</linearGradient></defs><rect x="40" '
            'y="4" width="{2}" height="14" fill="url(#{0})" stroke="#888"/>{3}'
            '<text x="{4}" y="16" font-size="14">{5}</text></svg>'.format(
                name, stops, width, ticks, width + 70, text(title)))


def histogram(title, values, weights, low, high, labels):
    """Shares of the area [%], by an axis of powers of ten; values beyond low
    and high are in the outer bars"""
    n, width, height, left = 44, 530, 190, 46
    ok = np.isfinite(values)
    bars = np.histogram(np.clip(values[ok], low, high), n, (low, high),
                        weights=weights[ok])[0]
    bars *= 100/max(bars.sum(), 1e-300)
    floor, base = 0.01, height - 24

    def y(share):
        return base - (base - 26)*math.log10(max(share, floor)/floor)/4

    lines = "".join(
        '<path d="M{0} {1:.1f}H{2}" stroke="#ddd"/><text x="{3}" y="{4:.1f}" '
        'font-size="11" text-anchor="end">{5:g}&#8201;%</text>'.format(
            left, y(s), width, left - 4, y(s) + 4, s)
        for s in (0.01, 0.1, 1, 10, 100))
    step = (width - left)/n
    boxes = "".join(
        '<rect x="%.1f" y="%.1f" width="%.1f" height="%.1f" fill="#3b528b"/>'
        % (left + i*step, y(s), step - 1, base - y(s))
        for i, s in enumerate(bars) if s > floor)
    ticks = "".join(
        '<text x="%.0f" y="%d" font-size="11" text-anchor="%s">%s</text>'
        % (left + i*(width - left)/(len(labels) - 1), height - 9,
           ("start", "middle", "end")[(i > 0) + (i == len(labels) - 1)],
           text(label)) for i, label in enumerate(labels))
    return ('<figure><svg viewBox="0 0 {0} {1}" width="{0}" height="{1}">'
            '<text x="{2}" y="14" font-size="13" font-weight="600">{3}</text>'
            '{4}{5}{6}</svg></figure>'.format(width, height, left, text(title),
                                              lines, boxes, ticks))


def table(header, rows, texts=(0,), kind=""):
    """header: may be empty; texts: columns of text, to the left"""
    def line(cells, tag):
        return "<tr>%s</tr>" % "".join(
            "<%s%s>%s</%s>" % (tag, ' class="text"' * (i in texts), cell, tag)
            for i, cell in enumerate(cells))
    return '<table class="%s">%s%s</table>' % (
        kind, line(header, "th") if header else "", "".join(
            line(row, "td") for row in rows))
