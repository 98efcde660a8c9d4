# SPDX-License-Identifier: LGPL-2.1-or-later
"""View providers: icons with the state, context menus, the drawn path. Imported only with a GUI.

Documents store the names of these modules and classes, so the names must never change.
"""
