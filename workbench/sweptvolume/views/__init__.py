# SPDX-License-Identifier: LGPL-2.1-or-later
"""View providers: icons with the state, context menus, the drawn path. Imported only with a GUI.

Module and class names are stored in documents: keep them for ever.
"""
