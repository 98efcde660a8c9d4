# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts about the result of a search for a path."""
from .. import quantities
from ..core_texts import said
from ..texts import translate

#: Number of neighbours that are named. Further neighbours stop only few moves.
MOST_NAMES = 3


def _names(names):
    more = " ..." if len(names) > MOST_NAMES else ""
    return ", ".join('"{}"'.format(name) for name in names[:MOST_NAMES]) + more


def result_text(report):
    """Returns the text about a report of a search (docs/paths.md)."""
    lines = _found(report) if report["verdict"] == "found" else _not_found(report)
    lines += [said(w["code"], w["text"]) for w in report["warnings"]]
    return "\n".join(lines)


def _found(report):
    lines = [
        translate(
            "SweptVolume",
            "Found a path: {0} keys, length {1}, total turn {2} degrees, clearance "
            "at least {3}.",
        ).format(
            report["keys"],
            quantities.quantity(report["length"]),
            quantities.number(report["turn_degrees"]),
            quantities.quantity(report["clearance"]),
        )
    ]
    if report["contacts"]:
        text = translate(
            "SweptVolume",
            "Within the release distance of {0}, the part is allowed to come closer than "
            "required to: {1}.",
        ).format(quantities.quantity(report["release"]), _names(report["contacts"]))
        lines.append(text)
    return lines


def _not_found(report):
    escape = report["escape"]
    if report["verdict"] == "no_translation":
        lines = [
            translate("SweptVolume", "It is proven that no path exists without turning the part.")
        ]
    elif report["budget_ended"]:
        lines = [translate("SweptVolume", "No path was found within the time limit.")]
    else:
        lines = [translate("SweptVolume", "No path was found.")]
    text = translate(
        "SweptVolume",
        "The search moved the part at most {0} away from its goal before the part was blocked. "
        "The 3D view shows the part at that place.",
    )
    lines.append(text.format(quantities.quantity(escape["distance"])))
    if escape["blockers"]:
        text = translate("SweptVolume", "Most frequent obstacle: {0}.")
        lines.append(text.format(_names(escape["blockers"])))
    possible = report.get("possible_clearance", -1)
    if possible > 0:
        text = translate(
            "SweptVolume",
            "A path exists with a clearance of {0}: reduce the required distance to find it.",
        )
        lines.append(text.format(quantities.quantity(possible)))
    elif possible == 0:
        lines.append(
            translate(
                "SweptVolume",
                "A path exists only with a clearance near 0: reduce the required distance to find it.",
            )
        )
    return lines


def improved(report):
    """Returns the text about a motion that was improved."""
    if report["verdict"] != "found":
        lines = [
            translate(
                "SweptVolume",
                "No section of the motion keeps the required distance: reduce the "
                "required distance, or use Find path.",
            )
        ]
    else:
        text = translate(
            "SweptVolume",
            "{0} keys instead of {1}, length {2} instead of {3}, clearance {4} " "instead of {5}.",
        )
        before = report["before"]
        lines = [
            text.format(
                report["keys"],
                before["keys"],
                quantities.quantity(report["length"]),
                quantities.quantity(before["length"]),
                quantities.quantity(report["clearance"]),
                quantities.quantity(before["clearance"]),
            )
        ]
        released = report["kept_moves"] - report["unmended_moves"]
        if report["unmended_moves"]:
            text = translate(
                "SweptVolume",
                "Number of sections of the path on which the distance stays below the required "
                "distance, because no other path was found: {0}.",
            )
            lines.append(text.format(report["unmended_moves"]))
        if released:
            text = translate(
                "SweptVolume",
                "Number of sections of the path within the release distance of start and goal, "
                "which were left unchanged: {0}.",
            )
            lines.append(text.format(released))
    lines += [said(w["code"], w["text"]) for w in report["warnings"]]
    return "\n".join(lines)
