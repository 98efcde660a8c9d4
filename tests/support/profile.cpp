// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/profile.h"

#include <algorithm>
#include <cmath>

namespace swept::test {
namespace {

using V2 = Eigen::Vector2d;

V2 onCircle(const V2& centre, double radius, double angle) {
  return centre + radius * V2(std::cos(angle), std::sin(angle));
}

double cross(const V2& a, const V2& b) { return a.x() * b.y() - a.y() * b.x(); }

double distanceToPiece(const ProfilePiece& piece, const V2& p) {
  if (!piece.arc) {
    const V2 d = piece.to - piece.from;
    const double t = std::clamp((p - piece.from).dot(d) / d.squaredNorm(), 0.0, 1.0);
    return (piece.from + t * d - p).norm();
  }
  const V2 d = p - piece.centre;
  double turn = std::atan2(d.y(), d.x()) - piece.startAngle;
  if (piece.sweepAngle < 0) turn = -turn;
  turn = std::fmod(turn, 2 * M_PI);
  if (turn < 0) turn += 2 * M_PI;
  if (turn <= std::abs(piece.sweepAngle)) return std::abs(d.norm() - piece.radius);
  return std::min((p - piece.from).norm(), (p - piece.to).norm());
}

/// Returns the signed angle (rad) under which the piece is seen from p: that of its chord, plus or
/// minus a full turn if p lies between chord and arc.
double turnSeenFrom(const ProfilePiece& piece, const V2& p) {
  const V2 a = piece.from - p, b = piece.to - p;
  double turn = (a - b).norm() > 1e-12 ? std::atan2(cross(a, b), a.dot(b)) : 0;
  if (piece.arc && (p - piece.centre).norm() < piece.radius) {
    const bool whole = std::abs(piece.sweepAngle) > 2 * M_PI - 1e-9;
    const double side = cross(piece.to - piece.from, p - piece.from);
    if (piece.sweepAngle > 0 && (whole || side < 0)) turn += 2 * M_PI;
    if (piece.sweepAngle < 0 && (whole || side > 0)) turn -= 2 * M_PI;
  }
  return turn;
}

V2 direction(const ProfilePiece& piece, bool atEnd) {
  if (!piece.arc) return (piece.to - piece.from).normalized();
  const double angle = piece.startAngle + (atEnd ? piece.sweepAngle : 0);
  return V2(-std::sin(angle), std::cos(angle)) * (piece.sweepAngle > 0 ? 1 : -1);
}

}  // namespace

void Profile::line(const V2& from, const V2& to) {
  pieces_.push_back({from, to, false, V2::Zero(), 0, 0, 0});
}

void Profile::polygon(const std::vector<V2>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    line(corners[i], corners[(i + 1) % corners.size()]);
}

void Profile::arc(const V2& centre, double radius, double startAngle, double sweepAngle) {
  pieces_.push_back({onCircle(centre, radius, startAngle),
                     onCircle(centre, radius, startAngle + sweepAngle), true, centre, radius,
                     startAngle, sweepAngle});
}

double Profile::area() const {
  double sum = 0;
  for (const auto& piece : pieces_) {
    sum += cross(piece.from, piece.to) / 2;
    if (piece.arc) {
      sum += piece.radius * piece.radius * (piece.sweepAngle - std::sin(piece.sweepAngle)) / 2;
    }
  }
  return sum;
}

double Profile::length() const {
  double sum = 0;
  for (const auto& piece : pieces_) {
    sum += piece.arc ? piece.radius * std::abs(piece.sweepAngle) : (piece.to - piece.from).norm();
  }
  return sum;
}

double Profile::signedDistance(const V2& p) const {
  double distance = 1e300, turn = 0;
  for (const auto& piece : pieces_) {
    distance = std::min(distance, distanceToPiece(piece, p));
    turn += turnSeenFrom(piece, p);
  }
  return turn > M_PI ? -distance : distance;
}

std::vector<V2> Profile::points(double spacing) const {
  std::vector<V2> result;
  for (const auto& piece : pieces_) {
    const double length =
        piece.arc ? piece.radius * std::abs(piece.sweepAngle) : (piece.to - piece.from).norm();
    const int steps = std::max(1, static_cast<int>(std::ceil(length / spacing)));
    for (int i = 0; i < steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      result.push_back(
          piece.arc ? onCircle(piece.centre, piece.radius, piece.startAngle + piece.sweepAngle * t)
                    : V2(piece.from + t * (piece.to - piece.from)));
    }
  }
  return result;
}

std::vector<V2> Profile::corners() const {
  std::vector<V2> result;
  for (const auto& piece : pieces_) {
    for (const auto& other : pieces_) {
      if ((piece.to - other.from).norm() > 1e-9) continue;
      if (direction(piece, true).dot(direction(other, false)) < std::cos(10 * M_PI / 180)) {
        result.push_back(piece.to);
      }
    }
  }
  return result;
}

void Profile::extrude(double z0, double z1, double spacing, Truth& truth) const {
  const Profile copy = *this;
  truth.distance = [copy, z0, z1](const Eigen::Vector3d& p) {
    const double side = copy.signedDistance(p.head<2>());
    const double cap = std::max(z0 - p.z(), p.z() - z1);
    if (side <= 0 && cap <= 0) return -std::max(side, cap);
    return std::hypot(std::max(side, 0.0), std::max(cap, 0.0));
  };
  truth.volume = area() * (z1 - z0);
  truth.area = 2 * area() + length() * (z1 - z0);
  const int layers = std::max(1, static_cast<int>(std::ceil((z1 - z0) / spacing)));
  Eigen::Vector2d low(1e300, 1e300), high(-1e300, -1e300);
  for (const V2& p : points(spacing)) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    for (int k = 0; k <= layers; ++k) {
      truth.surface.emplace_back(p.x(), p.y(), z0 + (z1 - z0) * k / layers);
    }
    truth.creases.emplace_back(p.x(), p.y(), z0);
    truth.creases.emplace_back(p.x(), p.y(), z1);
  }
  for (const V2& p : corners()) {
    for (int k = 0; k <= layers; ++k) {
      truth.creases.emplace_back(p.x(), p.y(), z0 + (z1 - z0) * k / layers);
    }
  }
  for (double x = low.x() + spacing / 2; x < high.x(); x += spacing) {
    for (double y = low.y() + spacing / 2; y < high.y(); y += spacing) {
      if (signedDistance({x, y}) > 0) continue;
      truth.surface.emplace_back(x, y, z0);
      truth.surface.emplace_back(x, y, z1);
    }
  }
}

}  // namespace swept::test
