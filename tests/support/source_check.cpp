// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/source_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "geometry/triangle_distance.h"
#include "motion/step_path.h"

namespace swept::test {
namespace {

using Eigen::Vector3d;
using Faces = std::array<std::int32_t, 2>;
constexpr double kNowhere = std::numeric_limits<double>::infinity();

struct ByPlace {
  bool operator()(const Vector3d& a, const Vector3d& b) const {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  }
};

double distanceToSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d edge = b - a;
  const double fraction = std::clamp((p - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  return (p - a - fraction * edge).norm();
}

/// The faces of a body and the edges between them. Vertices at the same position count as one; of
/// identical triangles, only the first counts.
class BodyFaces {
 public:
  explicit BodyFaces(const TriMesh& body) {
    std::vector<std::int32_t> faceOf = body.faceOf;
    if (faceOf.empty()) {
      faceOf.resize(body.triangles.size());
      std::iota(faceOf.begin(), faceOf.end(), 0);
    }
    using Places = std::array<Vector3d, 3>;
    using Ends = std::pair<Vector3d, Vector3d>;
    const auto before = [](const Ends& a, const Ends& b) {
      const ByPlace less;
      return less(a.first, b.first) || (!less(b.first, a.first) && less(a.second, b.second));
    };
    std::map<Ends, std::vector<std::int32_t>, decltype(before)> beside(before);
    const auto lower = [](const Places& a, const Places& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), ByPlace());
    };
    std::set<Places, decltype(lower)> seen(lower);
    for (std::size_t t = 0; t < body.triangles.size(); ++t) {
      std::array<Vector3d, 3> corner;
      for (int k = 0; k < 3; ++k) corner[k] = body.vertices[body.triangles[t][k]];
      if ((corner[1] - corner[0]).cross(corner[2] - corner[0]).norm() == 0) continue;
      std::array<Vector3d, 3> places = corner;
      std::sort(places.begin(), places.end(), ByPlace());
      if (!seen.insert(places).second) continue;
      triangles_[faceOf[t]].push_back(corner);
      for (int k = 0; k < 3; ++k) {
        Ends ends(corner[k], corner[(k + 1) % 3]);
        if (ByPlace()(ends.second, ends.first)) std::swap(ends.first, ends.second);
        beside[ends].push_back(faceOf[t]);
      }
    }
    for (auto& [ends, faces] : beside) {
      std::sort(faces.begin(), faces.end());
      edges_[faces.size() == 2 ? Faces{faces[0], faces[1]} : Faces{faces[0], -1}].push_back(ends);
    }
  }

  double distance(const Vector3d& p, SourceKind kind, const Faces& faces) const {
    double least = kNowhere;
    if (kind == SourceKind::Edge || faces[1] >= 0) {
      const auto found = edges_.find(faces);
      if (found == edges_.end()) return kNowhere;
      for (const auto& [a, b] : found->second) least = std::min(least, distanceToSegment(p, a, b));
      return least;
    }
    const auto found = triangles_.find(faces[0]);
    if (found == triangles_.end()) return kNowhere;
    for (const auto& [a, b, c] : found->second)
      least = std::min(least, std::sqrt(squaredDistance(p, a, b, c)));
    return least;
  }

 private:
  std::map<std::int32_t, std::vector<std::array<Vector3d, 3>>> triangles_;
  std::map<Faces, std::vector<std::pair<Vector3d, Vector3d>>> edges_;
};

/// Returns the pose at the time of a source; nothing if the time does not belong to its step.
std::optional<Pose> poseAt(const Trajectory& motion, const SurfaceSource& row) {
  const auto step = static_cast<std::size_t>(row.step);
  if (row.step < 0 || step >= motion.poses.size()) return std::nullopt;
  const Pose& from = motion.poses[step];
  if (row.kind == SourceKind::Cap) {
    if (row.timeSeconds != from.timeSeconds) return std::nullopt;
    return from;
  }
  // Poses that repeat the previous one do not end a step.
  std::size_t next = step + 1;
  while (next + 1 < motion.poses.size() && motion.poses[next].translation == from.translation &&
         motion.poses[next].rotation.coeffs() == from.rotation.coeffs()) {
    ++next;
  }
  if (next >= motion.poses.size()) return std::nullopt;
  Pose to = motion.poses[next];
  const double part = (row.timeSeconds - from.timeSeconds) / (to.timeSeconds - from.timeSeconds);
  if (!(part >= -1e-9 && part <= 1 + 1e-9)) return std::nullopt;
  if (from.rotation.dot(to.rotation) < 0) to.rotation.coeffs() *= -1;
  if (motion.interpolation == Interpolation::Screw)
    return StepPath(from, to, Interpolation::Screw).poseAt(part);
  // The pivot moves straight, and the body turns about it.
  Pose pose;
  pose.rotation = from.rotation.slerp(part, to.rotation);
  const Vector3d a = from.rotation * motion.pivot + from.translation,
                 b = to.rotation * motion.pivot + to.translation;
  pose.translation = a + part * (b - a) - pose.rotation * motion.pivot;
  return pose;
}

}  // namespace

std::vector<double> sourceDistances(const TriMesh& body, const Trajectory& motion,
                                    const Sources& sources) {
  const BodyFaces faces(body);
  std::vector<double> found;
  for (const std::uint32_t of : sources.of) {
    if (of == Sources::kNone) {
      found.push_back(-1);
      continue;
    }
    const SurfaceSource& row = (*sources.rows)[of];
    const std::optional<Pose> pose = poseAt(motion, row);
    found.push_back(
        pose ? faces.distance(pose->rotation.conjugate() * (row.point - pose->translation),
                              row.kind, row.faces)
             : kNowhere);
  }
  return found;
}

}  // namespace swept::test
