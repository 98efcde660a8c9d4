// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/sweep/rails.h"

#include <cmath>

namespace swept::step {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// The coordinate frame of a carrier, with z along its axis.
struct Frame {
  explicit Frame(const Carrier& face)
      : z(face.axis), x(face.xdir.norm() > 0.5 ? face.xdir : anyOrthogonal(face.axis)) {
    y = z.cross(x);
  }
  Vector3d out(double angle) const { return std::cos(angle) * x + std::sin(angle) * y; }
  double angleOf(const Vector3d& d) const { return std::atan2(d.dot(y), d.dot(x)); }
  Vector3d z, x, y;
};

// The rails of a plane: lines perpendicular to the line of contact.
class PlaneRails : public Rails {
 public:
  PlaneRails(const Carrier& face, const Vector3d& along)
      : face_(face), along_(along), across_(face.axis.cross(along)) {}
  Point at(double w, double v) const override {
    return {face_.point + w * along_ + v * across_, face_.axis};
  }
  Vector2d parametersOf(const Vector3d& p) const override {
    return {(p - face_.point).dot(along_), (p - face_.point).dot(across_)};
  }

 private:
  Carrier face_;
  Vector3d along_, across_;
};

// The rails of cylinders, cones and revolutions: w is the height (or the parameter of the profile),
// v is the angle. The rails of tori: w is the angle around the tube, v is the angle about the axis.
class RoundRails : public Rails {
 public:
  explicit RoundRails(const Carrier& face) : face_(face), frame_(face) {}
  Point at(double w, double v) const override {
    const Vector3d out = frame_.out(v);
    const double side = face_.reversed ? -1 : 1;
    const auto point = [&](double r, double h, double nr, double nh) {
      return Point{face_.point + r * out + h * frame_.z, side * (nr * out + nh * frame_.z)};
    };
    if (face_.kind == CarrierKind::Cylinder) return point(face_.radius, w, 1, 0);
    if (face_.kind == CarrierKind::Cone) {
      return point(face_.radius + w * face_.sine / face_.cosine, w, face_.cosine, -face_.sine);
    }
    if (face_.kind == CarrierKind::Torus) {
      const double c = std::cos(w), s = std::sin(w);
      return point(face_.radius + face_.minor * c, face_.minor * s, c, s);
    }
    Vector2d first, second;
    face_.profile->derivatives(w, first, second);
    const Vector2d q = face_.profile->at(w), tangent = first.normalized();
    return point(q.x(), q.y(), tangent.y(), -tangent.x());
  }
  Vector2d parametersOf(const Vector3d& p) const override {
    const Vector3d d = p - face_.point;
    const double angle = frame_.angleOf(d), height = d.dot(frame_.z);
    if (face_.kind == CarrierKind::Torus) {
      return {std::atan2(height, (d - height * frame_.z).norm() - face_.radius), angle};
    }
    if (face_.kind == CarrierKind::Revolution)
      return {face_.profile->foot(face_.inProfile(p)).t, angle};
    return {height, angle};
  }
  std::array<double, 2> periods() const override {
    return {face_.kind == CarrierKind::Torus ? 2 * M_PI : 0, 2 * M_PI};
  }
  bool covers(double w, double) const override {
    return face_.kind != CarrierKind::Revolution || face_.profile->isClosed() ||
           face_.profile->covers(face_.profile->at(w));
  }

 private:
  Carrier face_;
  Frame frame_;
};

// The rails of extrusions: w is the length along the direction, v is the parameter of the profile.
class ExtrusionRails : public Rails {
 public:
  explicit ExtrusionRails(const Carrier& face) : face_(face), frame_(face) {}
  Point at(double w, double v) const override {
    Vector2d first, second;
    face_.profile->derivatives(v, first, second);
    const Vector2d q = face_.profile->at(v), tangent = first.normalized();
    const double side = face_.reversed ? -1 : 1;
    return {face_.point + q.x() * frame_.x + q.y() * frame_.y + w * frame_.z,
            side * (tangent.y() * frame_.x - tangent.x() * frame_.y)};
  }
  Vector2d parametersOf(const Vector3d& p) const override {
    return {(p - face_.point).dot(frame_.z), face_.profile->foot(face_.inProfile(p)).t};
  }
  bool covers(double, double v) const override {
    return face_.profile->isClosed() || face_.profile->covers(face_.profile->at(v));
  }

 private:
  Carrier face_;
  Frame frame_;
};

class SheetRails : public Rails {
 public:
  explicit SheetRails(const Carrier& face) : face_(face) {}
  Point at(double w, double v) const override {
    const Sheet::Foot foot = face_.sheet->footAt(w, v);
    return {foot.at, face_.reversed ? Vector3d(-foot.normal()) : foot.normal()};
  }
  Vector2d parametersOf(const Vector3d& p) const override {
    const Sheet::Foot foot = face_.sheet->foot(p);
    return {foot.u, foot.t};
  }
  bool covers(double w, double v) const override {
    const Range u = face_.sheet->knotsU().range(), t = face_.sheet->knotsT().range();
    return w >= u.from && w <= u.to && v >= t.from && v <= t.to;
  }

 private:
  Carrier face_;
};

// The second set of rails: w and v are exchanged.
class Crossed : public Rails {
 public:
  explicit Crossed(std::unique_ptr<const Rails> rails) : rails_(std::move(rails)) {}
  Point at(double w, double v) const override { return rails_->at(v, w); }
  Vector2d parametersOf(const Vector3d& p) const override {
    return rails_->parametersOf(p).reverse();
  }
  std::array<double, 2> periods() const override {
    const auto [w, v] = rails_->periods();
    return {v, w};
  }
  bool covers(double w, double v) const override { return rails_->covers(v, w); }

 private:
  std::unique_ptr<const Rails> rails_;
};

}  // namespace

std::unique_ptr<const Rails> railsOf(const Carrier& face, bool crossed, const Vector3d& direction) {
  std::unique_ptr<const Rails> rails;
  switch (face.kind) {
    case CarrierKind::Facet:
    case CarrierKind::Plane:
      return std::make_unique<PlaneRails>(face, direction);
    case CarrierKind::Cylinder:
    case CarrierKind::Cone:
    case CarrierKind::Torus:
    case CarrierKind::Revolution:
      rails = std::make_unique<RoundRails>(face);
      break;
    case CarrierKind::Extrusion:
      rails = std::make_unique<ExtrusionRails>(face);
      break;
    case CarrierKind::Sheet:
      rails = std::make_unique<SheetRails>(face);
      break;
    case CarrierKind::Sphere:
      return nullptr;
  }
  return crossed ? std::make_unique<Crossed>(std::move(rails)) : std::move(rails);
}

}  // namespace swept::step
