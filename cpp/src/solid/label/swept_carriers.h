// Makes the surfaces of the sweep of a body that moves in straight lines, without turning: the
// body's faces at each pose, the surfaces that its edges sweep, and those that contact curves
// sweep. A contact curve of a face consists of the points whose normal is perpendicular to the
// motion.
// In:      BodyShape, trajectory.
// Out:     carriers, each with the curves and points where others meet it: edges and corners of the
//          body at poses, contact curves at poses, paths of points.
// Units:   mm.
// Cost:    O(edges of the body) per motion step.
// Source:  envelopes of moving solids: Abdel-Malek, Blackmore and Joy 2006.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "solid/carrier/traces.h"
#include "solid/label/body_shape.h"
#include "swept/sources.h"
#include "swept/types.h"

namespace swept::step {

class SweptCarriers {
 public:
  /// `extension` (mm): a surface that an edge sweeps is extended by this length at its borders.
  SweptCarriers(const BodyShape& body, const Trajectory& trajectory, double extension);

  /// Returns the numbers of the carriers on which triangles of this source may lie, and makes them
  /// if needed. Returns none if no carrier of a known kind is possible.
  const std::vector<std::int32_t>& carriersOf(const SurfaceSource& source);

  /// Carriers by number. Their traces are complete only after finish().
  const std::vector<Carrier>& carriers() const { return carriers_; }
  void finish();

 private:
  struct Placement {
    Eigen::Matrix3d rotation;
    Eigen::Vector3d shift;
    Eigen::Vector3d operator()(const Eigen::Vector3d& p) const { return rotation * p + shift; }
  };
  using Label = std::tuple<int, std::int32_t, std::int32_t, std::int32_t>;
  enum class Made { Cap, Edge, Graze };

  Placement placementAt(std::int32_t pose) const;
  bool isStraight(std::int32_t step) const;
  Eigen::Vector3d directionInBody(std::int32_t step) const;
  const std::vector<std::int32_t>& made(Made what, std::int32_t element, std::int32_t step);
  void addCap(std::int32_t face, std::int32_t pose, std::vector<std::int32_t>& to);
  void addSwept(std::int32_t edge, std::int32_t step, std::vector<std::int32_t>& to);
  void addGraze(std::int32_t face, std::int32_t step, std::vector<std::int32_t>& to);
  void sweepCurve(const Curve& curve, std::int32_t step, std::vector<std::int32_t>& to,
                  const Traces& traces);
  std::vector<Eigen::Vector3d> contactsOn(std::int32_t edge, std::int32_t face,
                                          const Eigen::Vector3d& direction) const;
  void tracePoints(const std::vector<Eigen::Vector3d>& points, std::int32_t step,
                   Traces& traces) const;
  void traceEdge(const BodyEdge& edge, const Placement& placement, Traces& traces) const;
  std::int32_t add(const Carrier& carrier, const Traces& traces);

  const BodyShape& body_;
  const Trajectory& trajectory_;
  double extension_;
  std::vector<Carrier> carriers_;
  std::vector<Traces> traces_;
  std::map<Label, std::vector<std::int32_t>> known_;
  std::map<std::tuple<int, std::int32_t, std::int32_t>, std::vector<std::int32_t>> made_;
};

}  // namespace swept::step
