# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents saved by one version of FreeCAD open in the others.

Writes a document, then opens all documents in its folder. With SWEPT_DOCUMENTS=FOLDER, several
versions use the same folder (.ci/matrix runs this test in each, and once more in the first one).
"""
import glob
import json
import os

import FreeCAD as App

from case import Case, shift, turn
from sweptvolume.features import clearance, envelope, motion, solid


class Versions(Case):
    NEEDS_CORE = True

    def setUp(self):
        super().setUp()
        self.shared = os.environ.get("SWEPT_DOCUMENTS", self.folder)
        os.makedirs(self.shared, exist_ok=True)

    def write(self):
        """Writes a document with a motion from a file, an envelope, a solid and a clearance check,
        all computed."""
        table = self.file("m.csv", "0,0,0,0,0,0,0,1\n1,30,0,0,0,0,0,1\n")
        path = motion.motion_from_file(self.doc, table, "mm")
        second = motion.motion_from_poses(self.doc, [0, 2], [shift(), turn(60, base=shift(9).Base)])
        second.Interpolation = "Screw"
        moving = self.box()
        obj = self.envelope([moving], path, Offset=1)
        body = solid.make_solid(self.doc, obj, Tolerance=0.2)
        wall = self.box("Wall")
        wall.Placement = shift(0, 15)
        self.doc.recompute()
        envelope.compute(obj)
        solid.compute(body)
        check = clearance.make_clearance(
            self.doc,
            MovingParts=[(moving, "")],
            Motion=path,
            AllVisible=False,
            Neighbours=[(wall, "")],
        )
        self.doc.recompute()
        clearance.compute(check)
        self.doc.recompute()
        name = ".".join(App.Version()[:2])
        known = {
            "table": table,
            "hash": obj.InputHash,
            "facets": obj.Mesh.CountFacets,
            "volume": obj.Volume.Value,
            "solid": body.Shape.Volume,
            "smallest": clearance.report_of(check)["smallest"],
            "names": [o.Name for o in (path, second, obj, body, check)],
        }
        self.doc.saveAs(os.path.join(self.shared, name + ".FCStd"))
        with open(os.path.join(self.shared, name + ".json"), "w") as file:
            json.dump(known, file)
        App.closeDocument(self.doc.Name)

    def check_document(self, file):
        with open(file[: -len("FCStd")] + "json") as text:
            known = json.load(text)
        doc = App.openDocument(file)
        path, second, obj, body, check = [doc.getObject(name) for name in known["names"]]
        self.assertEqual(len(path.Placements), 2)
        self.assert_placement(path.Placements[1], shift(30))
        self.assertEqual((second.Interpolation, list(second.Times)), ("Screw", [0, 2]))
        self.assertEqual(obj.Mesh.CountFacets, known["facets"])
        self.assertAlmostEqual(obj.Volume.Value, known["volume"], 6)
        self.assertTrue(body.Shape.isValid())
        self.assertAlmostEqual(body.Shape.Volume, known["solid"], delta=1e-6 * known["solid"])
        self.assertAlmostEqual(clearance.report_of(check)["smallest"], known["smallest"], 9)
        self.assertIn(obj.Status, (envelope.UP_TO_DATE, envelope.STALE))
        envelope.compute(obj)
        solid.compute(body)
        clearance.compute(check)
        # The file of poses of the other version was deleted with its folder. The motion keeps its poses, and
        # is stale.
        here = os.path.isfile(known["table"])
        self.assertEqual(path.Status, "" if here else motion.STALE)
        self.assertEqual(obj.Status, envelope.UP_TO_DATE if here else envelope.STALE)
        self.assertEqual(obj.InputHash, known["hash"])
        self.assertAlmostEqual(obj.Volume.Value, known["volume"], delta=1e-6 * known["volume"])
        self.assertAlmostEqual(body.Shape.Volume, known["solid"], delta=1e-2 * known["solid"])
        self.assertAlmostEqual(
            clearance.report_of(check)["smallest"], known["smallest"], delta=0.02
        )
        App.closeDocument(doc.Name)

    def test_documents_of_all_versions_open_here(self):
        self.write()
        files = sorted(glob.glob(os.path.join(self.shared, "*.FCStd")))
        for file in files:
            with self.subTest(file=os.path.basename(file)):
                self.check_document(file)
        print("opened:", ", ".join(os.path.basename(file) for file in files))
