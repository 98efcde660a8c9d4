# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels and dialogs. Imported only with a GUI."""
