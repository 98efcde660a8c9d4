// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/body_motion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "solid/sweep/contact.h"

namespace swept::step {

using Eigen::Vector2d;
using Eigen::Vector3d;

BodyMotion::BodyMotion(const BodyGeometry& body, const StepPath& path) : body_(body), path_(path) {
  constexpr int kChords = 16;
  for (int v = 0; v < body.vertices.Extent(); ++v) {
    double travel = 0;
    for (int i = 0; i < kChords; ++i)
      travel += (at(body.point(v), (i + 1.0) / kChords) -
                 at(body.point(v), static_cast<double>(i) / kChords))
                    .norm();
    length_ = std::max(length_, travel);
    shortest_ = std::min(shortest_, travel);
  }
  for (std::size_t f = 0; f < body.faces.size(); ++f)
    slides_.push_back(isSliding(static_cast<int>(f)));
}

double BodyMotion::speedOf(const BodyEdge& edge, int f, double u, double s) const {
  return body_.normalAt(edge, f, u).dot(Moment(path_, s).velocityAt(edge.at(u)));
}

OfTwo BodyMotion::speedOn(const BodyEdge& edge, int f) const {
  return [this, &edge, f](const Vector2d& on) { return speedOf(edge, f, on[0], on[1]); };
}

double BodyMotion::noSpeed() const { return kNoSpeed * length_; }

bool BodyMotion::isContact(const BodyEdge& edge, int f, double u, Range s) const {
  constexpr int kTimes = 16;
  for (int i = 0; i <= kTimes; ++i) {
    if (std::abs(speedOf(edge, f, u, s.at(static_cast<double>(i) / kTimes))) > noSpeed())
      return false;
  }
  return true;
}

std::vector<ZeroArc> BodyMotion::contactsOf(const BodyEdge& edge, int f, Range s) const {
  constexpr double kInside = 1e-6;  // of the range
  if (slides_[f]) return {};
  const Vector2d scale(edge.scale, length_);
  // An end of the edge may be a point of contact all the time. Rounding errors then decide on which
  // side of the end the zeros lie.
  const std::array<double, 2> ends{edge.range.from, edge.range.to};
  const std::array<bool, 2> areContacts{isContact(edge, f, ends[0], s),
                                        isContact(edge, f, ends[1], s)};
  if (areContacts[0] && areContacts[1] && isContact(edge, f, edge.range.at(0.5), s)) return {};
  Range inner = edge.range;
  if (areContacts[0]) inner.from += kInside * edge.range.length();
  if (areContacts[1]) inner.to -= kInside * edge.range.length();
  const OfTwo speed = speedOn(edge, f);
  std::vector<ZeroArc> arcs = zeroArcs(speed, inner, s, scale);
  for (const int k : {0, 1}) {
    if (!areContacts[k]) continue;
    const std::vector<Vector2d> points{Vector2d(ends[k], s.from).cwiseProduct(scale),
                                       Vector2d(ends[k], s.to).cwiseProduct(scale)};
    arcs.emplace_back(speed, scale, Vector2d(0, 1), points);
  }
  return arcs;
}

bool BodyMotion::doesTurn() const { return Moment(path_, 0).angular.norm() > kNoSpeed; }

// Returns whether a face moves only along itself.
bool BodyMotion::isSliding(int f) const {
  constexpr int kPoints = 4;
  for (const int e : body_.faces[f].edges) {
    const BodyEdge& edge = body_.edges[e];
    for (int j = 0; j <= kPoints; ++j) {
      if (!isContact(edge, f, edge.range.at(static_cast<double>(j) / kPoints), {0, 1}))
        return false;
    }
  }
  return true;
}

bool BodyMotion::isOutline(const BodyEdge& edge) const {
  constexpr int kTimes = 128, kPoints = 16;
  if (slidesAt(edge)) return false;
  for (int i = 0; i <= kTimes; ++i) {
    const double s = static_cast<double>(i) / kTimes;
    for (int j = 0; j <= kPoints; ++j) {
      const double u = edge.range.at(static_cast<double>(j) / kPoints);
      const double a = speedOf(edge, edge.faces[0], u, s), b = speedOf(edge, edge.faces[1], u, s);
      if (std::min(a, b) < -noSpeed() && std::max(a, b) > noSpeed()) return true;
    }
  }
  // The edge may be an outline only in a strip between two curves of contact, which samples miss.
  for (const int k : {0, 1}) {
    const OfTwo other = speedOn(edge, edge.faces[1 - k]);
    for (const ZeroArc& arc : contactsOf(edge, edge.faces[k], {0, 1})) {
      if (std::abs(other(arc.at(arc.range().at(0.5)))) > noSpeed()) return true;
    }
  }
  return false;
}

std::optional<Vector3d> BodyMotion::planeOf(const BodyEdge& edge) const {
  constexpr int kTimes = 16;
  constexpr double kNoTurn = 1e-6, kFlat = 1e-9;  // the latter times the length of the step
  if (!edge.isStraight) return std::nullopt;
  const auto end = [&](double u, int i) { return at(edge.at(u), static_cast<double>(i) / kTimes); };
  const auto along = [&](int i) -> Vector3d {
    return (end(edge.range.to, i) - end(edge.range.from, i)).normalized();
  };
  const Vector3d turned = along(0).cross(along(kTimes / 2));
  if (turned.norm() < kNoTurn) return std::nullopt;
  const Vector3d normal = turned.normalized();
  for (int i = 1; i <= kTimes; ++i) {
    for (const double u : {edge.range.from, edge.range.to}) {
      if (std::abs(normal.dot(end(u, i) - end(u, 0))) > kFlat * length_) return std::nullopt;
    }
  }
  return normal;
}

std::vector<double> BodyMotion::pinchesOf(const BodyEdge& edge) const {
  std::vector<double> times;
  const OfTwo other = speedOn(edge, edge.faces[1]);
  for (const ZeroArc& arc : contactsOf(edge, edge.faces[0], {0, 1})) {
    for (const double t : zerosOf([&](double x) { return other(arc.at(x)); }, arc.range()))
      times.push_back(arc.at(t).y());
  }
  return times;
}

}  // namespace swept::step
