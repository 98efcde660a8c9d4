// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/triangle_distance.h"

#include <algorithm>

namespace swept {
namespace {

using Eigen::Vector3d;

// Finds the nearest points of p + s u and q + t v, with both parameters in [0, 1].
void nearestOnSegments(const Vector3d& p, const Vector3d& u, const Vector3d& q, const Vector3d& v,
                       Vector3d& onFirst, Vector3d& onSecond) {
  const Vector3d w = p - q;
  const double uu = u.squaredNorm();
  const double vv = v.squaredNorm();
  const double uw = u.dot(w);
  const double vw = v.dot(w);
  double s = 0;
  double t = 0;
  if (uu > 0 && vv > 0) {
    const double uv = u.dot(v);
    const double determinant = uu * vv - uv * uv;
    if (determinant > 0) s = std::clamp((uv * vw - vv * uw) / determinant, 0.0, 1.0);
    t = (uv * s + vw) / vv;
    if (t < 0) {
      t = 0;
      s = std::clamp(-uw / uu, 0.0, 1.0);
    } else if (t > 1) {
      t = 1;
      s = std::clamp((uv - uw) / uu, 0.0, 1.0);
    }
  } else if (uu > 0) {
    s = std::clamp(-uw / uu, 0.0, 1.0);
  } else if (vv > 0) {
    t = std::clamp(vw / vv, 0.0, 1.0);
  }
  onFirst = p + s * u;
  onSecond = q + t * v;
}

// The plane of a triangle, with a test whether the projection of a point lies in the triangle.
struct Face {
  const Triangle3d& c;
  Vector3d normal;
  double squared;  // of the normal; 0 for needles: their normal is inexact, and their edges suffice
  explicit Face(const Triangle3d& corners)
      : c(corners), normal((c[1] - c[0]).cross(c[2] - c[0])), squared(normal.squaredNorm()) {
    const double edge = std::max((c[1] - c[0]).squaredNorm(), (c[2] - c[0]).squaredNorm());
    if (!(squared > 1e-16 * edge * edge)) squared = 0;
  }
  double height(const Vector3d& x) const { return normal.dot(x - c[0]); }
  bool covers(const Vector3d& x) const {
    for (int k = 0; k < 3; ++k)
      if (normal.dot((c[(k + 1) % 3] - c[k]).cross(x - c[k])) < 0) return false;
    return true;
  }
};

// Tests the corners of `other` that project into the face, and the edges of `other` that pass
// through it. `swapped` says that the face belongs to b.
void faceCandidates(const Face& face, const Triangle3d& other, bool swapped, NearestPoints& best) {
  if (!(face.squared > 0)) return;
  const std::array<double, 3> h{face.height(other[0]), face.height(other[1]),
                                face.height(other[2])};
  const auto update = [&](double squared, const Vector3d& onFace, const Vector3d& onOther) {
    if (squared >= best.squared) return;
    best.squared = squared;
    best.a = swapped ? onOther : onFace;
    best.b = swapped ? onFace : onOther;
  };
  for (int k = 0; k < 3; ++k) {
    const double squared = h[k] * h[k] / face.squared;
    if (squared < best.squared && face.covers(other[k]))
      update(squared, other[k] - face.normal * (h[k] / face.squared), other[k]);
    const int l = (k + 1) % 3;
    if ((h[k] < 0) != (h[l] < 0)) {
      const Vector3d x = other[k] + (other[l] - other[k]) * (h[k] / (h[k] - h[l]));
      if (face.covers(x)) update(0.0, x, x);
    }
  }
}

}  // namespace

NearestPoints nearestPoints(const Triangle3d& a, const Triangle3d& b) {
  NearestPoints best;
  best.squared = std::numeric_limits<double>::infinity();
  const std::array<Vector3d, 3> u{a[1] - a[0], a[2] - a[1], a[0] - a[2]};
  const std::array<Vector3d, 3> v{b[1] - b[0], b[2] - b[1], b[0] - b[2]};
  Vector3d onA;
  Vector3d onB;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      nearestOnSegments(a[i], u[i], b[j], v[j], onA, onB);
      const double squared = (onA - onB).squaredNorm();
      if (squared < best.squared) {
        best.squared = squared;
        best.a = onA;
        best.b = onB;
      }
    }
  }
  faceCandidates(Face(a), b, false, best);
  faceCandidates(Face(b), a, true, best);
  return best;
}

Foot detail::footOnNeedle(const Vector3d& p, const Triangle3d& c) {
  const Face face(c);
  if (face.squared > 0) {
    const Vector3d foot = p - face.normal * (face.height(p) / face.squared);
    if (face.covers(foot)) return {foot, p - foot};
  }
  Foot best{c[0], p - c[0]};
  for (int k = 0; k < 3; ++k) {
    const Vector3d edge = c[(k + 1) % 3] - c[k];
    const double length = edge.squaredNorm();
    const double s = length > 0 ? std::clamp(edge.dot(p - c[k]) / length, 0.0, 1.0) : 0.0;
    const Vector3d offset = (p - c[k]) - s * edge;
    if (offset.squaredNorm() < best.offset.squaredNorm()) best = {c[k] + s * edge, offset};
  }
  return best;
}

}  // namespace swept
