#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""checkOutcome.py <colour> <line>...: what CfdOF's panel says of the run in the
current folder has these lines of that colour, as regular expressions."""

import re
import sys

from CfdOF.Mesh import CfdHarmonicPrismMesh

lines = CfdHarmonicPrismMesh.outcome(".")
for wanted in sys.argv[2:]:
    if not any(colour == sys.argv[1] and re.fullmatch(wanted, line)
               for line, colour in lines):
        sys.exit("no '%s' in %s" % (wanted, lines))
