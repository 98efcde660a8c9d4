// B-splines: knots, basis functions, and interpolation between exact values.
// In:      distinct knots ("breaks"). The ends have multiplicity degree + 1, inner knots have
// multiplicity `joints`.
// Cost:    O(degree^2) per evaluation. Interpolation takes O(poles^3) once; there are few poles.
// Source:  Piegl and Tiller, "The NURBS Book" (A2.2, A2.3, A5.1). The sites of interpolation are
// those of Greville 1969, for which the equations are well-conditioned at least up to degree 5.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace swept::step {

/// An interval of parameters.
struct Range {
  double from = 0, to = 1;
  double length() const { return to - from; }
  double at(double fraction) const { return from + fraction * (to - from); }
  Range grown(double fraction) const { return {at(-fraction), at(1 + fraction)}; }
  /// Returns the smallest range that contains this one and a value.
  Range with(double value) const { return {std::min(from, value), std::max(to, value)}; }
};

class Knots {
 public:
  static constexpr int kMaxDegree = 9;
  /// The basis functions that are not zero at one parameter: value[i] is that of pole first + i.
  struct Basis {
    std::size_t first = 0;
    std::array<double, kMaxDegree + 1> value{};
  };

  Knots() = default;
  Knots(int degree, std::vector<double> breaks, int joints = 1);

  int degree() const { return degree_; }
  int joints() const { return joints_; }
  std::size_t poleCount() const { return flat_.size() - degree_ - 1; }
  const std::vector<double>& breaks() const { return breaks_; }
  Range range() const { return {breaks_.front(), breaks_.back()}; }
  /// Returns the basis functions at t. Beyond the ends, the first and the last polynomial are
  /// continued.
  Basis basis(double t) const;
  /// Returns the parameters of interpolation: one for each pole, including both ends.
  std::vector<double> sites() const;
  /// Returns all knots, each as often as its multiplicity.
  const std::vector<double>& flat() const { return flat_; }

 private:
  int degree_ = 1, joints_ = 1;
  std::vector<double> breaks_{0, 1}, flat_{0, 0, 1, 1};
};

/// Finds poles (one per row) from values at the sites of the knots (one per row).
class Interpolator {
 public:
  explicit Interpolator(const Knots& knots);
  Eigen::MatrixXd poles(const Eigen::MatrixXd& values) const { return solver_.solve(values); }

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> solver_;
};

/// Returns the value of a spline at t. `poles`: one per row.
Eigen::RowVectorXd valueOf(const Knots& knots, const Eigen::MatrixXd& poles, double t);

/// Returns the exact values of several curves at a parameter, in one row.
using ExactRow = std::function<Eigen::RowVectorXd(double)>;

/// Returns knots with which the interpolating spline is within `bound` (mm) of the exact values.
/// Every three columns of a row are the coordinates of one point. Cuts only spans that are too
/// inaccurate, so knots are dense only where necessary. Returns nothing if `mostSpans` spans do not
/// suffice or a value is not finite.
std::optional<Knots> knotsFor(const ExactRow& exact, Range range, int degree, double bound,
                              std::size_t mostSpans);

/// Cuts span i into pieces[i] equal pieces.
Knots finer(const Knots& knots, const std::vector<int>& pieces);

/// Returns the poles of the piece of the spline between two parameters. `part` receives its knots.
Eigen::MatrixXd partOf(const Knots& knots, const Eigen::MatrixXd& poles, Range range, Knots& part);

}  // namespace swept::step
