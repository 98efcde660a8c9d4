// One step of a motion: the faces of which its part of the envelope may consist (turning_faces.h).
// Units:   mm; s is the fraction of the step.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Edge.hxx>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "motion/step_path.h"
#include "solid/assemble/body_geometry.h"
#include "solid/assemble/body_motion.h"
#include "solid/assemble/contact_curves.h"
#include "solid/assemble/envelope_conditions.h"
#include "solid/assemble/fixed_surfaces.h"
#include "solid/assemble/turning_faces.h"
#include "solid/assemble/zero_curves.h"
#include "solid/sweep/interpolate.h"

namespace swept::step {

/// mm: how far surfaces may lie off the exact ones. Where two of them are nearly tangent, this
/// error, divided by the sine of the angle between them, is that of their section.
constexpr double kSurfaceBound = 2e-9;
/// A cylinder whose axis nearly moves along itself grazes in a surface with some 3,000 poles.
constexpr std::size_t kMaxTurningPoles = 10000;
/// Fractions of the step: between equal times, and between the times at which contact is tested.
constexpr double kSameTime = 1e-9, kOneStep = 1.0 / kZeroSteps;

class TurningStep {
 public:
  TurningStep(const std::shared_ptr<const MovingBody>& moving, std::size_t step,
              const FixedSurfaces& fixed, TurningFaces& to)
      : body_(moving->body),
        path_(moving->paths[step]),
        motion_(moving->motions[step]),
        conditions_(moving, step),
        fixed_(fixed),
        to_(to) {
    for (std::size_t i = 0; i < body_.surfaces.size(); ++i)
      curves_.emplace_back(body_, static_cast<int>(i), path_);
  }

  /// Returns false if a vertex is at rest, or if a cylinder turns about its axis. `caps`: of the
  /// start and the end, the index of the candidate of each face.
  bool append(const PosedBody& start, const PosedBody& end,
              const std::array<const std::vector<int>*, 2>& caps);
  /// Adds the curves that divide fixed surfaces to these. `step`: index of this step.
  void addPathsTo(FixedSurfaces& fixed, std::size_t step) const;

 private:
  // Between two times of the step: what a vertex and what an edge sweeps. The times are indices in
  // `times_`.
  struct VertexPath {
    int from, to;
    TopoDS_Edge path;
  };
  struct SheetPart {
    int from, to;
    int face;  // of the result, or -1
  };

  // A curve on what an edge sweeps, on which the normal of a face at the edge is orthogonal to the
  // velocity: it is a path of points of contact.
  struct Contact {
    int edge, face;
    int curve;          // of ContactCurves, or its kNoCurve
    std::size_t sheet;  // of the edge
    ZeroArc arc;        // parameter of the edge, time
    Range along;        // the part of the arc
    Range s;
    Range w;  // positions on the contact curve
  };

  // What a contact curve sweeps in a range of times. The parameters of its surface are the position
  // on the contact curve, and time; if it is a part of a fan, those of the fan.
  struct Graze {
    int surface, curve;
    Range w, s;
    int face;
    std::optional<ContactCurves::Fan> fan = std::nullopt;
    // `time`: 0 or 1.
    bool reaches(int time) const { return time == 0 ? s.from <= 0 : s.to >= 1; }
  };

  // Returns whether an edge sweeps surfaces of the envelope that stay in no plane.
  bool doesSweep(const BodyEdge& edge) const;
  // Finds the times at which sheets are cut, by edge and by vertex.
  void findTimes();
  Range between(int from, int to) const { return {times_[from], times_[to]}; }
  bool makePaths(int vertex);
  // Appends what an edge sweeps: a face between any two of its times. Its parameters are that of
  // the edge, and time.
  void appendSheets(int e);
  TopoDS_Face sheetOf(const BodyEdge& edge, const SheetPart& part,
                      const Handle(Geom_Surface) & surface) const;
  // Finds the paths of points of contact that lie on an edge.
  void findContacts(int e);
  // Finds those on one of its faces and on one part of its sheet, within a range of times.
  void findContacts(int e, int f, std::size_t part, Range within);
  // Returns the positions on an arc at which it passes from one part of a contact curve to another,
  // and both its ends, in order.
  std::vector<double> cutsOf(const ZeroArc& arc, const BodyEdge& edge, const ContactCurves& curves,
                             Range within) const;
  // Returns whether the grazing surface must end exactly when the contact does. This is so if the
  // body moves in a plane: the contact curve is orthogonal to this plane, so it reaches an edge
  // that is orthogonal to it as a whole. A grazing surface that went on beyond this time would be
  // nearly the same as what the edge sweeps.
  bool endsExactly(const Contact& contact) const;
  // Appends the surfaces that a contact curve of a surface of the body sweeps, for the times at
  // which it touches a face.
  void appendGrazes(int surface, int curve);
  // Appends what a contact curve sweeps in the window of a critical circle, and the whole fan if it
  // is the first of its curves.
  void appendFan(int surface, int curve, const ContactCurves::Fan& fan);
  // Returns a sheet within the bound of grazing surfaces. Where a contact curve bends quickly,
  // splines of a high degree need fewer poles.
  static std::optional<FittedSheet> fittedGraze(const ExactSurface& exact, Range w, Range t,
                                                const Knots* given);
  // Returns whether two points of contact are the same.
  static bool isAt(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    constexpr double kOnCurve = 1e-6;  // mm
    return (a - b).norm() < kOnCurve;
  }
  // Returns the range of positions that the surface of a contact curve covers.
  Range rangeOf(const ContactCurves& curves, int curve, Range w) const;
  // Returns the parameters of the point of contact at a position, on the surface of a graze.
  Eigen::Vector2d onGraze(const Graze& graze, double w, double s) const;
  // The same for a point of contact.
  Eigen::Vector2d parametersOn(const Graze& graze, const Eigen::Vector3d& p, double s) const;
  // Returns the point of contact at these parameters.
  ContactCurves::Touch touchOf(const Graze& graze, const Eigen::Vector2d& on) const;
  // Returns where this point is, in world coordinates.
  Eigen::Vector3d pointOn(const Graze& graze, const Eigen::Vector2d& on) const;
  // Returns whether a grazing surface lies in a fixed surface. This happens where a face
  // that slides continues smoothly into a cylinder.
  bool isFixed(const ExactSurface& exact, Range w, Range t) const;
  // Returns whether the points of contact lie on this contact curve of this surface, within these
  // times.
  bool belongs(const Contact& contact, int surface, int curve, Range s) const;
  // Drops the contacts of a grazing surface that is not needed.
  void dropContacts(int surface, int curve, Range s);
  const Graze* grazeOf(const Contact& contact) const;
  // Appends the curve in which what an edge sweeps continues into a grazing surface.
  void appendContact(const Contact& contact);
  // Returns the points of the border of a face at which it touches the envelope at a time, in
  // coordinates of the body.
  std::vector<Eigen::Vector3d> contactsOnBorder(int f, double s) const;
  // Appends the parts of a contact curve at the start (0) or the end (1) of the step that lie
  // inside of faces.
  void appendContactCurves(const Graze& graze, int time);
  void appendContactCurve(const Graze& graze, int time, int f, Range w);
  // Returns the parts of the contact curve of a grazing surface at one time that lie inside a face.
  // `next`: the grazing surface that begins then. Each part lies on one half of its contact curve.
  std::vector<Range> partsIn(int f, const Graze& graze, double s,
                             const Graze* next = nullptr) const;
  // Returns the ranges between two positions on a curve at which it lies inside a face.
  std::vector<Range> insideOf(int f, std::vector<double> cuts,
                              const std::function<Eigen::Vector3d(double)>& at) const;
  // Appends the parts of a contact curve inside faces at which a grazing surface ends and another
  // begins, because the courses of the contact curves change at this time.
  void appendChange(const Graze& graze, const Graze& next);
  // Appends the curve in which the grazing surface of a part of a contact curve ends and that of
  // the next part begins.
  void appendSeam(const Graze& part, const Graze& next);
  // Appends the curves in which a fan of points of contact before the critical moment meets one
  // after it: the contact curve at this moment if both belong to one contact curve, the critical
  // circle if both belong to one half.
  void appendMoment(const Graze& before, const Graze& after);
  // Appends the parts of a curve inside faces at which two surfaces meet at one time. `p`: points
  // of the body.
  void appendBorder(const Graze& one, const Graze& other, double s, Range range,
                    const std::function<Eigen::Vector3d(double)>& p,
                    const std::function<double(const Eigen::Vector3d&)>& whereIs);
  // Returns a part of the contact curve of a grazing surface at one time as a curve on it. Null if
  // that fails.
  TopoDS_Edge contactEdge(const Graze& graze, double s, Range w) const;
  // Appends the contact curves of a curved face at the start (0) or the end (1) of the step for
  // which there are no grazing surfaces.
  void appendContactsOfCap(int f, int time);
  // Returns the grazing surface that begins or ends in a contact curve through a point.
  const Graze* grazeAt(int surface, const Eigen::Vector3d& p, int time) const;
  // The edges of regression of a grazing surface: there it is tangent to itself, as the contact
  // curve has the velocity of the body. And the points at which paths of contact cross them.
  struct Regression {
    std::vector<SweptSection> folds;
    std::vector<gp_Pnt> crossings;
  };
  // Returns the range of positions and fractions of the step (of a fan: the second parameter) on a
  // grazing surface.
  Eigen::AlignedBox2d domainOf(const Graze& graze) const;
  // Returns the parameters of the surface at a position and a fraction of the step.
  Eigen::Vector2d onSheet(const Eigen::Vector2d& on) const {
    return {on.x(), motion_.timeOf(on.y())};
  }
  // Returns the signed area of a grazing surface per unit of its parameters, at a position and a
  // fraction of the step. It is zero on the edges of regression.
  OfTwo areaOf(const Graze& graze) const;
  Regression regressionOf(const Graze& graze) const;
  std::vector<gp_Pnt> crossingsOf(const Graze& graze, const OfTwo& area) const;
  void appendRegressions();

  const BodyGeometry& body_;
  const StepPath& path_;
  const BodyMotion& motion_;
  const EnvelopeConditions conditions_;
  const FixedSurfaces& fixed_;
  TurningFaces& to_;
  std::array<const std::vector<int>*, 2> caps_{};  // at the start and the end
  std::vector<ContactCurves> curves_;              // by surface of the body
  std::vector<double> times_;  // at which sheets are cut, and the start and the end of the step
  std::vector<PosedBody> between_;
  std::vector<const PosedBody*> posed_;         // by time
  std::vector<std::vector<VertexPath>> paths_;  // by vertex
  std::vector<std::vector<SheetPart>> sheets_;  // by edge
  std::vector<Contact> contacts_;
  std::vector<Graze> grazes_;
};

}  // namespace swept::step
