# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects: Motion, Envelope, Solid and others. Never imports the GUI.

Documents store the names of these modules and classes, so the names must never change.
"""
