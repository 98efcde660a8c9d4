// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/swept_distance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace swept::test {
namespace {
using V3 = Eigen::Vector3d;
}

SweptDistance::SweptDistance(const TriMesh& closedBody, const Trajectory& trajectory, double finest)
    : tree_(closedBody),
      poses_(trajectory.poses),
      continuous_(trajectory.interpolation == Interpolation::Linear),
      finest_(finest) {
  if (trajectory.interpolation == Interpolation::Screw) {
    throw std::runtime_error("screw motions are not measured by this tool");
  }
  const TriMesh& mesh = tree_.mesh();
  vertexNormals_.assign(mesh.vertices.size(), V3::Zero());
  edgesOf_.resize(mesh.triangles.size());
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> known;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& tri = mesh.triangles[t];
    const auto number = static_cast<std::int32_t>(t);
    faceNormals_.push_back(tree_.normal(number));
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = tri[k], b = tri[(k + 1) % 3], c = tri[(k + 2) % 3];
      const V3 u = (mesh.vertices[b] - mesh.vertices[a]).normalized();
      const V3 v = (mesh.vertices[c] - mesh.vertices[a]).normalized();
      vertexNormals_[a] += std::acos(std::clamp(u.dot(v), -1.0, 1.0)) * faceNormals_[t];
      const auto [it, fresh] = known.try_emplace(std::minmax(a, b), edges_.size());
      if (fresh) edges_.push_back({a, b, number, number});
      edges_[it->second].right = number;
      edgesOf_[t][k] = it->second;
    }
  }
}

Eigen::Isometry3d SweptDistance::placement(double time) const {
  const double last = lastTime();
  const double clamped = std::clamp(time, 0.0, last);
  const auto i = std::min(static_cast<std::size_t>(clamped), poses_.size() - 1);
  const double part = clamped - static_cast<double>(i);
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (i + 1 >= poses_.size() || part == 0) {
    result.linear() = poses_[i].rotation.toRotationMatrix();
    result.translation() = poses_[i].translation;
    return result;
  }
  const Pose &a = poses_[i], &b = poses_[i + 1];
  result.linear() = a.rotation.slerp(part, b.rotation).toRotationMatrix();
  result.translation() = a.translation + part * (b.translation - a.translation);
  return result;
}

V3 SweptDistance::velocity(double time, const V3& x, bool before) const {
  const double step = 1e-5;
  const Eigen::Isometry3d here = placement(time);
  const V3 y = here.inverse() * x;
  if (before) return (x - placement(time - step) * y) / step;
  return (placement(time + step) * y - x) / step;
}

/// Returns where the nearest point lies: 0 in the interior of a triangle, 1 on an edge, 2 at a
/// vertex. `index` receives the index of this triangle, edge or vertex.
int SweptDistance::featureOf(const Sample& sample, std::int32_t& index) const {
  const TriMesh& mesh = tree_.mesh();
  const auto& tri = mesh.triangles[sample.triangle];
  const V3 &a = mesh.vertices[tri[0]], &b = mesh.vertices[tri[1]], &c = mesh.vertices[tri[2]];
  const V3 n = (b - a).cross(c - a);
  const double area = n.squaredNorm();
  const V3 p = sample.point;
  const double w[3] = {(c - b).cross(p - b).dot(n) / area, (a - c).cross(p - c).dot(n) / area,
                       (b - a).cross(p - a).dot(n) / area};
  int zeros = 0, other = 0;
  for (int k = 0; k < 3; ++k) {
    if (w[k] > 1e-7) {
      other = k;
    } else {
      ++zeros;
    }
  }
  if (zeros == 2) {
    index = tri[other];
    return 2;
  }
  if (zeros == 1) {
    for (int k = 0; k < 3; ++k) {
      if (w[k] <= 1e-7) index = edgesOf_[sample.triangle][(k + 1) % 3];
    }
    return 1;
  }
  index = sample.triangle;
  return 0;
}

V3 SweptDistance::pseudoNormal(const Sample& sample) const {
  std::int32_t index = 0;
  switch (featureOf(sample, index)) {
    case 0:
      return faceNormals_[index];
    case 1:
      return faceNormals_[edges_[index].left] + faceNormals_[edges_[index].right];
    default:
      return vertexNormals_[index];
  }
}

SweptDistance::Sample SweptDistance::sampleAt(double time, const V3& x, double limit) const {
  const V3 y = placement(time).inverse() * x;
  const MeshDistance::Nearest nearest = tree_.nearest(y, limit);
  Sample sample{nearest.distance, nearest.point, nearest.triangle};
  if (nearest.triangle >= 0 && (y - nearest.point).dot(pseudoNormal(sample)) < 0) {
    sample.distance = -sample.distance;
  }
  return sample;
}

SweptDistance::Contact SweptDistance::contact(const V3& x) const {
  struct Interval {
    double from, to, least;
  };
  double bestTime = 0;
  double best = 1e300;
  std::vector<double> candidates;  // middles of finest intervals
  auto evaluate = [&](double time) {
    const Sample sample = sampleAt(time, x, 1e300);
    if (sample.distance < best) {
      best = sample.distance;
      bestTime = time;
    }
    return sample.distance;
  };
  std::vector<std::pair<double, double>> finest;  // samples: distance, time
  std::vector<double> halves;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    finest.emplace_back(evaluate(static_cast<double>(i)), static_cast<double>(i));
    halves.push_back(0);
  }
  if (continuous_) {
    std::vector<Interval> stack;
    for (std::size_t i = 0; i + 1 < poses_.size(); ++i) {
      const double from = static_cast<double>(i);
      stack.push_back({from, from + 1, -1e300});
    }
    std::sort(stack.begin(), stack.end(), [&](const Interval& a, const Interval& b) {
      return finest[static_cast<std::size_t>(a.from)].first >
             finest[static_cast<std::size_t>(b.from)].first;
    });
    while (!stack.empty()) {
      const Interval interval = stack.back();
      stack.pop_back();
      if (interval.least > best) continue;
      const auto i = static_cast<std::size_t>(interval.from);
      const Pose &a = poses_[i], &b = poses_[i + 1];
      const double reach = std::max((x - a.translation).norm(), (x - b.translation).norm());
      const double speed = (b.translation - a.translation).norm() +
                           a.rotation.angularDistance(b.rotation) * reach;  // mm per step
      const double middle = (interval.from + interval.to) / 2;
      const double half = (interval.to - interval.from) / 2;
      const double distance = evaluate(middle);
      const double least = distance - speed * half;
      if (least > best) continue;
      if (2 * speed * half <= finest_) {
        finest.emplace_back(distance, middle);
        halves.push_back(half);
        continue;
      }
      stack.push_back({interval.from, middle, least});
      stack.push_back({middle, interval.to, least});
    }
    // Golden section search around the most promising samples.
    std::vector<std::size_t> order(finest.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return finest[a].first < finest[b].first; });
    const double ratio = 0.6180339887498949;
    std::vector<double> done;
    for (const std::size_t i : order) {
      if (done.size() == 3 || finest[i].first > best + finest_ / 2) break;
      const double half = halves[i] > 0 ? 1.5 * halves[i] : 1e-3;
      const double centre = finest[i].second;
      if (std::any_of(done.begin(), done.end(),
                      [&](double t) { return std::abs(t - centre) < 2 * half; })) {
        continue;
      }
      done.push_back(centre);
      double low = std::max(0.0, centre - half), high = std::min(lastTime(), centre + half);
      double p = high - ratio * (high - low), q = low + ratio * (high - low);
      double dp = evaluate(p), dq = evaluate(q);
      for (int k = 0; k < 18; ++k) {
        if (dp < dq) {
          high = q;
          q = p;
          dq = dp;
          dp = evaluate(p = high - ratio * (high - low));
        } else {
          low = p;
          p = q;
          dp = dq;
          dq = evaluate(q = low + ratio * (high - low));
        }
      }
    }
  }
  Contact contact;
  contact.distance = best;
  contact.time = bestTime;
  const Sample sample = sampleAt(bestTime, x, 1e300);
  const Eigen::Isometry3d here = placement(bestTime);
  contact.point = here * sample.point;
  std::int32_t index = 0;
  const int feature = featureOf(sample, index);
  const V3 outward = here.linear() * pseudoNormal(sample).normalized();
  const bool atEnd = !continuous_ || bestTime < 1e-4 || bestTime > lastTime() - 1e-4;
  if (feature == 0) {
    contact.normals.push_back(here.linear() * faceNormals_[index]);
    return contact;
  }
  std::vector<V3> velocities;
  if (continuous_) {
    if (bestTime > 1e-4) velocities.push_back(velocity(bestTime, contact.point, true));
    if (bestTime < lastTime() - 1e-4)
      velocities.push_back(velocity(bestTime, contact.point, false));
  }
  if (feature == 1) {
    const Edge& edge = edges_[index];
    const V3 along =
        here.linear() * (tree_.mesh().vertices[edge.b] - tree_.mesh().vertices[edge.a]);
    for (const V3& v : velocities) {
      V3 n = along.cross(v);
      if (n.norm() < 1e-6 * along.norm() * v.norm()) continue;
      n.normalize();
      contact.normals.push_back(n.dot(outward) < 0 ? V3(-n) : n);
    }
    if (atEnd || contact.normals.empty()) {
      contact.normals.push_back(here.linear() * faceNormals_[edge.left]);
      contact.normals.push_back(here.linear() * faceNormals_[edge.right]);
    }
    return contact;
  }
  // A vertex: the envelope has a crease or a tip there. The normal of any face around it is
  // accepted.
  for (std::size_t t = 0; t < tree_.mesh().triangles.size(); ++t) {
    const auto& tri = tree_.mesh().triangles[t];
    if (tri[0] != index && tri[1] != index && tri[2] != index) continue;
    contact.normals.push_back(here.linear() * faceNormals_[t]);
  }
  for (const V3& v : velocities) {
    if (v.norm() > 0) {
      contact.normals.push_back((outward - outward.dot(v) / v.squaredNorm() * v).normalized());
    }
  }
  return contact;
}

}  // namespace swept::test
