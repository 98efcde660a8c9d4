// Prints a table that compares GPU and CPU sampling on this machine: seconds by stage, memory, and
// whether the results are equal. Usage: swept-gpu-bench DATA [RESOLUTION...] [--only PART_OF_NAME]
// [--limit SECONDS], where DATA is the folder of cases.json with its meshes and motions. A run that
// takes longer than the limit (default 60 s) is ended.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
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
    {"housing", "housing_two_halves_360k_thin.ply", 1, "keyposes_16_arc_for_fandisk.csv", 100},
    {"gear", "differential_ring_gear_58k.ply", 1, "keyposes_16_arc_for_fandisk.csv", 100}};

struct Path {
  const char *name, *file;
  double unit;
  Interpolation interpolation;
};
std::vector<Path> pathsOf(const Body& body) {
  return {{"still", "static_1_pose.csv", 1, kNone},
          {"keys16", body.arc, body.arcUnit, kLinear},
          {"path34", "installation_34_from_baxter_left.csv", 1e3, kLinear},
          {"vibration", "vibration_sensor_193200.csv.xz", 1, kNone},
          {"recording", "vibration_sensor_193200.csv.xz", 1, kLinear}};
}

double stageSeconds(const Report& report, const std::string& name) {
  double sum = 0;
  for (const auto& s : report.seconds) sum += s.stage == name ? s.seconds : 0;
  return sum;
}

void row(const std::string& name, int resolution, const char* backend, const Result& r,
         const std::string& outcome) {
  std::printf("| %s | %d | %s | %.3f | %.3f | %.3f | %.3f | %.0f | %s |\n", name.c_str(),
              resolution, backend, stageSeconds(r.report, "sampling"),
              stageSeconds(r.report, "signs"), stageSeconds(r.report, "winners"),
              stageSeconds(r.report, "total"), static_cast<double>(r.report.peakMemoryBytes) / 1e6,
              outcome.c_str());
  std::fflush(stdout);
}

/// Computes the envelope, but not for longer than `limit` seconds.
Result computeWithin(double limit, const TriMesh& mesh, const Trajectory& motion,
                     const Options& options) {
  RunContext run;
  std::mutex mutex;
  std::condition_variable changed;
  bool isDone = false;
  std::thread watch([&] {
    std::unique_lock lock(mutex);
    if (!changed.wait_for(lock, std::chrono::duration<double>(limit), [&] { return isDone; })) {
      run.cancel();
    }
  });
  Result result = compute(mesh, motion, options, run);
  {
    const std::lock_guard lock(mutex);
    isDone = true;
  }
  changed.notify_one();
  watch.join();
  return result;
}

/// Prints a row for each sampler, and one for the choice of `auto`. Returns the name of the device;
/// empty if there is none.
std::string compareBackends(const std::string& name, const TriMesh& mesh, const Trajectory& motion,
                            int resolution, double limit) {
  Options options;
  options.resolution = resolution;
  options.backend = Backend::Cpu;
  const Result cpu = computeWithin(limit, mesh, motion, options);
  row(name, resolution, "cpu", cpu, statusName(cpu.report.status));
  options.backend = Backend::Gpu;
  const Result gpu = computeWithin(limit, mesh, motion, options);
  const bool bothEnded = cpu.report.status == Status::Ok && gpu.report.status == Status::Ok;
  const bool same =
      gpu.mesh.vertices == cpu.mesh.vertices && gpu.mesh.triangles == cpu.mesh.triangles;
  row(name, resolution, "gpu", gpu,
      !bothEnded ? statusName(gpu.report.status)
      : same     ? "same bytes"
                 : "DIFFERS");
  options.backend = Backend::Auto;
  const Result chosen = computeWithin(limit, mesh, motion, options);
  row(name, resolution, "auto", chosen,
      chosen.report.status == Status::Ok ? chosen.report.backend
                                         : statusName(chosen.report.status));
  for (const Finding& finding : chosen.report.warnings) {
    if (finding.code == "CpuSampler")
      std::fprintf(stderr, "%s: %s\n", name.c_str(), finding.text.c_str());
  }
  return gpu.report.device;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "use: %s DATA [resolution ...] [--only PART_OF_NAME] [--limit SECONDS]\n",
                 argv[0]);
    return 2;
  }
  const std::string data = argv[1];
  std::string only;
  double limit = 60;
  std::vector<int> resolutions;
  for (int n = 2; n < argc; ++n) {
    if (std::string(argv[n]) == "--only" && n + 1 < argc) {
      only = argv[++n];
    } else if (std::string(argv[n]) == "--limit" && n + 1 < argc) {
      limit = std::atof(argv[++n]);
    } else {
      resolutions.push_back(std::atoi(argv[n]));
    }
  }
  if (resolutions.empty()) resolutions = {512, 1024};
  std::string device;
  std::printf("| case | r | sampler | pass 1 / sampling s | signs s | pass 2 s | total s | MB | ");
  std::printf("result |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
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
          const std::string found = compareBackends(name, mesh, motion, resolution, limit);
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
