// SPDX-License-Identifier: LGPL-2.1-or-later
#include "crossings/sweep_tree.h"

#include <Eigen/Geometry>
#include <numeric>

namespace swept {
namespace {

constexpr std::uint32_t kLeafFaces = 1;
constexpr double kRoom = 1 + 1e-9;  ///< covers the rounding of the bounds

}  // namespace

SweepTree::SweepTree(const SamplerInput& input, const std::vector<Placement>& placements)
    : input_(input), placements_(placements), scale_(1 / input.grid.cell) {
  Eigen::AlignedBox3d box;
  for (const auto& v : input.body.vertices) box.extend(v);
  centre_ = box.center();
  const auto count = static_cast<std::uint32_t>(input.body.triangles.size());
  faces_.resize(count);
  std::iota(faces_.begin(), faces_.end(), 0u);
  firstEdge_.assign(count + 1, 0);
  for (const BodyEdge& edge : input.topology.edges) ++firstEdge_[edge.left + 1];
  std::partial_sum(firstEdge_.begin(), firstEdge_.end(), firstEdge_.begin());
  edges_.resize(input.topology.edges.size());
  std::vector<std::uint32_t> next(firstEdge_.begin(), firstEdge_.end() - 1);
  for (std::uint32_t e = 0; e < edges_.size(); ++e) {
    edges_[next[input.topology.edges[e].left]++] = e;
  }
  build(0, count);
  buildBlocks(placements);
}

double SweepTree::squaredDistance(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  const Eigen::Vector3d u = b - a, v = d - c, w = a - c;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w),
               vw = v.dot(w), det = uu * vv - uv * uv;
  double s = det > 1e-12 * uu * vv ? std::clamp((uv * vw - vv * uw) / det, 0.0, 1.0) : 0;
  const double t = vv > 0 ? std::clamp((vw + s * uv) / vv, 0.0, 1.0) : 0;
  s = uu > 0 ? std::clamp((t * uv - uw) / uu, 0.0, 1.0) : 0;
  return (w + s * u - t * v).squaredNorm();
}

std::uint32_t SweepTree::build(std::uint32_t begin, std::uint32_t end) {
  const auto number = static_cast<std::uint32_t>(balls_.size());
  balls_.emplace_back();
  Eigen::AlignedBox3d box;
  const auto forCorners = [&](const auto& use) {
    for (std::uint32_t n = begin; n < end; ++n) {
      for (const std::int32_t v : input_.body.triangles[faces_[n]]) use(input_.body.vertices[v]);
    }
  };
  forCorners([&](const Eigen::Vector3d& x) { box.extend(x); });
  Ball ball;
  ball.arm = box.center() - centre_;
  ball.distance = ball.arm.norm() * kRoom;
  double square = 0;
  forCorners([&](const Eigen::Vector3d& x) {
    square = std::max(square, (x - box.center()).squaredNorm());
  });
  ball.radius = std::sqrt(square) * kRoom;
  ball.begin = begin;
  ball.end = end;
  if (end - begin > kLeafFaces) {
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const auto sumOf = [&](std::uint32_t face) {
      const auto& t = input_.body.triangles[face];
      const auto& v = input_.body.vertices;
      return v[t[0]][axis] + v[t[1]][axis] + v[t[2]][axis];
    };
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(faces_.begin() + begin, faces_.begin() + middle, faces_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double x = sumOf(a), y = sumOf(b);
                       return x < y || (x == y && a < b);
                     });
    ball.left = build(begin, middle);
    ball.right = build(middle, end);
  }
  balls_[number] = ball;
  return number;
}

void SweepTree::buildBlocks(const std::vector<Placement>& placements) {
  using Map = Eigen::Array<double, 12, 1>;
  struct Box {
    Map low, high;
  };
  std::vector<Box> boxes;
  for (const Placement& p : placements) {
    Map map;
    map << p.rotation.reshaped().array(), p.apply(centre_).array();
    boxes.push_back({map, map});
  }
  const auto add = [](Box& box, const Box& other) {
    box.low = box.low.min(other.low);
    box.high = box.high.max(other.high);
  };
  for (std::size_t k = 0; k < input_.motion.steps(); ++k) add(boxes[k], boxes[k + 1]);
  for (;;) {
    std::vector<Block> blocks;
    for (const Box& box : boxes) {
      const Map middle = (box.low + box.high) / 2, half = (box.high - box.low) / 2;
      blocks.push_back({middle.head<9>().matrix().reshaped(3, 3), middle.tail<3>().matrix(),
                        half.tail<3>().matrix().norm() * kRoom,
                        half.head<9>().matrix().norm() * kRoom});
    }
    levels_.push_back(std::move(blocks));
    if (boxes.size() <= 1) return;
    for (std::size_t n = 0; n < boxes.size(); ++n) {
      if (n % 2 == 0) {
        boxes[n / 2] = boxes[n];
      } else {
        add(boxes[n / 2], boxes[n]);
      }
    }
    boxes.resize((boxes.size() + 1) / 2);
  }
}

}  // namespace swept
