// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/fit_spline.h"

namespace swept::step {

std::optional<Curve> fitSpline(const ExactCurve& exact, Range range, double bound) {
  const auto curves = fitSplines(
      [&](double v) -> Eigen::RowVectorXd { return exact(v).transpose(); }, range, bound);
  return curves ? std::optional<Curve>(curves->front()) : std::nullopt;
}

std::optional<std::vector<Curve>> fitSplines(const ExactRow& exact, Range range, double bound) {
  const auto knots = knotsFor(exact, range, kSmoothDegree, bound, kMaxSpans);
  if (!knots) return std::nullopt;
  const std::vector<double> sites = knots->sites();
  Eigen::MatrixXd values;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const Eigen::RowVectorXd row = exact(sites[i]);
    if (i == 0) values.resize(static_cast<Eigen::Index>(sites.size()), row.cols());
    values.row(static_cast<Eigen::Index>(i)) = row;
  }
  const Eigen::MatrixXd poles = Interpolator(*knots).poles(values);
  std::vector<Curve> curves;
  for (Eigen::Index column = 0; column < poles.cols(); column += 3) {
    Curve& curve = curves.emplace_back();
    curve.kind = CurveKind::Spline;
    curve.degree = knots->degree();
    curve.joints = knots->joints();
    curve.last = range.length();
    for (const double knot : knots->breaks()) curve.knots.push_back(knot - range.from);
    for (Eigen::Index i = 0; i < poles.rows(); ++i)
      curve.poles.emplace_back(poles.block<1, 3>(i, column).transpose());
  }
  return curves;
}

}  // namespace swept::step
