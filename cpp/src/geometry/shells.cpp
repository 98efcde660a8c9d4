// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/shells.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "base/parallel.h"
#include "base/union_find.h"

namespace swept {
namespace {

constexpr std::size_t kShellBlock = 1 << 14;

/// The extents of the shells within one block of triangles, in the order of their first triangles.
using Parts = std::vector<std::pair<std::int32_t, ShellExtent>>;

Parts measureBlock(const TriMesh& mesh, const Shells& shells,
                   const std::vector<Eigen::Vector3d>& origins, std::size_t begin,
                   std::size_t end) {
  Parts parts;
  std::unordered_map<std::int32_t, std::size_t> indexOfShell;
  std::size_t index = 0;
  for (std::size_t t = begin; t < end; ++t) {
    const std::int32_t s = shells.ofTriangle[t];
    if (parts.empty() || parts[index].first != s) {
      const auto [it, fresh] = indexOfShell.try_emplace(s, parts.size());
      if (fresh) parts.emplace_back(s, ShellExtent{});
      index = it->second;
    }
    ShellExtent& part = parts[index].second;
    if (part.first < 0) part.first = static_cast<std::int32_t>(t);
    part.last = static_cast<std::int32_t>(t);
    const auto& tri = mesh.triangles[t];
    const auto &a = mesh.vertices[tri[0]], &b = mesh.vertices[tri[1]], &c = mesh.vertices[tri[2]];
    part.volume += (a - origins[s]).dot((b - a).cross(c - a)) / 6;
    part.box.extend(a).extend(b).extend(c);
  }
  return parts;
}

}  // namespace

Shells shellsByEdges(const RawArray<std::uint32_t>& across) {
  Shells shells;
  auto& parent = shells.ofTriangle;
  parent = singleSets<std::int32_t>(across.size() / 3);
  parallelBlocks(parent.size(), kShellBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = across[3 * t + k];
        if (other == kNoNeighbour || other / 3 >= t) continue;
        unite(parent, static_cast<std::int32_t>(t), static_cast<std::int32_t>(other / 3));
      }
    }
  });
  // Roots come before their members, so one pass replaces links by shell numbers.
  for (std::size_t t = 0; t < parent.size(); ++t) {
    const bool isRoot = parent[t] == static_cast<std::int32_t>(t);
    parent[t] = isRoot ? shells.count++ : parent[parent[t]];
  }
  return shells;
}

std::vector<std::int32_t> smallestJoinedVertices(const TriMesh& mesh) {
  auto parent = singleSets<std::int32_t>(mesh.vertices.size());
  parallelBlocks(mesh.triangles.size(), kShellBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      unite(parent, a, b);
      unite(parent, b, c);
    }
  });
  for (std::size_t v = 0; v < parent.size(); ++v) parent[v] = parent[parent[v]];
  return parent;
}

Shells shellsByVertices(const TriMesh& mesh) {
  const std::vector<std::int32_t> piece = smallestJoinedVertices(mesh);
  std::vector<std::int32_t> number(piece.size(), -1);
  Shells shells;
  shells.ofTriangle.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    std::int32_t& shell = number[piece[t[0]]];
    if (shell < 0) shell = shells.count++;
    shells.ofTriangle.push_back(shell);
  }
  return shells;
}

std::vector<ShellExtent> measureShells(const TriMesh& mesh, const Shells& shells) {
  std::vector<Eigen::Vector3d> origins;
  origins.reserve(shells.count);
  for (std::size_t t = 0; std::ssize(origins) < shells.count; ++t) {
    if (shells.ofTriangle[t] != std::ssize(origins)) continue;
    origins.push_back(mesh.vertices[mesh.triangles[t][0]]);
  }
  std::vector<Parts> blocks((mesh.triangles.size() + kShellBlock - 1) / kShellBlock);
  parallelFor(blocks.size(), [&](std::size_t i) {
    blocks[i] = measureBlock(mesh, shells, origins, i * kShellBlock,
                             std::min(mesh.triangles.size(), (i + 1) * kShellBlock));
  });
  std::vector<ShellExtent> extents(shells.count);
  for (const Parts& parts : blocks) {
    for (const auto& [s, part] : parts) {
      ShellExtent& whole = extents[s];
      whole.box.extend(part.box);
      whole.volume += part.volume;
      if (whole.first < 0) whole.first = part.first;
      whole.last = part.last;
    }
  }
  return extents;
}

bool liesStrictlyInside(const Eigen::AlignedBox3d& inner, const Eigen::AlignedBox3d& outer) {
  return (inner.min().array() > outer.min().array()).all() &&
         (inner.max().array() < outer.max().array()).all();
}

Eigen::Vector3d pointOnTriangle(const TriMesh& mesh, std::int32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return 0.3137 * mesh.vertices[a] + 0.2731 * mesh.vertices[b] + 0.4132 * mesh.vertices[c];
}

std::vector<std::int32_t> ShellNesting::shellsAround(std::int32_t triangle) const {
  const Eigen::Vector3d p = pointOnTriangle(mesh_, triangle);
  std::vector<RayColumns::Crossing> line;
  columns_.crossings(p.y(), p.z(), line);
  std::vector<std::int32_t> crossed;
  for (const auto& crossing : line) {
    const std::int32_t s = shells_.ofTriangle[crossing.triangle];
    if (crossing.x > p.x() && s != shells_.ofTriangle[triangle]) crossed.push_back(s);
  }
  std::sort(crossed.begin(), crossed.end());
  std::vector<std::int32_t> around;
  for (std::size_t i = 0; i < crossed.size();) {
    std::size_t end = i + 1;
    while (end < crossed.size() && crossed[end] == crossed[i]) ++end;
    if ((end - i) % 2 == 1) around.push_back(crossed[i]);
    i = end;
  }
  return around;
}

}  // namespace swept
