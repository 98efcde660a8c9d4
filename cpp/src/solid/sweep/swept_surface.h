// Surfaces that a moving body sweeps during one step of its motion, as carriers of faces.
//
// Design
//   A step of the motion is a StepPath; s in [0, 1] is the fraction of the step. Everything is in
//   the frame of the StepPath: if the trajectory has a pivot, the body is the one of
//   seenFromPivot() and the poses are those of carriedByPivot().
//
//   sweptBy()   S(u, s) = R(s) c(u) + p(s): what a curve c of the body sweeps.
//   grazeOf()   S(w, s): where a smooth face of the body touches the envelope, that is, where its
//               normal n is orthogonal to the velocity v. At each moment this is a contact curve.
//               It is found on "rails", curves that cover the face: on rail w, the point where
//               n.v = 0. Rails are lines across the contact line on a plane; parallels or
//               generator lines on cylinders, cones, extrusions, revolutions and tori. On spheres
//               the contact curve is a great circle, and w its angle.
//
//   Where such a surface is a plane, cylinder, cone, sphere or torus within the bound, or an
//   extrusion or revolution with a profile of few cubics, the carrier is of this kind
//   (exact_kinds.h). Otherwise it is a Sheet, which interpolates the exact surface on a grid and is
//   within `bound` of it between the grid points. The parameters u, t of the sheet are u (or w) and
//   s: the iso-line t = 0 is the posed curve, u = 0 the path of the curve's start, and so on.
//   Adjacent sheets agree along a shared path within the bound. The bound is by default as fine as
//   the kernel's own tolerance. With 1e-6 mm the files are a third smaller, but then the kernel's
//   test of a shape for Boolean operations (BOPAlgo_ArgumentAnalyzer) finds curves off their
//   surfaces.
//
//   Carriers cover the asked range with a margin of kMargin on each side (motion and curves go on
//   analytically), so borders of faces never touch the borders of the surface.
//
//   Nothing bad comes back silently. If the surface degenerates within the asked range, `why` says
//   how, `where` at which parameters, and there is no carrier: the caller keeps facets.
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

/// Share of a range by which a sheet is larger on each side.
constexpr double kMargin = 0.02;

enum class Degeneracy {
  None,
  AtRest,       ///< does not move in this step
  AlongItself,  ///< a curve slides along itself, or a face along itself: no surface of its own
  Singular,     ///< the surface has a pole, a crease or an edge of regression in the range
  NoContact,    ///< n.v = 0 has no solution on some rail in the range
  Fold,         ///< a contact curve turns back within the rails
  LeavesFace,   ///< the contact leaves the face's own surface
  TooComplex,   ///< the bound is not reached with kMostSpans
  NotKnown,     ///< no method for this kind of face
};
/// Returns a text such as "the curve slides along itself".
const char* degeneracyText(Degeneracy why);

struct SweptSurface {
  /// The outward side is that of the face (grazeOf) or of S_u x S_s (sweptBy); see faceOutwards().
  std::optional<Carrier> carrier;
  Degeneracy why = Degeneracy::None;
  Eigen::Vector2d where = Eigen::Vector2d::Zero();  ///< (u or w, s) at which it degenerates
  double error = 0;  ///< mm: largest deviation measured between the points of interpolation
};

/// Returns the surface swept by c(u), u in `along`, while s is in `during`. `along` may reach a
/// little beyond the ends of the curve. A face on a full circle would need a seam, so cut the
/// circle and call this function for each part. A curve that slides along itself sweeps no surface:
/// there, the envelope consists of the faces beside the curve.
SweptSurface sweptBy(const Curve& curve, Range along, const StepPath& path, Range during,
                     double bound = kOnCarrier);

/// A point of the envelope that the face made by grazing, as in SurfaceSource.
struct Contact {
  Eigen::Vector3d point;  ///< world
  double s = 0;           ///< fraction of the step
};

/// Returns the surface in which a face grazes the envelope. `face`: its carrier in coordinates of
/// the body, with its outward side. `contacts`: points that the surface must cover; they choose the
/// branch and the range. They need not be exact. A face that slides along itself (AlongItself) has
/// no grazing surface besides its own. Contacts all round a cylinder, or on both sides of it, must
/// be cut into pieces before.
SweptSurface grazeOf(const Carrier& face, const std::vector<Contact>& contacts,
                     const StepPath& path, double bound = kOnCarrier);

/// Makes the outward normal of the carrier at p the one on the side of `outward`.
void faceOutwards(Carrier& carrier, const Eigen::Vector3d& p, const Eigen::Vector3d& outward);

}  // namespace swept::step
