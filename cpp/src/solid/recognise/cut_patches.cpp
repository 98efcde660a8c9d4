// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "solid/recognise/region_finder.h"
#include "solid/recognise/steps.h"

namespace swept::step {
namespace {

using Eigen::Vector3d;

Vector3d centreOf(const HalfEdgeMesh& mesh, std::int32_t t) {
  const auto& tri = mesh.triangles[t];
  return (mesh.points[tri[0]] + mesh.points[tri[1]] + mesh.points[tri[2]]) / 3;
}

// Returns the largest gap between the angles; `middle` receives the middle of this gap.
double largestGap(std::vector<double> angles, double& middle) {
  std::sort(angles.begin(), angles.end());
  double gap = 2 * M_PI - angles.back() + angles.front();
  middle = angles.back() + gap / 2;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    if (angles[i] - angles[i - 1] > gap) {
      gap = angles[i] - angles[i - 1];
      middle = angles[i - 1] + gap / 2;
    }
  }
  return gap;
}

constexpr double kMinGap = 1.2;  // rad: smallest gap in which the seam may lie

class Cutter {
 public:
  Cutter(const HalfEdgeMesh& mesh, Partition& partition) : mesh_(mesh), partition_(partition) {}

  void cutAll() {
    // Spheres may be cut in any direction. So they are cut last, when the corners around them are
    // known.
    const auto count = static_cast<std::int32_t>(partition_.patches.size());
    for (const bool spheres : {false, true}) {
      for (std::int32_t p = 0; p < count; ++p) {
        if ((partition_.patches[p].surface.kind == CarrierKind::Sphere) == spheres) cut(p);
      }
    }
  }

 private:
  static double angle(const Vector3d& d, const Vector3d& x, const Vector3d& y) {
    return std::atan2(d.dot(y), d.dot(x));
  }

  // Rotates the reference direction of the surface, or opens its closed profile, so that its seam
  // lies in the largest gap of the patch. Returns false if no gap is wide enough.
  bool turnSeam(Patch& patch) const {
    Carrier& s = patch.surface;
    if (s.isPlanar()) return true;
    if (s.kind == CarrierKind::Sphere) return placePoles(patch);
    if (s.hasProfile() && s.profile->isClosed() && !openProfile(patch)) return false;
    // An extrusion keeps its reference direction, since the profile's coordinates depend on it.
    if (s.kind == CarrierKind::Extrusion) return true;
    const Vector3d x = anyOrthogonal(s.axis), y = s.axis.cross(x);
    std::vector<double> turn, tube;
    for (const std::int32_t t : patch.triangles) {
      for (const std::int32_t v : mesh_.triangles[t]) {
        const Vector3d d = mesh_.points[v] - s.point;
        turn.push_back(angle(d, x, y));
        const double along = d.dot(s.axis);
        tube.push_back(std::atan2(along, (d - along * s.axis).norm() - s.radius));
      }
    }
    double middle = 0;
    bool fits = largestGap(turn, middle) > kMinGap;
    s.xdir = std::cos(middle) * x + std::sin(middle) * y;
    if (s.kind == CarrierKind::Torus) {
      fits = fits && largestGap(tube, middle) > kMinGap;
      s.tubeMid = middle + M_PI;
    }
    return fits;
  }

  // Reduces a closed profile to the part that the patch uses, with a margin at both ends. Returns
  // false if the patch leaves no gap.
  bool openProfile(Patch& patch) const {
    Carrier& s = patch.surface;
    const double period = s.profile->length(), from = s.profile->nodes().front().knot;
    std::vector<double> turn;
    for (const std::int32_t t : patch.triangles) {
      for (const std::int32_t v : mesh_.triangles[t]) {
        const double at = s.profile->foot(s.inProfile(mesh_.points[v])).t;
        turn.push_back(2 * M_PI * (at - from) / period);
      }
    }
    double middle = 0;
    const double gap = largestGap(turn, middle);
    if (gap <= kMinGap) return false;
    // Part of the gap stays unused, so that the ends do not meet.
    const double left = std::max(0.15 * gap, gap / 2 - kMinGap / 2);
    const auto inPeriod = [&](double angle) {
      const double turns = angle / (2 * M_PI);
      return from + period * (turns - std::floor(turns));
    };
    s.profile = std::make_shared<const Profile>(
        s.profile->opened(inPeriod(middle + left), inPeriod(middle - left)));
    return true;
  }

  bool placePoles(Patch& patch) const {
    Carrier& s = patch.surface;
    std::vector<Vector3d> directions;
    for (const std::int32_t t : patch.triangles) {
      for (const std::int32_t v : mesh_.triangles[t]) {
        directions.push_back((mesh_.points[v] - s.point).normalized());
      }
    }
    const std::size_t stride = std::max<std::size_t>(1, directions.size() / 3000);
    constexpr int kDirections = 200;
    double best = 1;
    for (int i = 0; i < kDirections; ++i) {
      const double z = (i + 0.5) / kDirections, phi = 2.399963229728653 * i;
      const double r = std::sqrt(1 - z * z);
      const Vector3d axis(r * std::cos(phi), r * std::sin(phi), z);
      double nearest = 0;
      for (std::size_t k = 0; k < directions.size(); k += stride) {
        nearest = std::max(nearest, std::abs(directions[k].dot(axis)));
      }
      if (nearest < best) {
        best = nearest;
        s.axis = axis;
      }
    }
    const Vector3d x = anyOrthogonal(s.axis), y = s.axis.cross(x);
    std::vector<double> turn;
    for (const Vector3d& d : directions) turn.push_back(angle(d, x, y));
    double middle = 0;
    const bool fits = largestGap(turn, middle) > kMinGap && best < 0.97;
    s.xdir = std::cos(middle) * x + std::sin(middle) * y;
    return fits;
  }

  // Returns the planes that may cut a patch on this surface, in the order of use.
  std::vector<Carrier> planesFor(std::int32_t p) const {
    const Patch& patch = partition_.patches[p];
    const Carrier& s = patch.surface;
    Vector3d mean = Vector3d::Zero();
    for (const std::int32_t t : patch.triangles) mean += mesh_.areaVector(t);
    Vector3d axis = s.axis;
    if (s.kind == CarrierKind::Sphere && mean.norm() > 1e-6 * mesh_.area) axis = mean.normalized();
    Carrier plane;
    plane.kind = CarrierKind::Plane;
    plane.point = s.point;
    std::vector<Carrier> planes;
    const Vector3d x = directionAwayFrom(cornersOf(p), s.point, axis);
    plane.axis = x;
    planes.push_back(plane);
    if (s.kind == CarrierKind::Sphere) {
      plane.axis = axis.cross(x);
      planes.push_back(plane);
    }
    const bool closedBothWays = s.kind == CarrierKind::Revolution && s.profile->isClosed();
    if (s.kind == CarrierKind::Sphere || s.kind == CarrierKind::Torus || closedBothWays) {
      plane.axis = axis;
      planes.push_back(plane);
    }
    return planes;
  }

  // Returns the vertices on the border of a patch where two other patches meet.
  std::vector<Vector3d> cornersOf(std::int32_t p) const {
    // pairs of a border vertex and the patch beyond
    std::vector<std::pair<std::int32_t, std::int32_t>> beside;
    for (const std::int32_t t : partition_.patches[p].triangles) {
      for (std::int32_t h = 3 * t; h < 3 * t + 3; ++h) {
        const std::int32_t other = partition_.patchOf[mesh_.opposite[h] / 3];
        if (other == p) continue;
        beside.emplace_back(mesh_.origin(h), other);
        beside.emplace_back(mesh_.target(h), other);
      }
    }
    std::sort(beside.begin(), beside.end());
    std::vector<Vector3d> corners;
    for (std::size_t i = 1; i < beside.size(); ++i) {
      if (beside[i].first == beside[i - 1].first && beside[i].second != beside[i - 1].second)
        corners.push_back(mesh_.points[beside[i].first]);
    }
    return corners;
  }

  // Returns the normal of the plane through `point` that stays farthest from the corners. The
  // normal is perpendicular to the axis. If a corner nearly lies on the cut, edges get shorter than
  // their tolerance. The tried angles start at 0.3 rad, so that the cut does not follow a row of
  // vertices.
  static Vector3d directionAwayFrom(const std::vector<Vector3d>& corners, const Vector3d& point,
                                    const Vector3d& axis) {
    constexpr int kDirections = 12;
    const Vector3d e1 = anyOrthogonal(axis), e2 = axis.cross(e1);
    Vector3d best = Vector3d::Zero();
    double farthest = -1;
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 0.3 + M_PI * i / kDirections;
      const Vector3d x = std::cos(angle) * e1 + std::sin(angle) * e2;
      double nearest = 1e300;
      for (const Vector3d& corner : corners)
        nearest = std::min(nearest, std::abs((corner - point).dot(x)));
      if (nearest <= farthest) continue;
      farthest = nearest;
      best = x;
    }
    return best;
  }

  void cut(std::int32_t first) {
    if (turnSeam(partition_.patches[first])) return;
    const std::int32_t surfaceId = partition_.patches[first].surfaceId;
    std::vector<std::int32_t> pieces{first};
    for (const Carrier& plane : planesFor(first)) {
      std::vector<std::int32_t> next;
      for (const std::int32_t p : pieces) {
        for (const std::int32_t q : halve(p, plane)) next.push_back(q);
      }
      partition_.cuts.push_back({surfaceId, plane});
      pieces.swap(next);
      bool fits = true;
      for (const std::int32_t p : pieces) fits = turnSeam(partition_.patches[p]) && fits;
      if (fits) return;
    }
  }

  // Splits a patch into connected pieces on either side of the plane. A very small piece joins the
  // other side. Returns the resulting patches.
  std::vector<std::int32_t> halve(std::int32_t p, const Carrier& plane) {
    const std::vector<std::int32_t> members = partition_.patches[p].triangles;
    side_.resize(mesh_.triangles.size());
    for (const std::int32_t t : members) side_[t] = plane.distance(centreOf(mesh_, t)) > 0;
    const auto collect = [&] {
      return connectedPieces(mesh_, members,
                             [&](std::int32_t a, std::int32_t b) { return side_[a] == side_[b]; });
    };
    std::vector<std::vector<std::int32_t>> pieces = collect();
    bool changed = false;
    for (const auto& piece : pieces) {
      if (piece.size() * 50 >= members.size()) continue;
      for (const std::int32_t t : piece) side_[t] = !side_[t];
      changed = true;
    }
    if (changed) pieces = collect();
    std::vector<std::int32_t> result;
    for (auto& piece : pieces) {
      std::int32_t target = p;
      if (!result.empty()) {
        target = static_cast<std::int32_t>(partition_.patches.size());
        const Patch copy{partition_.patches[p].surface, {}, 0, partition_.patches[p].surfaceId};
        partition_.patches.push_back(copy);
      }
      for (const std::int32_t t : piece) partition_.patchOf[t] = target;
      partition_.patches[target].triangles = std::move(piece);
      result.push_back(target);
    }
    return result;
  }

  const HalfEdgeMesh& mesh_;
  Partition& partition_;
  // by triangle of the patch that is being cut: 1 on the positive side of the plane
  std::vector<char> side_;
};

}  // namespace

void cutRoundPatches(const HalfEdgeMesh& mesh, Partition& partition) {
  Cutter(mesh, partition).cutAll();
}

}  // namespace swept::step
