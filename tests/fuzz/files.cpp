// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <string>

#include "fuzz/promise.h"
#include "fuzz/targets.h"
#include "support/temporary_folder.h"
#include "swept/compute.h"
#include "swept/io.h"

namespace swept::fuzz {
namespace {

/// Writes the bytes to a file, which is then read by its name like a user's file.
std::string fileOf(const std::uint8_t* data, std::size_t size, const std::string& suffix) {
  static const test::TemporaryFolder folder;
  return folder.write("fuzz" + suffix, {reinterpret_cast<const char*>(data), size});
}

void requireRefused(const Error& error) {
  requireNamed("a file", error, {Status::InvalidInput, Status::ResourceLimit});
}

}  // namespace

void motionFile(const std::uint8_t* data, std::size_t size) {
  const std::string file = fileOf(data, size, ".csv");
  try {
    const Trajectory motion = readTrajectoryCsv(file, 1000, Interpolation::Linear);
    if (motion.poses.empty()) throw BrokenPromise("a motion file without poses is taken");
    for (const Pose& pose : motion.poses) {
      if (!pose.translation.allFinite() && motion.poses.size() < 1000000) {
        // The conversion from metres to millimetres may overflow. The trajectory check refuses such
        // values.
        continue;
      }
      if (!pose.rotation.coeffs().allFinite()) throw BrokenPromise("a rotation is not finite");
    }
  } catch (const Error& error) {
    requireRefused(error);
  }
}

void meshFile(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return;
  constexpr std::array<const char*, 4> kSuffixes{".ply", ".stl", ".obj", ".off"};
  const std::string file = fileOf(data + 1, size - 1, kSuffixes[data[0] % kSuffixes.size()]);
  try {
    const TriMesh mesh = readMesh(file, 1);
    const auto count = static_cast<std::int64_t>(mesh.vertices.size());
    for (const auto& triangle : mesh.triangles) {
      for (const std::int32_t v : triangle) {
        if (v < 0 || v >= count) throw BrokenPromise("a file gives an index out of range");
      }
    }
  } catch (const Error& error) {
    requireRefused(error);
  }
}

}  // namespace swept::fuzz
