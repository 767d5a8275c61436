# SPDX-License-Identifier: GPL-3.0-or-later
"""Fill and bridge with few edges at every vertex."""

from . import operators


def register():
    operators.register()


def unregister():
    operators.unregister()
