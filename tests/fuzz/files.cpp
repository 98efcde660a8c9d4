// SPDX-License-Identifier: LGPL-2.1-or-later
#include <sys/mman.h>
#include <unistd.h>

#include <array>

#include "fuzz/promise.h"
#include "fuzz/targets.h"
#include "swept/compute.h"
#include "swept/io.h"

namespace swept::fuzz {
namespace {

/// A file in memory that is read through its name, as a user's file is.
class MemoryFile {
 public:
  MemoryFile(const std::uint8_t* data, std::size_t size) : handle_(memfd_create("fuzz", 0)) {
    while (size > 0) {
      const ssize_t written = write(handle_, data, size);
      if (written <= 0) throw std::runtime_error("the memory file takes no more bytes");
      data += written;
      size -= static_cast<std::size_t>(written);
    }
  }
  ~MemoryFile() { close(handle_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(handle_); }

 private:
  int handle_;
};

void requireRefused(const Error& error) {
  requireNamed("a file", error, {Status::InvalidInput, Status::ResourceLimit});
}

}  // namespace

void motionFile(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(data, size);
  try {
    const Trajectory motion = readTrajectoryCsv(file.path(), 1000, Interpolation::Linear);
    if (motion.poses.empty()) throw BrokenPromise("a motion file without poses is taken");
    for (const Pose& pose : motion.poses) {
      if (!pose.translation.allFinite() && motion.poses.size() < 1000000) {
        // Metres to millimetres may overflow: the trajectory check refuses that.
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
  const MemoryFile file(data + 1, size - 1);
  const std::string link =
      "/dev/shm/swept-fuzz-" + std::to_string(getpid()) + kSuffixes[data[0] % kSuffixes.size()];
  unlink(link.c_str());
  if (symlink(file.path().c_str(), link.c_str()) != 0) {
    throw std::runtime_error("no link in /dev/shm");
  }
  try {
    const TriMesh mesh = readMesh(link, 1);
    const auto count = static_cast<std::int64_t>(mesh.vertices.size());
    for (const auto& triangle : mesh.triangles) {
      for (const std::int32_t v : triangle) {
        if (v < 0 || v >= count) throw BrokenPromise("a file gives an index out of range");
      }
    }
  } catch (const Error& error) {
    requireRefused(error);
  }
  unlink(link.c_str());
}

}  // namespace swept::fuzz
