# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every function of the package that takes parts: arrays, masked arrays, values that are sent to other
processes, cancelling.
"""
import multiprocessing
import pickle

import numpy as np
import pytest

import swept_volume as sv
from test_paths import block, shift
from test_reports import reproducible

PART = block([0, 0, 0], [1, 1, 1])
FAR = block([0, 9, 0], [1, 10, 1])
MOTION = sv.Motion([0, 1], np.tile([0.0, 0, 0, 1], (2, 1)), [[0, 0, 0], [5, 0, 0]])
START = shift(0, -9, 0)

#: Calls with a part: the report of each, and the meshes and motions that it returns.
CALLS = {
    "clearance": lambda part, run: (sv.clearance(part, MOTION, [("far", FAR)], run=run),),
    "clearance, neighbour": lambda part, run: (sv.clearance(FAR, MOTION, [("p", part)], run=run),),
    "mechanism": lambda part, run: (
        sv.mechanism([("part", part, MOTION), ("far", FAR, None)], run=run),
    ),
    "overlap": lambda part, run: sv.overlap([("part", part), ("far", FAR)], run=run),
    "find_path": lambda part, run: sv.find_path(
        part, np.eye(4), [("far", FAR)], start=START, run=run
    ),
    "improve_path": lambda part, run: sv.improve_path(part, MOTION, [("far", FAR)], run=run),
    "find_sequence": lambda part, run: sv.find_sequence(
        [sv.SequencePart("part", part, start=START)], [("far", FAR)], run=run
    ),
}
EACH = pytest.mark.parametrize("name", CALLS)


def bytes_of(found):
    """Returns the result without what depends on the machine."""
    report, *rest = found
    return pickle.dumps((reproducible(report), rest))


@EACH
def test_pairs_of_arrays_say_the_same_and_masks_are_refused(name):
    arrays = (PART.vertices.tolist(), PART.triangles.astype(np.uint8))
    assert bytes_of(CALLS[name](arrays, None)) == bytes_of(CALLS[name](PART, None))
    masked = (np.ma.masked_equal(PART.vertices, 1), PART.triangles)
    with pytest.raises(TypeError, match="vertices is a masked array"):
        CALLS[name](masked, None)


@pytest.mark.parametrize("key", ["goal", "start", "via", "extract"])
def test_masked_places_are_refused(key):
    """Masked arrays are refused: their numbers would be used and their masks lost."""
    place = np.ma.masked_equal(shift(0, -9, 0), -9)
    value = {"via": [place], "extract": np.ma.masked_equal([0.0, 0, 1], 1)}.get(key, place)
    options = {"goal": np.eye(4), "start": START, key: value}
    if key == "extract":
        del options["start"]
    with pytest.raises(TypeError, match=f"{key} is a masked array"):
        sv.find_path(PART, options["goal"], [("far", FAR)],
                     **{k: v for k, v in options.items() if k != "goal"})  # fmt: skip
    with pytest.raises(TypeError, match=f"{key} is a masked array"):
        sv.find_sequence([sv.SequencePart("part", PART, **options)], [("far", FAR)])
    with pytest.raises(ValueError, match=r"goal has shape \(3, 4\)"):
        sv.find_path(PART, np.eye(4)[:3], [("far", FAR)], start=START)


@EACH
def test_a_cancelled_context_ends_the_call(name):
    run = sv.RunContext()
    run.cancel()
    with pytest.raises(sv.Cancelled) as caught:
        CALLS[name](PART, run)
    assert pickle.loads(pickle.dumps(caught.value)).code == caught.value.code


def test_parts_of_sequences_can_be_pickled_and_say_what_they_are():
    part = sv.SequencePart("part", PART, extract=9.0)
    assert pickle.loads(pickle.dumps(part)) == part
    assert repr(part).startswith("SequencePart(name='part', mesh=<Mesh: 8 vertices, 12 triangles")
    with pytest.raises(AttributeError):
        part.name = "other"


def answer_all(queue):
    queue.put([bytes_of(call(PART, None)) for call in CALLS.values()])


@pytest.mark.parametrize("way", ["fork", "spawn"])
def test_processes_give_the_same_bytes(way):
    expected = [bytes_of(call(PART, None)) for call in CALLS.values()]
    context = multiprocessing.get_context(way)
    queue = context.Queue()
    jobs = [context.Process(target=answer_all, args=(queue,)) for _ in range(2)]
    for job in jobs:
        job.start()
    found = [queue.get(timeout=240) for _ in jobs]
    for job in jobs:
        job.join(timeout=60)
        assert job.exitcode == 0
    assert found == [expected, expected]


def test_files_that_are_not_there_raise_the_systems_own_errors(tmp_path):
    for call in (sv.read_parts, sv.run_study, sv.study_page):
        with pytest.raises(FileNotFoundError) as caught:
            call(tmp_path / "none.step")
        assert str(caught.value.filename) == str(tmp_path / "none.step")
