// Computes surfaces that a moving body sweeps during one step of its motion, as carriers of faces.
//
// Design
//   A step of the motion is a StepPath; s in [0, 1] is the fraction of the step. All coordinates
//   are those of the StepPath: if the trajectory has a pivot, the body is the result of
//   seenFromPivot() and the poses are those of carriedByPivot().
//
//   sweptBy()   S(u, s) = R(s) c(u) + p(s): what a curve c of the body sweeps.
//   grazeOf()   S(w, s): where a smooth face of the body touches the envelope, that is, where its
//   normal n is orthogonal to the velocity v. At each time these points form a contact curve. It is
//   found on "rails", curves that cover the face: on rail w, it is the point where n.v = 0. On a
//   plane, rails are lines across the contact line. On cylinders, cones, extrusions, revolutions
//   and tori, they are circles about the axis, or curves that generate the face. On spheres the
//   contact curve is a great circle, and w is the angle on it.
//
//   Such a surface may be, within the bound, a plane, cylinder, cone, sphere or torus, or an
//   extrusion or revolution with a profile of few cubics. Then the carrier is of this kind
//   (exact_kinds.h). Otherwise it is a Sheet. The sheet interpolates the exact surface on a grid
//   and is within `bound` of it between the grid points. Its parameters u, t are u (or w) and s. So
//   the iso-line t = 0 is the curve at the start of the step. The iso-line u = 0 is the path of the
//   start of the curve. Adjacent sheets agree along a shared path within the bound. By default, the
//   bound is as small as the tolerance of the kernel. With 1e-6 mm the files are a third smaller,
//   but then the kernel's test of a shape for Boolean operations (BOPAlgo_ArgumentAnalyzer) finds
//   curves off their surfaces.
//   Carriers extend beyond the requested range by kMargin on each side, where motion and curves are
//   continued analytically. So borders of faces never touch the borders of the surface.
//   No faulty surface is returned. If the surface degenerates within the requested range, there is
//   no carrier: `why` says how it degenerates, and `where` at which parameters. The caller then
//   uses facets.
//
//   The curves that bound such faces are in sweep/borders.h.
// Units:   mm; s is without unit.
// Cost:    O(poles) evaluations of the motion: 1 ms for a line, 2 ms for a circle, 2 to 8 ms for a
//          grazing cylinder.
// Source:  Adsul, Machchhar and Sohoni, CAGD 31 (2014); Abdel-Malek, Blackmore and Joy 2006 (rank
//          deficiency).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/step_path.h"
#include "solid/carrier/carrier.h"
#include "solid/carrier/curve.h"
#include "solid/carrier/section.h"

namespace swept::step {

/// Fraction of a range by which a sheet is larger on each side.
constexpr double kMargin = 0.02;
/// Speeds and areas below this fraction of the largest possible ones count as zero.
constexpr double kNoSpeed = 1e-9;

enum class Degeneracy {
  None,
  AtRest,       ///< does not move in this step
  AlongItself,  ///< a curve or a face slides along itself and sweeps no new surface
  Singular,     ///< the surface has a pole, a crease or an edge of regression in the range
  NoContact,    ///< n.v = 0 has no solution on some rail in the range
  Fold,         ///< a contact curve turns back within the rails
  LeavesFace,   ///< the contact leaves the known part of the face
  TooComplex,   ///< the bound is not reached with kMaxSpans spans and kMaxPoles poles
  NotKnown,     ///< no method for this kind of face
};
/// Returns a text such as "it slides along itself".
const char* degeneracyText(Degeneracy why);

struct SweptSurface {
  /// The outward side is that of the face (grazeOf), or that of S_u x S_s (sweptBy); see
  /// faceOutwards().
  std::optional<Carrier> carrier;
  Degeneracy why = Degeneracy::None;
  /// (u or w, s) at which the surface degenerates
  Eigen::Vector2d where = Eigen::Vector2d::Zero();
  double error = 0;  ///< mm: largest deviation measured between the points of interpolation
};

/// Returns the surface swept by c(u), u in `along`, while s is in `during`. `along` may extend a
/// little beyond the ends of the curve. A face on a full circle would need a seam, so the caller
/// must cut the circle and call this function for each part. A curve that slides along itself
/// sweeps no surface. There, the envelope consists of the faces beside the curve.
SweptSurface sweptBy(const Curve& curve, Range along, const StepPath& path, Range during,
                     double bound = kOnCarrier);

/// A point of the envelope at which the face grazes it (SourceKind::Graze).
struct Contact {
  Eigen::Vector3d point;  ///< in world coordinates, mm
  double s = 0;           ///< fraction of the step
};

/// Returns the surface in which a face grazes the envelope. `face`: its carrier in coordinates of
/// the body, with its outward side. `contacts`: points that the surface must cover. They select the
/// branch and the range, and need not be exact. A face that slides along itself (AlongItself) has
/// no grazing surface other than itself. If there are contacts all around a cylinder, or on both
/// sides of it, the caller must divide them first.
SweptSurface grazeOf(const Carrier& face, const std::vector<Contact>& contacts,
                     const StepPath& path, double bound = kOnCarrier);

/// Reverses the carrier if its outward normal at p is not on the side of `outward`.
void faceOutwards(Carrier& carrier, const Eigen::Vector3d& p, const Eigen::Vector3d& outward);

}  // namespace swept::step
