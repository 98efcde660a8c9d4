// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/cover.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "geometry/mesh_parts.h"
#include "geometry/shells.h"
#include "motion/step_path.h"
#include "sampling/culling/face_clusters.h"
#include "sampling/culling/swept_elements.h"

namespace swept::offset {
namespace {

// Patches are cut into pieces that deviate from flat triangles by at most this (cells).
constexpr double kTwist = 0.005;
constexpr int kMaxParts = 256;

/// Data of a motion step, from which the slack of the faces at its start and end is computed.
struct Step {
  Placement from, to;  // from body coordinates (mm) to grid coordinates (cells)
  double turn = 0;     // rad, an upper bound
  double slack(double displacement) const { return turn * displacement / 4; }
};

class MotionCover {
 public:
  MotionCover(const SamplerInput& input, const FaceClusters& clusters)
      : input_(input), before_(input, clusters), after_(input, clusters) {}

  void cover(std::size_t begin, std::size_t end, std::vector<CoverTriangle>& out, RunContext& run) {
    const std::size_t steps = input_.motion.steps();
    if (begin > 0) {
      before_.setStep(begin - 1);
      stepBefore_ = step(begin - 1);
    }
    for (std::size_t k = begin; k < end; ++k) {
      run.checkpoint(Phase::Sampling, k, steps + 1);
      if (k < steps) {
        after_.setStep(k);
        stepAfter_ = step(k);
      }
      faces(k, out);
      if (k < steps) patches(out);
      std::swap(before_, after_);
      stepBefore_ = stepAfter_;
    }
  }

 private:
  Step step(std::size_t k) const {
    Step s{input_.grid.toGrid(input_.motion.placements[k]),
           input_.grid.toGrid(input_.motion.placements[k + 1]), 0};
    const Eigen::Matrix3d bend =
        (s.from.rotation.transpose() * s.to.rotation) * (input_.grid.cell * input_.grid.cell) -
        Eigen::Matrix3d::Identity();
    s.turn = bend.norm() / std::sqrt(2.0) * 1.01;
    return s;
  }
  double displacement(const Step& s, const std::array<std::int32_t, 3>& t) const {
    double most = 0;
    for (const std::int32_t v : t) {
      const auto& p = input_.body.vertices[v];
      most = std::max(most, (s.to.apply(p) - s.from.apply(p)).norm());
    }
    return most;
  }

  void faces(std::size_t k, std::vector<CoverTriangle>& out) const {
    const bool hasBefore = k > 0, hasAfter = k < input_.motion.steps();
    const Placement at = input_.grid.toGrid(input_.motion.placements[k]);
    const auto time = static_cast<float>(at.timeSeconds);
    for (std::size_t f = 0; f < input_.body.triangles.size(); ++f) {
      const int before = hasBefore ? before_.ofFace(f) : 1,
                after = hasAfter ? after_.ofFace(f) : -1;
      const bool mixedBefore = hasBefore && before == 0, mixedAfter = hasAfter && after == 0;
      if (input_.cull && !mixedBefore && !mixedAfter &&
          faceIsEnclosed(before, after, hasBefore, hasAfter, input_.orientable)) {
        continue;
      }
      const auto& t = input_.body.triangles[f];
      double slack = 0;
      if (mixedBefore) slack = stepBefore_.slack(displacement(stepBefore_, t));
      if (mixedAfter) slack = std::max(slack, stepAfter_.slack(displacement(stepAfter_, t)));
      const auto& v = input_.body.vertices;
      out.push_back({{at.apply(v[t[0]]), at.apply(v[t[1]]), at.apply(v[t[2]])},
                     {time, time, time},
                     static_cast<float>(slack * 1.001)});
    }
  }

  void patches(std::vector<CoverTriangle>& out) const {
    const Step& s = stepAfter_;
    const auto early = static_cast<float>(s.from.timeSeconds),
               late = static_cast<float>(s.to.timeSeconds);
    for (const BodyEdge& e : input_.topology.edges) {
      if (input_.cull && patchIsEnclosed(e, after_)) continue;
      const auto &va = input_.body.vertices[e.a], &vb = input_.body.vertices[e.b];
      const Eigen::Vector3d a = s.from.apply(va), b = s.from.apply(vb), c = s.to.apply(vb),
                            d = s.to.apply(va);
      const double twist = ((c - d) - (b - a)).norm() / 4;
      const int parts = std::clamp(static_cast<int>(twist / kTwist) + 1, 1, kMaxParts);
      const auto slack = static_cast<float>(twist / parts * 1.001);
      for (int part = 0; part < parts; ++part) {
        const double r = static_cast<double>(part) / parts, q = (part + 1.0) / parts;
        const Eigen::Vector3d a0 = a + r * (b - a), b0 = a + q * (b - a), a1 = d + r * (c - d),
                              b1 = d + q * (c - d);
        out.push_back({{a0, b0, b1}, {early, early, late}, slack});
        out.push_back({{a0, b1, a1}, {early, late, late}, slack});
      }
    }
  }

  const SamplerInput& input_;
  FaceDirections before_, after_;
  Step stepBefore_, stepAfter_;
};

/// Returns how far the true motion deviates from the chords, in cells.
double chordOf(const SamplerInput& input) {
  const Eigen::AlignedBox3d box = boxOf(input.body);
  double most = input.motion.mergeError;
  for (std::size_t k = 0; k < input.motion.steps(); ++k) {
    most = std::max(most, arcOf(input.motion, k, box));
  }
  return most / input.grid.cell;
}

void coverCopies(const SamplerInput& input, std::size_t k, CoverTriangle* out) {
  const Placement p = input.grid.toGrid(input.motion.placements[k]);
  const auto time = static_cast<float>(p.timeSeconds);
  for (const auto& t : input.body.triangles) {
    const auto& v = input.body.vertices;
    *out++ = {{p.apply(v[t[0]]), p.apply(v[t[1]]), p.apply(v[t[2]])}, {time, time, time}, 0};
  }
}

/// Cuts long triangles. The bounding box of a long oblique triangle is nearly empty, so searches
/// would often test such a triangle in vain.
void cutLong(std::vector<CoverTriangle>& triangles) {
  constexpr double kLong = 6;  // cells: triangles with longer sides are cut
  // Largest number of pieces: this many times the number of triangles, plus a million.
  constexpr double kMaxPieces = 3;
  const auto longest = [](const CoverTriangle& t) {
    int best = 0;
    double length = -1;
    for (int k = 0; k < 3; ++k) {
      const double l = (t.corner[(k + 1) % 3] - t.corner[k]).squaredNorm();
      if (l > length) {
        length = l;
        best = k;
      }
    }
    return std::pair(best, length);
  };
  double limit = kLong * kLong;
  const auto pieces = [&] {
    double sum = 0;
    for (const CoverTriangle& t : triangles) {
      const double area = (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]).norm() / 2;
      const double length = longest(t).second;
      if (length > limit) sum += 4 * area / limit + 2 * std::sqrt(length / limit);
    }
    return sum;
  };
  const double most = kMaxPieces * static_cast<double>(triangles.size()) + 1e6;
  while (pieces() > most) limit *= 2;
  std::vector<std::size_t> todo;
  const std::size_t count = triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    todo.assign(1, i);
    while (!todo.empty()) {
      const std::size_t at = todo.back();
      const auto [edge, length] = longest(triangles[at]);
      todo.pop_back();
      if (length <= limit) continue;
      const int next = (edge + 1) % 3;
      CoverTriangle second = triangles[at];
      const Eigen::Vector3d middle = (second.corner[edge] + second.corner[next]) / 2;
      const float time = (second.timeSeconds[edge] + second.timeSeconds[next]) / 2;
      second.corner[edge] = triangles[at].corner[next] = middle;
      second.timeSeconds[edge] = triangles[at].timeSeconds[next] = time;
      todo.push_back(at);
      todo.push_back(triangles.size());
      triangles.push_back(second);
    }
  }
}

}  // namespace

std::size_t triangleCopies(const SamplerInput& input) {
  if (input.motion.continuous) return 0;
  return input.body.triangles.size() * input.motion.placements.size();
}

Cover coverOfMotion(const SamplerInput& input, bool widened, RunContext& run) {
  Cover cover;
  const std::size_t placements = input.motion.placements.size();
  // One vertex for each connected piece of the body.
  std::vector<std::int32_t> roots = smallestJoinedVertices(input.body);
  sortUnique(roots);
  const auto addInside = [&](std::size_t k) {
    const Placement p = input.grid.toGrid(input.motion.placements[k]);
    for (const std::int32_t v : roots) cover.inside.push_back(p.apply(input.body.vertices[v]));
  };
  if (!input.motion.continuous) {
    const std::size_t faces = input.body.triangles.size();
    cover.triangles.resize(triangleCopies(input));
    parallelFor(placements, [&](std::size_t k) {
      run.checkpoint(Phase::Sampling, k, placements);
      coverCopies(input, k, cover.triangles.data() + k * faces);
    });
    for (std::size_t k = 0; k < placements; ++k) addInside(k);
    cutLong(cover.triangles);
    return cover;
  }
  addInside(0);
  cover.chord = chordOf(input);
  const FaceClusters clusters = buildClusters(input.body, input.topology);
  const std::size_t group = std::max<std::size_t>(1, placements / 64);
  const std::size_t groups = (placements + group - 1) / group;
  cover.triangles =
      gather<CoverTriangle>(groups, 1, [&](std::size_t g, std::vector<CoverTriangle>& part) {
        const std::size_t begin = g * group, end = std::min(begin + group, placements);
        MotionCover(input, clusters).cover(begin, end, part, run);
      });
  cutLong(cover.triangles);
  for (CoverTriangle& t : cover.triangles) {
    cover.largestSlack = std::max(cover.largestSlack, static_cast<double>(t.slack));
    if (!widened) t.slack = 0;
  }
  return cover;
}

Cover coverOfMesh(const TriMesh& mesh, const std::vector<double>& contactTime,
                  const GridPlan& grid) {
  Cover cover;
  cover.triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    CoverTriangle c;
    for (int k = 0; k < 3; ++k) {
      c.corner[k] = (mesh.vertices[t[k]] - grid.origin) / grid.cell;
      if (!contactTime.empty()) c.timeSeconds[k] = static_cast<float>(contactTime[t[k]]);
    }
    cover.triangles.push_back(c);
  }
  return cover;
}

}  // namespace swept::offset
