# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motions as plain values, and their sources. No GUI; creates no document objects."""
