# SPDX-License-Identifier: LGPL-2.1-or-later
"""State of the result of an object with InputHash and TriedHash: current, stale or failed.

The state compares the hash of the present inputs with two stored hashes. InputHash: hash of the
inputs of the stored result. TriedHash: hash of the inputs of the last run without a result.
"""
from .. import contents, convert
from ..convert import InputProblem
from ..texts import translate
from .base import (
    CANCELLED,
    FAILED,
    NOT_COMPUTED,
    STALE,
    UP_TO_DATE,
    kind_of,
    quietly,
    set_changed,
)

#: Prefix of present hashes. Hashes of earlier versions have none.
VERSION = "2:"
#: Replaces the hash of the inputs if there is no stored result to compare with.
NOT_READ = "not read"
#: A function(obj, parts) that reads parts (apart.Apart) in the background and then lets an object
#: compare its inputs again. None: there is no window, and parts are read at once.
read_beside = None


def hash_or_problem(make):
    """Returns (hash, ""), or ("", why the inputs are unusable). make: returns the hash or raises
    InputProblem."""
    try:
        return make(), ""
    except (InputProblem, RuntimeError, AttributeError) as problem:
        return "", str(problem) or type(problem).__name__


def inputs_of(obj, words, make):
    """Returns (hash, problem, False) for judge(). Returns (.., .., True) if large parts must be
    read first; the object then compares again later, and its result counts as stale until then.
    words: returns contents.words(). make: returns the hash. Both raise InputProblem."""
    found, problem = hash_or_problem(words)
    if problem or not obj.InputHash and not obj.TriedHash:
        return "" if problem else NOT_READ, problem, False
    unread = contents.unread(found)
    if read_beside is None or not contents.is_much(unread):
        return hash_or_problem(make) + (False,)
    if obj.Status == UP_TO_DATE:
        set_changed(obj, "Status", STALE)
        text = translate("SweptVolume", "Checking whether large parts have changed ...")
        set_changed(obj, "Message", text)
    read_beside(obj, unread)
    return "", "", True


def judge(obj, now, problem="", waiting=False, notes=""):
    """Writes Status and Message. now, problem: from hash_or_problem(); waiting: an input is itself
    stale; notes: text about the stored result. A failure stays visible until the inputs change."""
    tried = obj.Status in (FAILED, CANCELLED) and obj.TriedHash == now
    if problem:
        set_changed(obj, "TriedHash", "")
        set_changed(obj, "Status", FAILED if obj.InputHash or tried else NOT_COMPUTED)
        set_changed(obj, "Message", problem)
        return
    current = bool(obj.InputHash) and obj.InputHash == now
    if tried and not (current and obj.Status == CANCELLED):
        return
    if current:
        set_changed(obj, "Status", STALE if waiting else UP_TO_DATE)
    else:
        set_changed(obj, "Status", STALE if obj.InputHash else NOT_COMPUTED)
    set_changed(obj, "Message", notes)


def mark_failure(obj, now, text, tried, cancelled):
    """Stores that a run had no result. now: returns the hash of the object's inputs. tried: hash of
    the inputs of the run ("": the run did not read them). The run may have had other settings;
    then a current result stays current."""
    if obj.InputHash and tried and tried != obj.InputHash and obj.InputHash == now():
        return
    set_changed(obj, "TriedHash", tried)
    set_changed(obj, "Status", CANCELLED if cancelled else FAILED)
    set_changed(obj, "Message", text)


def is_behind(obj):
    """Returns whether an object of this workbench has a result that does not match its present
    inputs."""
    return kind_of(obj) != "" and getattr(obj, "Status", "") in (STALE, FAILED, CANCELLED)


def compare_again(obj):
    """Makes an object of this workbench compare its inputs with its result, outside a recompute of
    the document."""
    with quietly(obj):
        obj.Proxy.refresh_status(obj)


def update_users(obj):
    """Makes the objects of this workbench that use `obj` compare their inputs again. Needed if
    `obj` was changed outside a recompute of the document, or if the recompute stops at it."""
    seen, waiting = [obj], [obj]
    while waiting:
        for user in waiting.pop().InList:
            if kind_of(user) and user not in seen:
                seen.append(user)
                waiting.append(user)
                compare_again(user)


def renew(obj, before, now):
    """Replaces stored hashes of version 1 by hashes in the present form if they match the present
    inputs. before, now: hashes of the inputs in both forms, or "" if the inputs are unusable."""
    for name in ("InputHash", "TriedHash"):
        known = getattr(obj, name)
        if known and not known.startswith(VERSION) and before and known == before:
            setattr(obj, name, now)


# --- placement of a result in the world


def outer_inverse(obj):
    """Returns the transformation from the world to the frame of an object's Placement."""
    try:
        return obj.Placement.multiply(obj.getGlobalPlacement().inverse())
    except AttributeError:
        return obj.Placement.__class__()


def remember_place(obj):
    """Stores the placement of the result."""
    set_place = convert.global_placement(*convert.root_path(obj))
    if not same_place(obj.Placed, set_place):
        obj.Placed = set_place


def is_displaced(obj):
    """Returns whether the result was moved since it was stored, by itself or with a group around
    it."""
    here = convert.global_placement(*convert.root_path(obj))
    return bool(obj.InputHash) and not same_place(obj.Placed, here)


def same_place(a, b):
    """Returns whether two placements are equal up to rounding. (== of placements fails after saving
    and loading.)"""
    return abs(convert.matrix_of(a) - convert.matrix_of(b)).max() <= 1e-9
