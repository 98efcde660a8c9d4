// Builds solids from given carriers and curves, to test whether the kernel accepts them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "judge/solid_judge.h"
#include "solid/kernel/brep.h"
#include "solid/kernel/kernel.h"
#include "solid/kernel/solid_file.h"
#include "solid/model/model.h"
#include "solid/text/step_text.h"

namespace swept::step {

class HandBuilt {
 public:
  std::int32_t vertex(const Eigen::Vector3d& p) {
    model_.vertices.push_back({p, 0});
    return static_cast<std::int32_t>(model_.vertices.size()) - 1;
  }
  /// Adds an edge. The curve must run from one vertex to the other.
  std::int32_t edge(std::int32_t from, std::int32_t to, const Curve& curve) {
    largestGap_ = std::max({largestGap_, (curve.at(0) - model_.vertices[from].point).norm(),
                            (curve.at(curve.last) - model_.vertices[to].point).norm()});
    model_.edges.push_back({from, to, curve, 0});
    return static_cast<std::int32_t>(model_.edges.size()) - 1;
  }
  std::int32_t line(std::int32_t from, std::int32_t to) {
    return edge(from, to, lineThrough(model_.vertices[from].point, model_.vertices[to].point));
  }
  /// Adds a face with one loop of edges in order. Turns the carrier and the loop so that they fit
  /// to `outward`, a direction out of the solid near the middle of the face.
  void face(Carrier carrier, const std::vector<std::int32_t>& edges,
            const Eigen::Vector3d& outward) {
    std::vector<ModelUse> loop;
    const auto& first = model_.edges[edges[0]];
    const auto& second = model_.edges[edges[1]];
    std::int32_t at =
        first.end == second.start || first.end == second.end ? first.start : first.end;
    // A loop of two edges may begin with either; its first one then runs forward.
    if (edges.size() == 2) at = first.start;
    Eigen::Vector3d area = Eigen::Vector3d::Zero(), middle = area, before = area;
    const Eigen::Vector3d base = model_.vertices[at].point;
    int count = 0;
    for (const std::int32_t e : edges) {
      const ModelEdge& edge = model_.edges[e];
      const bool forward = edge.start == at;
      isClosed_ = isClosed_ && (forward || edge.end == at);
      loop.push_back({e, forward});
      at = forward ? edge.end : edge.start;
      for (int k = 0; k <= 20; ++k) {
        const double fraction = forward ? k / 20.0 : 1 - k / 20.0;
        const Eigen::Vector3d p = edge.curve.at(fraction * edge.curve.last);
        largestGap_ = std::max(largestGap_, std::abs(carrier.distance(p)));
        area += (before).cross(p - base);
        before = p - base;
        middle += p;
        ++count;
      }
    }
    if (area.dot(outward) < 0) {
      std::reverse(loop.begin(), loop.end());
      for (ModelUse& use : loop) use.forward = !use.forward;
    }
    middle /= count;
    if (carrier.normal(middle).dot(outward) < 0) {
      if (carrier.isPlanar()) {
        carrier.axis = -carrier.axis;
      } else {
        carrier.reversed = !carrier.reversed;
      }
    }
    ModelFace made;
    made.surface = carrier;
    made.loops.push_back(loop);
    model_.faces.push_back(made);
  }
  /// Returns how far (mm) sampled points of edges lie from their faces, and edges from their
  /// vertices.
  double largestGap() const { return largestGap_; }
  bool isClosed() const { return isClosed_; }

  std::string text() {
    model_.shellOwner = {0};
    std::ostringstream out;
    RunContext run;
    writeStepText(model_, out, "hand built", SolidOptions(), run);
    return out.str();
  }
  /// Judges the solid as the kernel reads it from the text.
  test::JudgedSolid judge(bool withBlock) {
    RunContext run;
    KernelSession kernel;
    std::istringstream in(text());
    return test::judgeSolid(readStepText(in, kernel, run), 9, withBlock);
  }
  /// Judges the solid as the kernel makes it from the model, with parameter curves.
  test::JudgedSolid judgeMade() {
    model_.shellOwner = {0};
    RunContext run;
    KernelSession kernel;
    const Brep made = buildBrep(model_, run);
    failed_ = made.failed.size();
    return test::judgeSolid(made.shape, 9, false);
  }
  std::size_t failed() const { return failed_; }
  const Model& model() const { return model_; }

 private:
  Model model_;
  double largestGap_ = 0;
  bool isClosed_ = true;
  std::size_t failed_ = 0;  // faces that the kernel could not make
};

}  // namespace swept::step
