# SPDX-License-Identifier: LGPL-2.1-or-later
"""The drawing of the motion editor in the 3D view: the part at its keys, the dragger, the coarse
envelope."""
import time

import FreeCAD as App

from .. import convert, core
from ..convert import InputProblem
from ..features import motion
from ..features.moving import middle_of
from ..trajectory.poses import at_time, base_of, shift_to
from ..views.dragger import PoseDragger
from ..views.ghost import CoarseEnvelope, Ghosts
from ..views.surface import LightParts
from . import widgets
from .preview import request_for

#: Deflection of the part for ghosts and preview, as a fraction of its box diagonal; largest number
#: of keys with a ghost; triangles of the simplified mesh that is drawn during editing.
GHOST_DEFLECTION, MOST_GHOSTS, PART_TRIANGLES = 0.003, 60, 15000

#: Time (s) between two pictures while a key is dragged: at least SOONEST. A picture waits for its
#: coarse envelope, but at most LATEST. More pictures would leave no time to compute envelopes.
SOONEST, LATEST = 0.07, 0.16


class KeysInView:
    """The half of the motion editor (motion_panel.MotionPanel) that draws."""

    def _make_ghosts(self):
        if self.pair is None:
            return
        try:
            corners = convert.box_corners([self.pair])
            size = float(((corners.max(axis=0) - corners.min(axis=0)) ** 2).sum()) ** 0.5
            body = convert.body_from([self.pair], max(size * GHOST_DEFLECTION, 1e-6))
        except InputProblem as problem:
            widgets.show_message(self.message, str(problem))
            return
        self.body = body
        self._begin_pivot(middle_of([self.pair], body.placement))
        self.coarse = CoarseEnvelope(self.document)  # first, so that the ghosts are drawn over it
        self.ghosts = Ghosts(self.document, body.vertices, body.triangles)
        self.light = LightParts(self.pair, PART_TRIANGLES)
        self._show_own_path(False)  # the edited path replaces it
        self.dragger = PoseDragger(self.document, size, self.dragged, self.dropped)
        self._set_snap()
        self.live.begin(self.pair, body)

    def _begin_pivot(self, middle):
        """Sets the pivot to the pivot of the motion, or for a new motion to the middle of the
        part."""
        point = middle if self.obj is None else None
        if self.obj is not None and self.obj.Pivot.Length and len(self.keys):
            place = self.body.placement.inverse()
            point = place.multiply(self.base()).multVec(self.obj.Pivot)
        self.pivot.begin(middle, point)
        self.renew_pivot()

    def renew_pivot(self):
        """Updates the pivot in the coordinates to which the keys apply; they depend on the pose
        type."""
        self.keys.displaces = self.frame.currentData() == "Relative"
        if self.body is None or not len(self.keys):
            return
        point, base = self.pivot.in_part(), self.base()
        if point is None:
            self.keys.pivot = App.Vector()
        else:
            self.keys.pivot = base.inverse().multVec(self.body.placement.multVec(point))
        # The dragger is at the pivot, with the orientation of the part.
        here = base.multVec(self.keys.pivot)
        self.handle = shift_to(self.body.placement.inverse().multVec(here))

    def _show_own_path(self, on):
        """Hides the path that the view of the motion object draws, or (on) restores its earlier
        visibility."""
        if self.obj is not None and widgets.alive(self.obj):
            view = self.obj.ViewObject
            if not on:
                self.path_seen = view.Visibility
            view.Visibility = on and self.path_seen

    def _snap_steps(self):
        return float(self.snap.property("rawValue")), float(self.snap_angle.property("rawValue"))

    def _set_snap(self):
        if self.dragger is not None:
            self.dragger.snap(*self._snap_steps())

    def base(self):
        """Returns the frame that the poses move (poses.base_of())."""
        # The ghosts show the body as it was placed when it was read, so this placement is used.
        poses, frame = self.world_poses(), self.frame.currentData()
        return base_of(poses, frame, self.body.placement, self.container)

    def world_poses(self):
        """Returns the keys in world coordinates."""
        return motion.seen_from_document(self.keys.poses(), self.container)

    def show_dragger(self):
        """Shows the dragger at the chosen key."""
        row = self.keyboard.row()
        if self.dragger is None:
            return
        if not self.drag_box.isChecked() or not 0 <= row < len(self.keys):
            self.dragger.hide()
            return
        self.dragger.show(self._standing_at(row).multiply(self.handle))

    def dragged(self, placement):
        """Handles a move of the dragger: the chosen key follows, as far as allowed."""
        row = self.keyboard.row()
        if not 0 <= row < len(self.keys):
            return
        if self.frame.currentData() == "RelativeToFirst" and row == 0:
            return  # the first pose is fixed at the present placement of the part
        world, self.let_go = placement.multiply(self.handle.inverse()), False
        if self.live.stops():
            self.live.reach(row, self._standing_at(row), world, placement.Base)
            return
        self.live.follow(world, placement.Base)
        self._move_key(row, world)

    def reached(self, row, world, last):
        """Moves the key as far towards the dragged placement as the part can get."""
        if row != self.keyboard.row() or row >= len(self.keys):
            return
        self._move_key(row, world)
        if last and self.let_go:
            self._settle()

    def show_clash(self, on):
        if self.ghosts is not None and self.ghosts.root is not None:
            self.ghosts.show_clash(on)

    def _standing_at(self, row):
        """Returns the placement of the part at a key, in world coordinates."""
        there = self.container.multiply(self.keys.placements[row]).multiply(self.base().inverse())
        return there.multiply(self.body.placement)

    def _move_key(self, row, world):
        """Moves a key so that the part is at a placement in world coordinates."""
        place = world.multiply(self.body.placement.inverse()).multiply(self.base())
        self.keys.update(row, self.container.inverse().multiply(place))
        self.undrawn = row
        if self.preview_box.isChecked():
            self.ask_preview(take=False)
            since = time.perf_counter() - self.drawn
            if since < SOONEST or since < LATEST and not self.preview.has_result():
                return
            self.preview.take()
        self.draw_dragged()

    def draw_dragged(self):
        """Draws all drag movements since the last picture."""
        row, self.undrawn, self.drawn = self.undrawn, None, time.perf_counter()
        if row is not None and row < len(self.keys):
            self.keyboard.show_row(self.keys, row)
            self.draw_ghosts()

    def dropped(self, placement):
        self.dragged(placement)
        self.let_go = True
        if not self.live.stops():
            self._settle()

    def _settle(self):
        """Called when the dragged key has its final placement."""
        self.let_go = False
        self.draw_dragged()
        self.noted()
        self.show_dragger()

    def _applied(self, placements):
        """Returns the placements that move the body to each pose (world coordinates)."""
        back = self.base().inverse()
        return [p.multiply(back) for p in placements]

    def show_all(self):
        self.show_dragger()
        self.show_tangent()
        self.show_ghosts()

    def show_ghosts(self):
        self.draw_ghosts()
        self.ask_preview()

    def draw_ghosts(self):
        if self.ghosts is not None:
            step = max(1, len(self.keys) // MOST_GHOSTS)
            poses = self.world_poses()
            placements = poses.placements[::step]
            self.ghosts.show_keys(self._applied(placements) if placements else [])
            self.ghosts.show_path(poses, self.interpolation.currentData())
        self.show_moving()

    def show_moving(self):
        if len(self.keys) and self.ghosts is not None:
            now = self.player.now()
            kind = self.interpolation.currentData()
            try:
                here = at_time(self.world_poses(), kind, now)
            except InputProblem:  # an invalid spline; its preview shows the problem
                here = at_time(self.world_poses(), "Linear", now)
            self.ghosts.show_moving(self._applied([here])[0])

    def ask_preview(self, take=True):
        """Requests a coarse envelope of the present keys. take: as in Preview.want()."""
        if self.ghosts is None:
            return
        if not self.preview_box.isChecked() or not len(self.keys):
            self.preview.stop()
            self.coarse.clear()
            return
        try:
            poses, rules = self.world_poses(), (self.base(), self.interpolation.currentData())
            if rules[1] == "Spline":
                poses.check_function()
            self.preview.want(lambda cells: [request_for(self.body, poses, *rules, cells)], take)
        except (InputProblem, core.CoreMissing) as problem:
            self.report_preview(str(problem))

    def show_preview(self, surface):
        if self.coarse is not None and self.coarse.root is not None:
            self.coarse.show(surface)
            self.draw_dragged()

    def report_preview(self, text):
        self.preview_text.setText(text)
        self.preview_text.setVisible(bool(text))
