// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/sweep/interpolate.h"

#include <algorithm>

namespace swept::step {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kLines = 7;  // number of iso-lines along which knots are chosen
constexpr int kTries = 3;

std::vector<double> evenly(Range range, std::size_t count) {
  std::vector<double> result;
  for (std::size_t i = 0; i < count; ++i)
    result.push_back(range.at(static_cast<double>(i) / static_cast<double>(count - 1)));
  return result;
}

// Finds knots that suit all iso-lines at the parameters `lines` of the other direction.
std::optional<Knots> knotsAlong(const ExactSurface& exact, Range range,
                                const std::vector<double>& lines, bool alongU, double bound,
                                int degree) {
  const ExactRow row = [&](double v) {
    Eigen::RowVectorXd values(3 * lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      values.segment<3>(static_cast<Eigen::Index>(3 * i)) =
          (alongU ? exact(v, lines[i]) : exact(lines[i], v)).transpose();
    }
    return values;
  };
  return knotsFor(row, range, degree, bound, kMaxSpans);
}

Sheet interpolate(const ExactSurface& exact, const Knots& u, const Knots& t) {
  const std::vector<double> atU = u.sites(), atT = t.sites();
  Eigen::MatrixXd byU(atU.size(), 3 * atT.size());
  for (std::size_t i = 0; i < atU.size(); ++i) {
    for (std::size_t j = 0; j < atT.size(); ++j) {
      byU.block<1, 3>(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(3 * j)) =
          exact(atU[i], atT[j]).transpose();
    }
  }
  byU = Interpolator(u).poles(byU);
  Eigen::MatrixXd byT(atT.size(), 3 * atU.size());
  for (Eigen::Index i = 0; i < byU.rows(); ++i) {
    for (Eigen::Index j = 0; j < byT.rows(); ++j)
      byT.block<1, 3>(j, 3 * i) = byU.block<1, 3>(i, 3 * j);
  }
  byT = Interpolator(t).poles(byT);
  std::vector<Vector3d> poles;
  for (Eigen::Index i = 0; i < byU.rows(); ++i) {
    for (Eigen::Index j = 0; j < byT.rows(); ++j)
      poles.emplace_back(byT.block<1, 3>(j, 3 * i).transpose());
  }
  return {u, t, std::move(poles)};
}

// Returns points at about one third and two thirds of the gaps between sites, where the error is
// largest.
std::vector<double> between(const Knots& knots) {
  const std::vector<double> sites = knots.sites();
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < sites.size(); ++i) {
    const Range gap{sites[i], sites[i + 1]};
    result.insert(result.end(), {gap.at(0.31), gap.at(0.69)});
  }
  return result;
}

double errorOf(const Sheet& sheet, const ExactSurface& exact) {
  double largest = 0;
  for (const double u : between(sheet.knotsU())) {
    for (const double t : between(sheet.knotsT())) {
      const double error = (sheet.at(u, t) - exact(u, t)).norm();
      largest = error <= 1e300 ? std::max(largest, error) : 1e300;
    }
  }
  return largest;
}

}  // namespace

std::optional<FittedSheet> fitSheet(const ExactSurface& exact, Range u, Range t, const Knots* given,
                                    double bound, std::size_t maxPoles, int degree) {
  std::size_t lines = kLines;
  double each = bound / 3;  // the errors of the two directions add up
  for (int attempt = 0; attempt < kTries; ++attempt, lines = 2 * lines - 1, each /= 3) {
    // If the knots along u are given, the surface is a spline that moves rigidly, so its poles move
    // rigidly. For a line, the paths of its two ends suffice to choose the knots along t.
    const auto across = given != nullptr && given->degree() == 1 ? evenly(u, 2) : evenly(u, lines);
    const auto knotsT = knotsAlong(exact, t, across, false, each, degree);
    if (!knotsT) return std::nullopt;
    const auto knotsU = given != nullptr
                            ? std::optional<Knots>(*given)
                            : knotsAlong(exact, u, evenly(t, lines), true, each, degree);
    if (!knotsU || knotsU->poleCount() * knotsT->poleCount() > maxPoles) return std::nullopt;
    const auto sheet = std::make_shared<const Sheet>(interpolate(exact, *knotsU, *knotsT));
    const double error = errorOf(*sheet, exact);
    if (error <= bound) return FittedSheet{sheet, error};
  }
  return std::nullopt;
}

}  // namespace swept::step
