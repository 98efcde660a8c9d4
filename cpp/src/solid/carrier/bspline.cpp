// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/carrier/bspline.h"

#include <algorithm>
#include <cmath>

namespace swept::step {
namespace {

// Inserts one knot into a spline (Boehm 1980): the same curve with one more pole.
void insertKnot(std::vector<double>& flat, Eigen::MatrixXd& poles, int degree, double at) {
  const auto after = std::upper_bound(flat.begin(), flat.end(), at);
  const Eigen::Index span = after - flat.begin() - 1;
  Eigen::MatrixXd more(poles.rows() + 1, poles.cols());
  for (Eigen::Index i = 0; i < more.rows(); ++i) {
    if (i <= span - degree) {
      more.row(i) = poles.row(i);
    } else if (i > span) {
      more.row(i) = poles.row(i - 1);
    } else {
      const double low = flat[i], high = flat[i + degree];
      const double w = high > low ? (at - low) / (high - low) : 1;
      more.row(i) = (1 - w) * poles.row(i - 1) + w * poles.row(i);
    }
  }
  flat.insert(after, at);
  poles = std::move(more);
}

// Returns the length of the longest vector in a row. Every three columns are one vector.
double largestError(const Eigen::RowVectorXd& difference) {
  double largest = 0;
  for (Eigen::Index i = 0; i + 2 < difference.cols(); i += 3)
    largest = std::max(largest, difference.segment<3>(i).norm());
  return largest;
}

}  // namespace

Knots::Knots(int degree, std::vector<double> breaks, int joints)
    : degree_(degree), joints_(joints), breaks_(std::move(breaks)) {
  flat_.assign(static_cast<std::size_t>(degree) + 1, breaks_.front());
  for (std::size_t i = 1; i + 1 < breaks_.size(); ++i)
    flat_.insert(flat_.end(), static_cast<std::size_t>(joints), breaks_[i]);
  flat_.insert(flat_.end(), static_cast<std::size_t>(degree) + 1, breaks_.back());
}

Knots::Basis Knots::basis(double t) const {
  const int p = degree_;
  const auto inner = flat_.begin() + p + 1, last = flat_.end() - p - 1;
  const auto span = static_cast<std::size_t>(std::upper_bound(inner, last, t) - flat_.begin()) - 1;
  Basis result;
  result.first = span - p;
  // Raises the degree from 0 to p. In step j, value[r] is a function of degree j.
  std::array<double, kMaxDegree + 1>& value = result.value;
  std::array<double, kMaxDegree + 1> left{}, right{};
  value[0] = 1;
  for (int j = 1; j <= p; ++j) {
    left[j] = t - flat_[span + 1 - j];
    right[j] = flat_[span + j] - t;
    double saved = 0;
    for (int r = 0; r < j; ++r) {
      const double part = value[r] / (right[r + 1] + left[j - r]);
      value[r] = saved + right[r + 1] * part;
      saved = left[j - r] * part;
    }
    value[j] = saved;
  }
  return result;
}

std::vector<double> Knots::sites() const {
  std::vector<double> result;
  for (std::size_t i = 0; i < poleCount(); ++i) {
    double sum = 0;
    for (int k = 1; k <= degree_; ++k) sum += flat_[i + k];
    result.push_back(sum / degree_);
  }
  result.front() = flat_.front();
  result.back() = flat_.back();
  return result;
}

Interpolator::Interpolator(const Knots& knots) {
  const std::vector<double> sites = knots.sites();
  const auto count = static_cast<Eigen::Index>(sites.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Knots::Basis basis = knots.basis(sites[i]);
    for (int k = 0; k <= knots.degree(); ++k)
      matrix(i, static_cast<Eigen::Index>(basis.first) + k) = basis.value[k];
  }
  solver_.compute(matrix);
}

Eigen::RowVectorXd valueOf(const Knots& knots, const Eigen::MatrixXd& poles, double t) {
  const Knots::Basis basis = knots.basis(t);
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(poles.cols());
  for (int k = 0; k <= knots.degree(); ++k)
    sum += basis.value[k] * poles.row(static_cast<Eigen::Index>(basis.first) + k);
  return sum;
}

Knots finer(const Knots& knots, const std::vector<int>& pieces) {
  std::vector<double> breaks{knots.breaks().front()};
  for (std::size_t i = 0; i + 1 < knots.breaks().size(); ++i) {
    const Range span{knots.breaks()[i], knots.breaks()[i + 1]};
    for (int k = 1; k <= pieces[i]; ++k)
      breaks.push_back(k == pieces[i] ? span.to : span.at(static_cast<double>(k) / pieces[i]));
  }
  return {knots.degree(), std::move(breaks), knots.joints()};
}

std::optional<Knots> knotsFor(const ExactRow& exact, Range range, int degree, double bound,
                              std::size_t mostSpans) {
  Knots knots(degree, {range.from, range.to});
  // Positions within a span, as fractions of its length. They lie between successive sites, where
  // the errors are largest.
  constexpr std::array<double, 6> kBetween{0.06, 0.23, 0.41, 0.59, 0.77, 0.94};
  /// All spans are cut alike if each needs at least this fraction of the largest number of pieces.
  constexpr double kEven = 0.4;
  while (knots.breaks().size() <= mostSpans + 1) {
    const std::vector<double> sites = knots.sites();
    Eigen::MatrixXd values;
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const Eigen::RowVectorXd row = exact(sites[i]);
      if (!row.allFinite()) return std::nullopt;
      if (i == 0) values.resize(static_cast<Eigen::Index>(sites.size()), row.cols());
      values.row(static_cast<Eigen::Index>(i)) = row;
    }
    const Eigen::MatrixXd poles = Interpolator(knots).poles(values);
    // Number of pieces that each span needs. The error of a span is proportional to its length to
    // the power degree + 1.
    std::vector<double> wanted;
    for (std::size_t i = 0; i + 1 < knots.breaks().size(); ++i) {
      const Range span{knots.breaks()[i], knots.breaks()[i + 1]};
      double error = 0;
      for (const double w : kBetween) {
        const Eigen::RowVectorXd row = exact(span.at(w));
        if (!row.allFinite()) return std::nullopt;
        error = std::max(error, largestError(valueOf(knots, poles, span.at(w)) - row));
      }
      wanted.push_back(std::pow(error / bound, 1.0 / (degree + 1)));
    }
    const auto [least, most] = std::minmax_element(wanted.begin(), wanted.end());
    if (*most <= 1) return knots;
    if (*least >= kEven * *most) {
      // Uses equal spans. An estimate from fewer than three spans is too high, so only 80 % of it
      // is used.
      const double fraction = wanted.size() < 3 ? 0.8 : 1;
      const auto count = static_cast<double>(wanted.size());
      const double next = std::max(count + 1, std::ceil(fraction * *most * count));
      knots = finer(Knots(degree, {range.from, range.to}), {static_cast<int>(next)});
      continue;
    }
    std::vector<int> pieces;
    for (const double w : wanted)
      pieces.push_back(w <= 1 ? 1 : static_cast<int>(std::clamp(std::ceil(0.95 * w), 2.0, 4.0)));
    knots = finer(knots, pieces);
  }
  return std::nullopt;
}

Eigen::MatrixXd partOf(const Knots& knots, const Eigen::MatrixXd& poles, Range range, Knots& part) {
  std::vector<double> flat = knots.flat();
  Eigen::MatrixXd more = poles;
  const int degree = knots.degree();
  for (const double end : {range.from, range.to}) {
    auto count = std::count(flat.begin(), flat.end(), end);
    for (; count < degree; ++count) insertKnot(flat, more, degree, end);
  }
  // A pole belongs to the part if all its knots, except the first and the last, lie in the range.
  std::vector<double> breaks;
  Eigen::Index first = -1, last = 0;
  for (Eigen::Index i = 0; i < more.rows(); ++i) {
    if (flat[i + 1] < range.from || flat[i + degree] > range.to) continue;
    if (first < 0) first = i;
    last = i;
  }
  for (const double knot : knots.breaks()) {
    if (knot > range.from && knot < range.to) breaks.push_back(knot);
  }
  breaks.insert(breaks.begin(), range.from);
  breaks.push_back(range.to);
  part = Knots(degree, std::move(breaks), knots.joints());
  return more.middleRows(first, last - first + 1);
}

}  // namespace swept::step
