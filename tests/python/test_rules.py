# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rules of neighbours: they mean the same in the program and in Python, and wrong rules are named."""
import csv
import io
import json

import numpy as np
import pytest

import swept_volume as sv
from test_paths import PART, WALLS, block, shift
from test_program import call, inputs  # noqa: F401


@pytest.fixture
def scene(inputs):  # noqa: F811
    """Makes the files of a scene: a block slides along a table, past a post at 1.5 mm, towards a
    wall 3 mm behind the end of its motion."""
    parts = {
        "block": block([0, 0, 0], [10, 10, 10]),
        "table": block([-20, -20, -5], [80, 30, 0]),
        "post": block([20, 11.5, 0], [24, 20, 30]),
        "wall": block([43, 0, 1], [50, 10, 20]),
        "bush": block([-30, 2, 2], [0.3, 8, 8]),
    }
    for name, mesh in parts.items():
        mesh.write(str(inputs / f"{name}.ply"))
    (inputs / "way.csv").write_text("t,tx,ty,tz,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n1,30,0,0,0,0,0,1\n")
    return parts


WORDS = ["clearance", "block.ply", "table.ply", "post.ply", "wall.ply", "--motion", "way.csv"]
MOTION = np.array([shift(0, 0, 0), shift(30, 0, 0)])


def verdicts(report):
    return {row["name"]: (row["verdict"], row["meets_rule"]) for row in report["neighbours"]}


def test_the_program_and_python_take_the_same_rules(call, inputs, scene):  # noqa: F811
    (inputs / "rules.txt").write_text("# what is bolted\n\ntab*=contact\n")
    done = call(*WORDS, "--required", "2", "--rules", "rules.txt", "--rule", "post=1", "--rule", "wall=3.5",
                "--report", "r.json", "--csv", "t.csv", cwd=inputs)  # fmt: skip
    assert done.returncode == 3, done.stderr
    report = json.loads((inputs / "r.json").read_text())
    names = ("table", "post", "wall")
    rules = {"tab*": "contact", "post": 1, "wall": "3.5"}
    parts = [(name, scene[name]) for name in names]
    same = sv.clearance(scene["block"], MOTION, parts, required=2, rules=rules)
    assert verdicts(report) == verdicts(same) == {
        "table": ("contact", True), "post": ("clear", True), "wall": ("below", False)
    }  # fmt: skip
    assert [row["rule"] for row in report["neighbours"]] == [
        {"contact": 0}, {"required": 1}, {"required": 3.5}
    ]  # fmt: skip
    assert report["neighbours"][report["smallest"]]["name"] == "post"
    table = list(csv.DictReader(io.StringIO((inputs / "t.csv").read_text())))
    assert [(row["rule"], row["meets_rule"]) for row in table] == [
        ("contact", "yes"), ("1", "yes"), ("3.5", "no")
    ]  # fmt: skip
    without = sv.clearance(scene["block"], MOTION, parts, required=2)
    assert verdicts(without)["table"] == ("contact", False)
    assert verdicts(without)["post"] == ("below", False)


def test_what_meets_its_rules_ends_well(call, inputs, scene):  # noqa: F811
    words = [*WORDS, "--required", "1", "--rule", "table=contact"]
    done = call(*words, cwd=inputs)
    assert done.returncode == 0 and "1 allowed contact" in done.stdout, done.stdout + done.stderr
    done = call(*words, "--rule", "p?st=ignore", "--csv", "-", "--quiet", cwd=inputs)
    assert done.returncode == 0 and done.stdout.splitlines()[-1].endswith(",ignore,"), done.stdout
    assert call(*WORDS, "--required", "1", cwd=inputs).returncode == 3


def test_contacts_at_the_first_pose_are_offered(call, inputs, scene):  # noqa: F811
    words = [*WORDS, "bush.ply"]
    done = call(*words, "--offer-rules", "rules.txt", cwd=inputs)
    assert done.returncode == 0, done.stderr
    lines = (inputs / "rules.txt").read_text().splitlines()
    assert lines[0].startswith("# Contacts at the first pose: 2 of the neighbours")
    assert lines[1:] == ["bush=contact:0.33", "table=contact"]
    offered = sv.first_contacts(
        scene["block"], MOTION, [(n, scene[n]) for n in ("table", "bush", "wall")]
    )
    assert offered == {"table": "contact", "bush": "contact:0.33"}
    done = call(*words, "--rules", "rules.txt", cwd=inputs)
    assert done.returncode == 0, done.stdout + done.stderr
    assert call(*words, cwd=inputs).returncode == 3


@pytest.mark.parametrize(
    "rule, status, text",
    [
        ("post", 2, "'post' is not a rule; write NAME=RULE"),
        ("post=-3", 2, "-3 mm is not allowed; enter 0 to 1e9 mm"),
        ("post=contact:-1", 2, "-1 mm is not allowed"),
        (
            "post=near",
            2,
            "rule 'near' is not understood; write a required distance in mm (such as 8), contact",
        ),
        ("hose=3", 1, "'hose' names no neighbour; the neighbours are: 'table', 'post', 'wall'"),
        ("*=ignore", 1, "the rules ignore every neighbour"),
    ],
)
def test_wrong_rules_are_named(call, inputs, scene, rule, status, text):  # noqa: F811
    done = call(*WORDS, "--rule", rule, cwd=inputs)
    assert done.returncode == status and text in done.stderr, done.stderr
    assert done.stdout == ""


def test_rules_that_contradict_each_other(call, inputs, scene):  # noqa: F811
    done = call(*WORDS, "--rule", "p*=3", "--rule", "*st=contact", cwd=inputs)
    assert done.returncode == 1 and "contradict each other for neighbour 'post'" in done.stderr
    (inputs / "rules.txt").write_text("table=contact\npost=x\n")
    done = call(*WORDS, "--rules", "rules.txt", cwd=inputs)
    assert done.returncode == 1 and "'rules.txt', line 2: rule 'x' is not understood" in done.stderr
    assert call(*WORDS, "--rules", "absent.txt", cwd=inputs).returncode == 1


def test_rules_of_python_are_checked():
    body, motion = block([0, 0, 0], [1, 1, 1]), np.array([shift(0, 0, 0), shift(1, 0, 0)])
    parts = [("far", block([5, 0, 0], [6, 1, 1]))]
    for rule in (None, True, [3]):
        with pytest.raises(TypeError, match="the rule for 'far' is"):
            sv.clearance(body, motion, parts, rules={"far": rule})
    with pytest.raises(sv.InvalidInput, match="contact of -1 mm"):
        sv.clearance(body, motion, parts, rules={"far": "contact:-1"})
    found = sv.clearance(body, motion, parts, rules={"far": np.float32(2.5)})
    assert found["neighbours"][0]["rule"] == {"required": 2.5}


# Random mixtures of rules: the walls that break them are compared with FCL's distances at 400 times of the
# motion.
def test_random_rules_against_stamps(call, inputs):  # noqa: F811
    random = np.random.default_rng(4)
    body = block([0, 0, 0], [6, 5, 4])
    body.write(str(inputs / "body.ply"))
    (inputs / "way.csv").write_text(
        "t,tx,ty,tz,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n1,40,3,0,0,0,0.5,0.8660254037844386\n"
        "2,60,30,9,0,0.5,0,0.8660254037844386\n"
    )
    blamed = 0
    for _ in range(8):
        words, rules_of = ["clearance", "body.ply", "--motion", "way.csv", "--stamp", 200], {}
        for k in range(5):
            low = np.array(
                [random.uniform(-20, 70), random.uniform(10, 50), random.uniform(-20, 30)]
            )
            block(low, low + random.uniform(3, 12, 3)).write(str(inputs / f"n{k}.ply"))
            rules_of[f"n{k}"] = float(random.uniform(0.5, 40))
            words += [f"n{k}.ply", "--rule", f"n{k}={rules_of[f'n{k}']}"]
        done = call(*words, "--report", "r.json", cwd=inputs)
        assert done.returncode in (0, 3), done.stderr
        stamped = {}
        for line in done.stdout.splitlines():
            if line.startswith("sampled at"):
                name = line.split(" against ")[1].split(":")[0]
                stamped[name] = float(line.split("smallest distance ")[1].split(" mm")[0])
        report = json.loads((inputs / "r.json").read_text())
        assert len(stamped) == 5
        for row in report["neighbours"]:
            own = rules_of[row["name"]]
            if stamped[row["name"]] < own:
                assert not row["meets_rule"], row["name"]
                blamed += 1
            elif stamped[row["name"]] > own + 0.5:  # FCL's times are 0.2 mm of travel apart
                assert row["meets_rule"], row["name"]
        assert (done.returncode == 3) == any(not row["meets_rule"] for row in report["neighbours"])
    assert 8 < blamed < 36


def test_searches_take_the_same_rules():
    rules = {"floor": "ignore", "l*": 0.9}
    report, motion = sv.find_path(
        PART, shift(0, 0, 0), WALLS, start=shift(0, 0, -60), clearance=0.5, rules=rules
    )
    assert report["verdict"] == "found" and report["ignored"] == ["floor"]
    checked = sv.clearance(PART, motion, WALLS, required=0.5, rules=rules)
    assert all(row["meets_rule"] for row in checked["neighbours"]), checked["summary"]
    with pytest.raises(sv.InvalidInput, match="GoalBlocked|1.1 mm are required"):
        sv.find_path(PART, shift(0, 0, 0), WALLS, extract=60.0, clearance=0.5, rules={"left": 1.1})
    with pytest.raises(sv.InvalidInput, match="allows contact.*release distance"):
        sv.find_path(PART, shift(0, 0, 0), WALLS, extract=60.0, rules={"left": "contact"})
    better, _ = sv.improve_path(PART, motion, WALLS, clearance=0.5, rules=rules)
    assert better["verdict"] == "found" and better["ignored"] == ["floor"]
