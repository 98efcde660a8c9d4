// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/fit_spline.h"

namespace swept::step {

std::optional<Curve> fitSpline(const ExactCurve& exact, Range range, double bound) {
  const ExactRow row = [&](double v) -> Eigen::RowVectorXd { return exact(v).transpose(); };
  const auto knots = knotsFor(row, range, kSmoothDegree, bound, kMaxSpans);
  if (!knots) return std::nullopt;
  const std::vector<double> sites = knots->sites();
  Eigen::MatrixXd values(sites.size(), 3);
  for (std::size_t i = 0; i < sites.size(); ++i)
    values.row(static_cast<Eigen::Index>(i)) = exact(sites[i]).transpose();
  const Eigen::MatrixXd poles = Interpolator(*knots).poles(values);
  Curve curve;
  curve.kind = CurveKind::Spline;
  curve.degree = knots->degree();
  curve.joints = knots->joints();
  curve.last = range.length();
  for (const double knot : knots->breaks()) curve.knots.push_back(knot - range.from);
  for (Eigen::Index i = 0; i < poles.rows(); ++i)
    curve.poles.emplace_back(poles.row(i).transpose());
  return curve;
}

}  // namespace swept::step
