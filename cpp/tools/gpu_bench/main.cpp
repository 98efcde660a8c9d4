// Table of GPU against CPU sampling on this machine: seconds by stage, memory, parity.
// Use: swept-gpu-bench DATA [resolution ...], DATA = folder with cases.json's meshes and motions.
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

struct Case {
  const char *name, *mesh, *motion;
  double meshUnit, motionUnit;
  Interpolation interpolation;
};

constexpr auto kNone = Interpolation::None, kLinear = Interpolation::Linear;
const Case kCases[] = {
    {"fandisk_still", "fandisk_13k.ply", "static_1_pose.csv", 1e3, 1e3, kNone},
    {"bunny_still", "bunny_stanford_70k.ply", "static_1_pose.csv", 1e3, 1e3, kNone},
    {"housing_still", "housing_two_halves_360k_thin.ply", "static_1_pose.csv", 1, 1, kNone},
    {"fandisk_keys16", "fandisk_13k.ply", "keyposes_16_arc_for_fandisk.csv", 1e3, 1e3, kLinear},
    {"bunny_keys16", "bunny_stanford_70k.ply", "keyposes_16_arc_for_bunny.csv", 1e3, 1e3, kLinear},
    {"gripper_path34", "gripper_robotiq_2f140_30k.ply", "installation_34_from_baxter_left.csv", 1,
     1e3, kLinear},
    {"bunny_vibration", "bunny_stanford_70k.ply", "vibration_sensor_193200.csv.xz", 1e3, 1e3,
     kNone},
};

double stageSeconds(const Report& report, const std::string& name) {
  double sum = 0;
  for (const auto& s : report.seconds) sum += s.stage == name ? s.seconds : 0;
  return sum;
}

void row(const Case& c, int resolution, const char* backend, const Result& r,
         const std::string& parity) {
  std::printf("| %s | %d | %s | %.3f | %.3f | %.3f | %.3f | %.0f | %s |\n", c.name, resolution,
              backend, stageSeconds(r.report, "sampling"), stageSeconds(r.report, "signs"),
              stageSeconds(r.report, "winners"), stageSeconds(r.report, "total"),
              static_cast<double>(r.report.peakMemoryBytes) / 1e6, parity.c_str());
  std::fflush(stdout);
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
    for (const Case& c : kCases) {
      if (std::string(c.name).find(only) == std::string::npos) continue;
      const TriMesh mesh = readMesh(data + "/meshes/" + c.mesh, c.meshUnit);
      const Trajectory path =
          readTrajectoryCsv(data + "/motions/" + c.motion, c.motionUnit, c.interpolation);
      for (const int resolution : resolutions) {
        Options options;
        options.resolution = resolution;
        RunContext run;
        options.backend = Backend::Cpu;
        const Result cpu = compute(mesh, path, options, run);
        row(c, resolution, "cpu", cpu, statusName(cpu.report.status));
        options.backend = Backend::Gpu;
        const Result gpu = compute(mesh, path, options, run);
        if (gpu.report.status != Status::Ok) {
          row(c, resolution, "gpu", gpu, gpu.report.message);
          continue;
        }
        device = gpu.report.device;
        const bool same =
            gpu.mesh.vertices == cpu.mesh.vertices && gpu.mesh.triangles == cpu.mesh.triangles;
        row(c, resolution, "gpu", gpu, same ? "same bytes" : "DIFFERS");
      }
    }
  } catch (const Error& error) {
    std::fprintf(stderr, "%s: %s\n", error.code().c_str(), error.what());
    return 1;
  }
  std::printf("\ndevice: %s\n", device.empty() ? "none" : device.c_str());
  return 0;
}
