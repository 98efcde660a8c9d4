// Prints a table of GPU against CPU sampling on this machine: seconds by stage, memory, equality.
// Usage: swept-gpu-bench DATA [RESOLUTION...], where DATA is the folder of cases.json with its
// meshes and motions.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "swept/compute.h"
#include "swept/io.h"

namespace {

using namespace swept;

constexpr auto kNone = Interpolation::None, kLinear = Interpolation::Linear;

struct Body {
  const char *name, *mesh;
  double unit;
  const char* arc;  ///< motion with 16 keys; that of the fandisk, scaled, if the body has none
  double arcUnit;
};
const Body kBodies[] = {
    {"bunny", "bunny_stanford_70k.ply", 1e3, "keyposes_16_arc_for_bunny.csv", 1e3},
    {"fandisk", "fandisk_13k.ply", 1e3, "keyposes_16_arc_for_fandisk.csv", 1e3},
    {"gripper", "gripper_robotiq_2f140_30k.ply", 1, "keyposes_16_arc_for_fandisk.csv", 100},
    {"housing", "housing_two_halves_360k_thin.ply", 1, "keyposes_16_arc_for_fandisk.csv", 100}};

struct Path {
  const char *name, *file;
  double unit;
  Interpolation interpolation;
};
std::vector<Path> pathsOf(const Body& body) {
  return {{"still", "static_1_pose.csv", 1, kNone},
          {"keys16", body.arc, body.arcUnit, kLinear},
          {"path34", "installation_34_from_baxter_left.csv", 1e3, kLinear},
          {"vibration", "vibration_sensor_193200.csv.xz", 1, kNone}};
}

double stageSeconds(const Report& report, const std::string& name) {
  double sum = 0;
  for (const auto& s : report.seconds) sum += s.stage == name ? s.seconds : 0;
  return sum;
}

void row(const std::string& name, int resolution, const char* backend, const Result& r,
         const std::string& parity) {
  std::printf("| %s | %d | %s | %.3f | %.3f | %.3f | %.3f | %.0f | %s |\n", name.c_str(),
              resolution, backend, stageSeconds(r.report, "sampling"),
              stageSeconds(r.report, "signs"), stageSeconds(r.report, "winners"),
              stageSeconds(r.report, "total"), static_cast<double>(r.report.peakMemoryBytes) / 1e6,
              parity.c_str());
  std::fflush(stdout);
}

/// Prints two rows of the table. Returns the name of the device; empty if there is none.
std::string compareBackends(const std::string& name, const TriMesh& mesh, const Trajectory& motion,
                            int resolution) {
  Options options;
  options.resolution = resolution;
  RunContext run;
  options.backend = Backend::Cpu;
  const Result cpu = compute(mesh, motion, options, run);
  row(name, resolution, "cpu", cpu, statusName(cpu.report.status));
  options.backend = Backend::Gpu;
  const Result gpu = compute(mesh, motion, options, run);
  if (gpu.report.status != Status::Ok) {
    row(name, resolution, "gpu", gpu, gpu.report.message);
    return {};
  }
  const bool same =
      gpu.mesh.vertices == cpu.mesh.vertices && gpu.mesh.triangles == cpu.mesh.triangles;
  row(name, resolution, "gpu", gpu, same ? "same bytes" : "DIFFERS");
  return gpu.report.device;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "use: %s DATA [resolution ...] [--only PART_OF_NAME]\n", argv[0]);
    return 2;
  }
  const std::string data = argv[1];
  std::string only;
  std::vector<int> resolutions;
  for (int n = 2; n < argc; ++n) {
    if (std::string(argv[n]) == "--only" && n + 1 < argc) {
      only = argv[++n];
    } else {
      resolutions.push_back(std::atoi(argv[n]));
    }
  }
  if (resolutions.empty()) resolutions = {512, 1024};
  std::string device;
  std::printf("| case | r | sampler | pass 1 / sampling s | signs s | pass 2 s | total s | MB | ");
  std::printf("parity |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  try {
    for (const Body& body : kBodies) {
      const TriMesh mesh = readMesh(data + "/meshes/" + body.mesh, body.unit);
      for (const Path& path : pathsOf(body)) {
        const std::string name = std::string(body.name) + "_" + path.name;
        if (name.find(only) == std::string::npos) continue;
        const Trajectory motion =
            readTrajectoryCsv(data + "/motions/" + path.file, path.unit, path.interpolation);
        for (const int resolution : resolutions) {
          // A software rasteriser would take hours for long motions, and its times are not useful.
          if (device.find("llvmpipe") != std::string::npos && motion.poses.size() > 1000) continue;
          const std::string found = compareBackends(name, mesh, motion, resolution);
          if (!found.empty()) device = found;
        }
      }
    }
  } catch (const Error& error) {
    std::fprintf(stderr, "%s: %s\n", error.code().c_str(), error.what());
    return 1;
  }
  std::printf("\ndevice: %s\n", device.empty() ? "none" : device.c_str());
  return 0;
}
