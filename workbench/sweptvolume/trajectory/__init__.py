# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motions as plain values and where they come from. No GUI, no document objects made here."""
