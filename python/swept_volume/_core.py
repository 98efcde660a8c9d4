# SPDX-License-Identifier: LGPL-2.1-or-later
"""The compiled module _swept, under the name for which _core.pyi describes the types."""
from _swept import *  # noqa: F401, F403
from _swept import __version__  # noqa: F401
