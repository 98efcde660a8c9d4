# SPDX-License-Identifier: LGPL-2.1-or-later
"""The compiled module under a name whose types are known (_core.pyi)."""
from _swept import *  # noqa: F401, F403
from _swept import __version__  # noqa: F401
