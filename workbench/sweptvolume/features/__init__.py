# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects: Motion, Envelope, Solid. Never imports the GUI.

Module and class names are stored in documents: keep them for ever.
"""
