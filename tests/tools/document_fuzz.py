#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Saved documents with damaged properties of the workbench, opened and used in FreeCAD.

    document_fuzz.py [--count N] [--first SEED] [--seconds S] [--out FOLDER]

A document with each kind of object of the workbench is saved once. Each case changes one to four values in
it (numbers, texts, links, lists of times and placements, dropped properties), opens it, recomputes, reads
every report, computes every object, saves it and opens it again. Each case must end as promised: FreeCAD
refuses the file, or every run is Ok or fails with a sentence (InputProblem, CoreError). No other exception
may occur, not even in methods that FreeCAD calls by itself, and no crash or hang. Cases run in a child
process and depend only on their seed. A document that breaks the promise is kept in FOLDER (out/documents),
and the exit status is 1.
"""
import argparse
import collections
import contextlib
import json
import os
import pathlib
import random
import re
import select
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest.mock
import xml.etree.ElementTree as ElementTree
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
HANG = 120  # s
PATIENCE = 3  # s until a run is cancelled

NUMBERS = [0, -1, 1, 2, 7, -(10**9), 10**9, 2**31 - 1, -(2**31), 1e-300, 1e300, 0.1, -0.5]
DOUBLES = [0.0, -1.0, 1e-12, 1e12, 1e300, float("inf"), float("-inf"), float("nan")]
TEXTS = [
    "",
    "x",
    "{}",
    "[]",
    "null",
    "[1, 2",
    '{"a": 1}',
    '{"neighbours": [{}]}',
    "0",
    "-1",
    "\u00fc\u4e2d" * 9,
]
TEXTS += [
    '{"warnings": 3}',
    '{"warnings": [{"code": 1}]}',
    "Stale",
    "Up to date",
    "/none/such",
    "a" * 10000,
]


# ---- the child: FreeCAD ----


def base_document(folder):
    """Saves a document with one object of each kind of the workbench. Returns its path."""
    import FreeCAD as App
    from case import Case, shift, turn
    from sweptvolume.features import clearance, envelope, motion, solid

    case = Case()
    case.setUp()
    doc = case.doc
    table = os.path.join(folder, "m.csv")
    with open(table, "w") as out:
        out.write("0,0,0,0,0,0,0,1\n1,30,0,0,0,0,0,1\n")
    paths = [motion.motion_from_file(doc, table, "mm")]
    smooth = motion.motion_from_poses(doc, [0, 1, 3], [shift(), turn(60), shift(9, 5)], "Spline")
    motion.set_tangents(smooth, [("Auto", None), ("Given", App.Vector(3, 1, 0)), ("Stop", None)])
    paths.append(smooth)
    paths.append(motion.motion_from_source(doc, "Placements", [case.box("A"), case.box("B")]))
    wire = doc.addObject("Part::Line", "Wire")
    doc.recompute()
    paths.append(motion.motion_from_source(doc, "Curve", [wire], count=5))
    driven = {"property": "Length", "start": 1, "end": 9, "count": 3, "duration": 2}
    paths.append(motion.motion_from_source(doc, "Driven", [doc.A, doc.B], **driven))
    part = case.box()
    plain = case.envelope([part], paths[0], Resolution=16)
    seen = case.envelope([part, doc.A], paths[1], Resolution=16, Offset=1)
    seen.Motions = [paths[1], paths[0]]
    seen.Reference, seen.ReferenceMotion = (doc.B, [""]), paths[0]
    body = solid.make_solid(doc, plain, Tolerance=0.2)
    wall = case.box("Wall")
    wall.Placement = shift(0, 15)
    settings = {"MovingParts": [(part, "")], "Neighbours": [(wall, "")]}
    check = clearance.make_clearance(doc, Motion=paths[0], AllVisible=False, **settings)
    doc.recompute()
    for module, obj in ((envelope, plain), (envelope, seen), (solid, body), (clearance, check)):
        module.compute(obj)
    path = os.path.join(folder, "base.FCStd")
    doc.saveAs(path)
    case.tearDown()
    return path


@contextlib.contextmanager
def watched(found):
    """Collects exceptions of proxies in `found`, except those of the workbench. FreeCAD only prints them."""
    from sweptvolume import core
    from sweptvolume.convert import InputProblem
    from sweptvolume.features import clearance, envelope, motion, solid

    def watch(action):
        def run(*arguments):
            try:
                return action(*arguments)
            except Exception as error:
                if not isinstance(error, (InputProblem, core.CoreMissing)):
                    found.append("{}, {}: {}".format(action.__name__, type(error).__name__, error))
                raise

        return run

    with contextlib.ExitStack() as stack:
        for kind in (clearance.Clearance, envelope.Envelope, motion.Motion, solid.Solid):
            for name in ("execute", "onDocumentRestored"):
                action = watch(getattr(kind, name))
                stack.enter_context(unittest.mock.patch.object(kind, name, action))
        yield


def use(path, copy):
    """Opens a document and does what users do with it. Returns a word that says how it ended."""
    import FreeCAD as App
    from sweptvolume import core
    from sweptvolume.convert import InputProblem
    from sweptvolume.features import base, clearance, clearance_table, envelope, motion, solid

    def tried(action, *arguments):
        timer = None
        try:
            control = core.Control()
            timer = threading.Timer(PATIENCE, control.cancel)
            timer.start()
            return action(*arguments, **({"control": control} if action in runs else {})), "Ok"
        except core.CoreError as error:
            return None, error.status
        except InputProblem:
            return None, "InputProblem"
        finally:
            timer.cancel()

    runs = [module.compute for module in (envelope, solid, clearance)]
    try:
        doc = App.openDocument(path)
    except Exception as error:  # FreeCAD's own refusal has many types
        return {"refused by FreeCAD: " + type(error).__name__: 1}
    ends = collections.Counter()
    doc.recompute(None, True)
    for obj in doc.Objects:
        kind = base.kind_of(obj)
        if kind == motion.Motion.KIND:
            for action in (
                motion.poses_of,
                motion.reload_source,
                motion.words,
                motion.refresh_status,
            ):
                ends["motion " + tried(action, obj)[1]] += 1
        elif kind == envelope.Envelope.KIND:
            before = obj.Mesh.CountFacets
            end = tried(envelope.compute, obj)[1]
            ends["envelope " + end] += 1
            if end != "Ok" and obj.Mesh.CountFacets != before:
                raise AssertionError("a run that failed changed the mesh")
            envelope.can_recut(obj)
            if envelope.report_of(obj):
                envelope.warnings_of(envelope.report_of(obj))
        elif kind == solid.Solid.KIND:
            ends["solid " + tried(solid.compute, obj)[1]] += 1
        elif kind == clearance.Clearance.KIND:
            if clearance.report_of(obj):
                clearance_table.table(clearance.report_of(obj))
            ends["clearance " + tried(clearance.compute, obj)[1]] += 1
    doc.recompute(None, True)
    count = len(doc.Objects)
    doc.saveAs(copy)
    App.closeDocument(doc.Name)
    if len(App.openDocument(copy).Objects) != count:
        raise AssertionError("saved and opened again, objects are missing")
    return ends


def judged(path, copy):
    """Returns how a document ended: a dict with `ends` and `fault` ("" if all is as promised)."""
    import FreeCAD as App

    found, ends = [], {}
    with watched(found):
        try:
            ends = use(path, copy)
        except Exception as error:
            found.append("{}: {}".format(type(error).__name__, error))
        for name in list(App.listDocuments()):
            App.closeDocument(name)
    return {"fault": "; ".join(found), "ends": ends}


def serve(folder):
    """Runs as the child process: reads seeds and prints a line of JSON for each."""
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # for whatever FreeCAD and the kernel print
    sys.path[:0] = [str(ROOT / "tests/freecad")]
    import conftest  # noqa: F401 (finds FreeCAD, with a separate profile)

    path = base_document(folder)
    with zipfile.ZipFile(path) as file:
        items = {name: file.read(name) for name in file.namelist()}
    broken, copy = os.path.join(folder, "broken.FCStd"), os.path.join(folder, "copy.FCStd")
    print("ready", file=answers, flush=True)
    for line in sys.stdin:
        changes = damage(items, random.Random(int(line)), broken)
        print(json.dumps(dict(judged(broken, copy), changes=changes)), file=answers, flush=True)


# ---- damage ----


def damage(items, chance, path):
    """Writes a document with one to four changes to properties of the workbench's objects. Returns the
    changes as texts.
    """
    items = dict(items)
    tree = ElementTree.fromstring(items["Document.xml"])
    places = []
    for obj in tree.iter("Object"):
        properties = obj.find("Properties")
        if properties is None or properties.find("Property[@name='Proxy']") is None:
            continue
        module = properties.find("Property[@name='Proxy']/Python")
        if module is not None and module.get("module", "").startswith("sweptvolume"):
            places += [(obj.get("name"), properties, p) for p in properties.findall("Property")]
    names = [obj.get("name") for obj in tree.iter("Object") if obj.find("Properties") is not None]
    places = [place for place in places if place[2].get("name") not in ("Proxy", "Visibility")]
    changes = []
    for _ in range(chance.randint(1, 4)):
        owner, properties, place = chance.choice(places)
        what = change(place, properties, items, names, chance)
        changes.append("{}.{}: {}".format(owner, place.get("name"), what))
    items["Document.xml"] = ElementTree.tostring(tree, encoding="utf-8", xml_declaration=True)
    with zipfile.ZipFile(path, "w") as file:
        for name, data in items.items():
            file.writestr(name, data)
    return changes


def change(place, properties, items, names, chance):
    if chance.random() < 0.1 and place in list(properties):
        properties.remove(place)
        properties.set("Count", str(len(properties)))
        return "dropped"
    leaves = [
        e for e in place.iter() if e is not place and ("value" in e.keys() or "file" in e.keys())
    ]
    leaves += [e for e in place.iter() if e.tag in ("Link", "XLink", "Sub") and e not in leaves]
    if not leaves:
        return "left"
    leaf = chance.choice(leaves)
    if leaf.get("file") in items and leaf.get("file"):
        items[leaf.get("file")] = other_list(items[leaf.get("file")], leaf.tag, chance)
        return "list " + leaf.get("file")
    key = next((k for k in ("value", "obj", "name", "sub") if k in leaf.keys()), None)
    if key is None:
        return "left"
    value = leaf.get(key)
    if "Link" in leaf.tag and key != "sub":
        new = chance.choice(names + ["", "NoSuchObject"])
    elif value in ("true", "false"):
        new = "false" if value == "true" else "true"
    elif re.fullmatch(r"-?\d+", value) and leaf.tag == "Integer":
        new = str(int(chance.choice(NUMBERS)))
    elif re.fullmatch(r"[-+.\deE]+", value) and leaf.tag == "Float":
        new = str(float(chance.choice(NUMBERS)))
    else:
        number = str(chance.choice(NUMBERS))
        others = [
            value[: len(value) // 2],
            value.replace("1", "null"),
            re.sub(r"\d+", number, value),
        ]
        new = chance.choice(TEXTS + 3 * others)
    leaf.set(key, new)
    return "{!r:.60} -> {!r:.60}".format(value, new)


def other_list(data, tag, chance):
    """Changes the length or the numbers of a stored list of doubles. The count at its start still agrees
    with its bytes."""
    width = {"FloatList": 8, "VectorList": 24, "PlacementList": 56}.get(tag)
    if width is None or len(data) < 4:
        return data
    rows = [data[i : i + width] for i in range(4, len(data) - width + 1, width)]
    kind = chance.randrange(4)
    if kind == 0 and rows:
        rows.pop(chance.randrange(len(rows)))
    elif kind == 1 and rows:
        rows.insert(0, chance.choice(rows))
    elif kind == 2:
        rows = []
    elif rows:
        row = chance.randrange(len(rows))
        numbers = list(struct.unpack("<{}d".format(width // 8), rows[row]))
        numbers[chance.randrange(len(numbers))] = chance.choice(DOUBLES)
        rows[row] = struct.pack("<{}d".format(width // 8), *numbers)
    return struct.pack("<I", len(rows)) + b"".join(rows)


# ---- the parent ----


class Child:
    def __init__(self, folder):
        self.folder, self.process = folder, None

    def line(self, seconds):
        ready, _, _ = select.select([self.process.stdout], [], [], seconds)
        return self.process.stdout.readline() if ready else ""

    def run(self, seed):
        if self.process is None:
            self.process = subprocess.Popen(
                [sys.executable, __file__, "--serve", self.folder],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                text=True,
            )
            if self.line(HANG).strip() != "ready":
                raise SystemExit("FreeCAD or the module _swept does not start; see above")
        self.process.stdin.write("{}\n".format(seed))
        self.process.stdin.flush()
        line = self.line(HANG)
        if line:
            return json.loads(line)
        hung = self.process.poll() is None
        self.process.kill()
        code = self.process.wait()
        self.process = None
        return {"changes": [], "fault": "hang" if hung else "crash {}".format(code)}

    def stop(self):
        if self.process is not None:
            self.process.kill()
            self.process.wait()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--count", type=int, default=10**9)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=float("inf"))
    parser.add_argument("--out", default="out/documents")
    parser.add_argument("--serve")
    options = parser.parse_args()
    if options.serve:
        return serve(options.serve)
    ends, faults, start = collections.Counter(), 0, time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        child = Child(folder)
        seed = options.first
        while seed < options.first + options.count and time.monotonic() < start + options.seconds:
            outcome = child.run(seed)
            ends.update(outcome.get("ends", {}))
            if outcome["fault"]:
                faults += 1
                kept = pathlib.Path(options.out)
                kept.mkdir(parents=True, exist_ok=True)
                (kept / "{}.json".format(seed)).write_text(json.dumps(outcome, indent=1))
                broken = os.path.join(folder, "broken.FCStd")
                if os.path.exists(broken):
                    (kept / "{}.FCStd".format(seed)).write_bytes(open(broken, "rb").read())
                print("{}: {} ({})".format(seed, outcome["fault"], "; ".join(outcome["changes"])))
            seed += 1
        child.stop()
    for end, count in sorted(ends.items()):
        print("{:8d}  {}".format(count, end))
    print("{} documents, {} faults".format(seed - options.first, faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
