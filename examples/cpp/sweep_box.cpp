// The envelope of a box that slides and turns, written as a mesh file.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cstdio>
#include <exception>
#include <string>

#include "swept/compute.h"
#include "swept/io.h"

namespace {

swept::TriMesh box(const Eigen::Vector3d& size) {
  swept::TriMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.vertices.push_back(
        {corner & 1 ? size.x() : 0, corner & 2 ? size.y() : 0, corner & 4 ? size.z() : 0});
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

swept::Trajectory slideAndTurn() {
  swept::Pose start, end;
  end.timeSeconds = 1;
  end.rotation = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ());
  end.translation = {50, 0, 0};
  return {{start, end}, swept::Interpolation::Screw};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "use: %s OUTPUT.ply\n", argv[0]);
    return 2;
  }
  try {
    swept::Options options;
    options.resolution = 64;
    swept::RunContext run;
    const swept::Result result = swept::compute(box({10, 20, 30}), slideAndTurn(), options, run);
    if (result.report.status != swept::Status::Ok) {
      std::fprintf(stderr, "%s: %s\n", swept::statusName(result.report.status),
                   result.report.message.c_str());
      return 1;
    }
    swept::writeMesh(result.mesh, argv[1]);
    std::printf("%lld triangles, %.6g mm^3\n",
                static_cast<long long>(result.report.check.triangles), result.report.check.volume);
  } catch (const swept::Error& error) {
    std::fprintf(stderr, "%s: %s\n", swept::statusName(error.status()), error.what());
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
