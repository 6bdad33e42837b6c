#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""Runs harmonicPrismMesh from Python: a dictionary from a dict, the report as a
dict, a refusal as an exception. See README.md."""

import json
import os
import re
import subprocess

__all__ = ["MeshError", "execute", "export", "read_dictionary", "run",
           "write_dictionary"]

__version__ = "0.4.0"


class MeshError(RuntimeError):
    """A program has failed; the text is its message. A refusal of
    harmonicPrismMesh has the fields of refused.json as attributes: code,
    exitStatus, stage, patch, entry, file, line, place, remedy, message. A
    field that is not known is None."""

    FIELDS = ("code", "exitStatus", "stage", "patch", "entry", "file", "line",
              "place", "remedy", "message")

    def __init__(self, text, fields=None):
        super().__init__(text)
        for name in self.FIELDS:
            setattr(self, name, (fields or {}).get(name))


# A word that needs no quotes, and the tokens of a dictionary
_WORD = re.compile(r"[A-Za-z_][\w.:+-]*$")
_TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"|[{}();]'
                    r'|[^\s{}();"]+', re.DOTALL)


def _quoted(text):
    if _WORD.match(text):
        return text
    return '"%s"' % text.replace("\\", "\\\\").replace('"', '\\"')


def _value(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, dict):
        return "{ %s }" % " ".join(_entries(value))
    if isinstance(value, (list, tuple)):
        return "(%s)" % " ".join(map(_value, value))
    return _quoted(os.fspath(value))


def _entries(entries, indent=""):
    """Lines of a dictionary"""
    for key, value in entries.items():
        name = indent + '"%s"' % key if not _WORD.match(key) else indent + key
        if isinstance(value, dict):
            yield name
            yield indent + "{"
            yield from _entries(value, indent + "    ")
            yield indent + "}"
        else:
            yield "%s %s;" % (name, _value(value))


def write_dictionary(path, entries):
    """Writes an OpenFOAM dictionary of nested dicts, lists, numbers, texts."""
    header = {"version": 2.0, "format": "ascii", "class": "dictionary",
              "object": os.path.basename(os.fspath(path))}
    with open(path, "w") as file:
        for line in _entries({"FoamFile": header, **entries}):
            file.write(line + "\n")


def _token(text):
    if text.startswith('"'):
        return re.sub(r"\\(.)", r"\1", text[1:-1])
    if text in ("true", "false"):
        return text == "true"
    for number in (int, float):
        try:
            return number(text)
        except ValueError:
            pass
    return text


def _list(tokens):
    """Values up to the closing parenthesis; the size before a list is left
    out"""
    values = []
    for text in tokens:
        if text == ")":
            break
        if text == "(":
            if values and isinstance(values[-1], int):
                values.pop()
            values.append(_list(tokens))
        else:
            values.append(_token(text))
    return values


def _dictionary(tokens):
    entries = {}
    words = []
    for text in tokens:
        if text == "}":
            break
        if text == "{":
            entries[words.pop()] = _dictionary(tokens)
        elif text == ";":
            if words:
                key, values = words[0], words[1:]
                entries[key] = values[0] if len(values) == 1 else values
                words = []
        elif text == "(":
            if len(words) > 1 and isinstance(words[-1], int):
                words.pop()
            words.append(_list(tokens))
        else:
            # The name of an entry is never a number
            words.append(_token(text) if words else text.strip('"'))
    return entries


def read_dictionary(path):
    """Returns an OpenFOAM dictionary as a dict. Numbers, true and false have
    their types. A list is a list; so are several values of an entry."""
    with open(path, errors="replace") as file:
        text = file.read()
    tokens = (m.group() for m in _TOKEN.finditer(text)
              if not m.group().startswith(("//", "/*")))
    entries = _dictionary(tokens)
    entries.pop("FoamFile", None)
    return entries


def _message(log):
    """The error in a log of OpenFOAM, or the last lines"""
    log = re.sub(r"^\[\d+\] ?", "", log, flags=re.MULTILINE)
    found = re.search(r"--> FOAM FATAL (?:IO )?ERROR:[^\n]*\n(.*?)\n\s*"
                      r"(?:From function|FOAM exiting|$)", log, re.DOTALL)
    if found:
        return found.group(1).strip()
    return "\n".join(log.strip().splitlines()[-5:])


def execute(case, program, *options):
    """Runs a program of OpenFOAM in a case. Its log is in log.<program>.
    Raises MeshError with the message of the program if it fails."""
    path = os.path.join(case, "log." + program)
    try:
        with open(path, "w") as file:
            status = subprocess.call([program, *map(os.fspath, options)],
                                     cwd=case, stdin=subprocess.DEVNULL,
                                     stdout=file, stderr=subprocess.STDOUT)
    except FileNotFoundError as error:
        raise MeshError(
            "%s: %s; source etc/bashrc of harmonicPrismMesh before Python"
            % (error.filename, error.strerror)) from error
    if status:
        with open(path, errors="replace") as file:
            raise MeshError("%s: %s" % (program, _message(file.read())))


def run(case, entries=None, *options):
    """Runs harmonicPrismMesh in a case and returns report.json as a dict.
    Raises MeshError with the fields of a refusal.
    entries: those of system/harmonicPrismMeshDict; None if it is there"""
    if entries is not None:
        write_dictionary(
            os.path.join(case, "system", "harmonicPrismMeshDict"), entries)
    folder = os.path.join(case, "postProcessing", "harmonicPrismMesh")
    if "-region" in options:
        region = options[options.index("-region") + 1]
        folder = os.path.join(folder, region)
    refused = os.path.join(folder, "refused.json")
    if os.path.exists(refused):
        os.remove(refused)
    try:
        execute(case, "harmonicPrismMesh", *options)
    except MeshError as error:
        if not os.path.exists(refused):
            raise
        raise MeshError(str(error), _json(refused)) from None
    return _json(os.path.join(folder, "report.json"))


def _json(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def export(case, file, *options):
    """Writes the mesh of a case for another program: harmonicPrismExport."""
    execute(case, "harmonicPrismExport", file, *options)
