# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an object with InputHash and TriedHash says about its result: current, stale, failed.

It says what a fresh computation would justify. InputHash: of the inputs of the stored result; TriedHash:
of those of the last run that gave nothing.
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

#: Before the hashes of today; those of before have none.
VERSION = "2:"
#: In place of a hash that nothing stored could be compared with.
NOT_READ = "not read"
#: Reads parts (apart.Apart) beside the window and lets an object look again then: function(obj, parts). None:
#: there is no window, they are read at once.
read_beside = None


def hash_or_problem(make):
    """(hash, ""), or ("", why the inputs are unusable). make: gives the hash or raises InputProblem."""
    try:
        return make(), ""
    except (InputProblem, RuntimeError, AttributeError) as problem:
        return "", str(problem) or type(problem).__name__


def inputs_of(obj, words, make):
    """(hash, problem, False) as judge() takes them; (.., .., True): the parts are read first, and the object
    looks again then, with a result that counts as stale until it is known to be current. words: gives
    contents.words(); make: gives the hash; both raise InputProblem."""
    found, problem = hash_or_problem(words)
    if problem or not obj.InputHash and not obj.TriedHash:
        return "" if problem else NOT_READ, problem, False
    unread = contents.unread(found)
    if read_beside is None or not contents.is_much(unread):
        return hash_or_problem(make) + (False,)
    if obj.Status == UP_TO_DATE:
        set_changed(obj, "Status", STALE)
        text = translate("Messages", "Checking whether large parts have changed ...")
        set_changed(obj, "Message", text)
    read_beside(obj, unread)
    return "", "", True


def judge(obj, now, problem="", waiting=False, notes=""):
    """Writes Status and Message. now, problem: as hash_or_problem() gives them; waiting: an input is itself
    stale; notes: text that belongs to the stored result. A failure stays readable until the inputs
    change."""
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
    """Remembers a run that gave nothing. now: gives the hash of the object's inputs; tried: hash of those of
    the run ("": it did not come to read them), which may have had other settings: then a current result stays
    what it is."""
    if obj.InputHash and tried and tried != obj.InputHash and obj.InputHash == now():
        return
    set_changed(obj, "TriedHash", tried)
    set_changed(obj, "Status", CANCELLED if cancelled else FAILED)
    set_changed(obj, "Message", text)


def is_behind(obj):
    """Whether an object of ours has a result that is not that of its present inputs."""
    return kind_of(obj) != "" and getattr(obj, "Status", "") in (STALE, FAILED, CANCELLED)


def look_again(obj):
    """An object of ours compares its inputs with its result, beside a recompute of the document."""
    with quietly(obj):
        obj.Proxy.look(obj)


def tell_users(obj):
    """Objects of ours that use this one look again: it was changed beside a recompute of the document,
    or the recompute stops at it."""
    seen, waiting = [obj], [obj]
    while waiting:
        for user in waiting.pop().InList:
            if kind_of(user) and user not in seen:
                seen.append(user)
                waiting.append(user)
                look_again(user)


def renew(obj, before, now):
    """A document of before has hashes of before: where they are those of the inputs as they are, they
    become those of today. before, now: the hashes of the inputs, or "" where they are unusable."""
    for name in ("InputHash", "TriedHash"):
        known = getattr(obj, name)
        if known and not known.startswith(VERSION) and before and known == before:
            setattr(obj, name, now)


# --- place of a result that stands in the world


def outer_inverse(obj):
    """From the world to the frame in which an object's Placement counts."""
    try:
        return obj.Placement.multiply(obj.getGlobalPlacement().inverse())
    except AttributeError:
        return obj.Placement.__class__()


def remember_place(obj):
    """Keeps where the result was put."""
    set_place = convert.global_placement(*convert.root_path(obj))
    if not same_place(obj.Placed, set_place):
        obj.Placed = set_place


def is_displaced(obj):
    """Whether the result was moved away from where it was put: by hand, or with a group around it."""
    here = convert.global_placement(*convert.root_path(obj))
    return bool(obj.InputHash) and not same_place(obj.Placed, here)


def same_place(a, b):
    """Equal up to rounding (== of placements fails after a round trip)."""
    return abs(convert.matrix_of(a) - convert.matrix_of(b)).max() <= 1e-9
