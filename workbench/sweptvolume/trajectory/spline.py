# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smooth motion through keys: cubic, with a velocity at each key.

Positions are cubic Hermite pieces. Rotations are cumulative cubic pieces on the unit quaternions
(Kim, Kim and Shin 1995): q(u) = q0 exp(w0 b1) exp(w b2) exp(w1 b3). So the angular velocity is
continuous, too. The tangent of a key (TANGENTS) determines both velocities.
"""
import math

import FreeCAD as App

from ..convert import InputProblem
from ..texts import translate

#: Velocity at a key. Auto: from the adjacent keys. Stop: zero. Corner: the velocity of the straight
#: line on each side. Given: the velocity stored with the key; the rotation is as for Auto.
TANGENTS = ["Auto", "Stop", "Corner", "Given"]
_SMALL = 1e-12


def rotation_vector(rotation):
    """Returns axis times angle (rad); the angle is at most pi."""
    x, y, z, w = rotation.Q
    if w < 0:
        x, y, z, w = -x, -y, -z, -w
    sine = math.sqrt(x * x + y * y + z * z)
    if sine < _SMALL:
        return App.Vector(2 * x, 2 * y, 2 * z)
    return App.Vector(x, y, z) * (2 * math.atan2(sine, w) / sine)


def rotation_of(vector):
    """Returns the rotation for a vector from rotation_vector()."""
    angle = vector.Length
    if angle < _SMALL:
        return App.Rotation(vector.x / 2, vector.y / 2, vector.z / 2, 1.0)
    part = math.sin(angle / 2) / angle
    return App.Rotation(vector.x * part, vector.y * part, vector.z * part, math.cos(angle / 2))


class Spline:
    """A smooth curve of placements through keys. `tangents`: (kind, velocity in mm/s) for each key;
    missing entries are Auto."""

    def __init__(self, times, placements, tangents=()):
        self.times, self.placements = times, placements
        self.tangents = tangents
        self._pieces = {}

    def at(self, time):
        """Returns the placement at a time between the first and the last key."""
        k = self._piece_of(time)
        a, b = self.placements[k], self.placements[k + 1]
        if k not in self._pieces:
            self._pieces[k] = self._piece(k)
        v0, v1, turns = self._pieces[k]
        span = self.times[k + 1] - self.times[k]
        u = (time - self.times[k]) / span
        base = a.Base * ((1 + 2 * u) * (1 - u) ** 2) + b.Base * (u * u * (3 - 2 * u))
        base += (v0 * (u * (1 - u) ** 2) + v1 * (u * u * (u - 1))) * span
        turn = a.Rotation
        for vector, weight in zip(turns, (1 - (1 - u) ** 3, u * u * (3 - 2 * u), u**3)):
            turn = turn.multiply(rotation_of(vector * weight))
        return App.Placement(base, turn)

    def _piece_of(self, time):
        low, high = 0, len(self.times) - 2
        while low < high:
            middle = (low + high + 1) // 2
            if self.times[middle] <= time:
                low = middle
            else:
                high = middle - 1
        return low

    def _piece(self, k):
        """Returns the velocities at both ends (mm/s) and the three rotation vectors of a piece
        (rad)."""
        v0, w0 = self.velocity(k, after=True)
        v1, w1 = self.velocity(k + 1, after=False)
        third = (self.times[k + 1] - self.times[k]) / 3.0
        if not all(math.isfinite(v.Length) for v in (v0, v1, w0 * third, w1 * third)):
            raise InputProblem(
                translate(
                    "SweptVolume",
                    "The spline from pose {0} to pose {1} cannot be computed, because the "
                    "numbers in the computation become too large: check the times, placements "
                    "and given velocities of these poses.",
                ).format(k + 1, k + 2)
            )
        first, last = rotation_of(w0 * third), rotation_of(w1 * third)
        whole = self.placements[k].Rotation.inverted().multiply(self.placements[k + 1].Rotation)
        middle = first.inverted().multiply(whole).multiply(last.inverted())
        return v0, v1, (w0 * third, rotation_vector(middle), w1 * third)

    def velocity(self, k, after):
        """Returns the velocity (mm/s) and angular velocity (rad/s, in the frame of the part) at key
        k, on the piece after or before it."""
        kind, given = self.tangents[k] if k < len(self.tangents) else ("Auto", None)
        if kind == "Stop":
            return App.Vector(), App.Vector()
        straight, spin = self._mean(k, after, alone=kind == "Corner")
        if kind == "Given" and given is not None:
            straight = App.Vector(given)
        return straight, spin

    def _mean(self, k, after, alone):
        """Returns the velocities of the parabola through the adjacent keys. At the ends and at a
        corner, returns the velocities of the straight line."""
        last = len(self.times) - 1
        if k == 0 or (alone and after and k < last):
            return self._straight(k)
        if k == last or alone:
            return self._straight(k - 1)
        before, behind = self._straight(k - 1), self._straight(k)
        d0, d1 = self.times[k] - self.times[k - 1], self.times[k + 1] - self.times[k]
        weight = d1 / (d0 + d1)
        return tuple(a * weight + b * (1 - weight) for a, b in zip(before, behind))

    def _straight(self, k):
        """Returns the velocities of the straight line from key k to the next."""
        span = self.times[k + 1] - self.times[k]
        a, b = self.placements[k], self.placements[k + 1]
        turn = rotation_vector(a.Rotation.inverted().multiply(b.Rotation))
        return (b.Base - a.Base) * (1 / span), turn * (1 / span)
