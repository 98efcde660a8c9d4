// swept clearance GENERATOR --motion CSV NEIGHBOUR...: smallest distances over a whole motion.
// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_CLEARANCE
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "arguments.h"
#include "base/limits.h"
#include "base/safe_file.h"
#include "commands.h"
#include "report_file.h"
#include "runner.h"
#include "swept/body.h"
#include "swept/clearance.h"
#include "swept/io.h"
#ifdef HAVE_SWEPT_SOLID
#include "swept/solid.h"
#endif

namespace swept::cli {

const char* const kClearanceHelp =
    R"(swept clearance GENERATOR --motion CSV NEIGHBOUR... [options]
  Smallest distance of GENERATOR, moved along the poses of CSV, to every NEIGHBOUR. Both: ply, stl,
  obj, off; with OpenCASCADE also step, stp, brep, brp (one neighbour a solid). Nothing between two poses
  is missed. Exit status 0 if all are clear, 3 if one is too near, touches or clashes.
  --required MM           distance asked for (default 0: contact and clash only)
  --tolerance MM          how far the smallest distance may be off (default 0.01)
  --interpolation I       none, linear or screw: motion between two poses (default linear)
  --generator-unit U, --neighbour-unit U, --motion-unit U    mm, cm, m or in (default mm)
  --generator-chord MM    how far the generator's triangles leave its exact surface (default 0)
  --neighbour-chord MM    the same for neighbours given as meshes (default 0)
  --deflection MM         chord error to which solids, the generator too, are tessellated
                          (default 0.05)
  --interval-tolerance MM travel to which ends of time intervals are found (default 10 tolerances)
  --curve N               points of the graph of distance over time (default 200)
  --no-penetration        do not measure how deep a clash goes
  --stamp N               compare with distances at every pose and N more in each step (slow)
  --csv FILE              write the table
  --report FILE.json      write the report, also of a failure; - for standard output
  --threads N             threads to use (default: all cores)
  --quiet                 no progress bar, no table
)";

namespace {

constexpr int kExitNotClear = 3;

struct ClearanceJob {
  std::string generatorPath;
  std::string motionPath;
  std::vector<std::string> neighbourPaths;
  std::string reportPath;
  std::string csvPath;
  double generatorUnit = 1.0;
  double neighbourUnit = 1.0;
  double motionUnit = 1.0;
  double neighbourChord = 0;
  double deflection = 0.05;
  Interpolation interpolation = Interpolation::Linear;
  ClearanceOptions options;
  std::int64_t threads = 0;
  std::int64_t stamp = -1;
  bool quiet = false;
};

ClearanceJob parseJob(const std::vector<std::string>& words) {
  ClearanceJob job;
  std::int64_t curve = job.options.curveSamples;
  Arguments a;
  a.text("--motion", job.motionPath);
  a.text("--report", job.reportPath);
  a.text("--csv", job.csvPath);
  a.number("--required", job.options.required);
  a.number("--tolerance", job.options.tolerance);
  a.number("--generator-chord", job.options.bodyChordError);
  a.number("--neighbour-chord", job.neighbourChord);
  a.number("--deflection", job.deflection);
  a.number("--interval-tolerance", job.options.intervalTolerance);
  a.with("--interpolation",
         [&](const std::string& t) { job.interpolation = parseInterpolation(t); });
  a.with("--generator-unit", [&](const std::string& t) { job.generatorUnit = parseLengthUnit(t); });
  a.with("--neighbour-unit", [&](const std::string& t) { job.neighbourUnit = parseLengthUnit(t); });
  a.with("--motion-unit", [&](const std::string& t) { job.motionUnit = parseLengthUnit(t); });
  a.integer("--curve", curve, 0, 1000000);
  a.integer("--stamp", job.stamp, 0, 1000000);
  a.integer("--threads", job.threads, 0, kMaxThreads);
  a.flag("--no-penetration", job.options.penetration, false);
  a.flag("--quiet", job.quiet);
  const std::vector<std::string> positional = a.parse(words);
  const auto bad = [](const std::string& text) {
    throw Error(Status::InvalidInput, "BadOption", text + "; see swept clearance --help");
  };
  if (positional.size() < 2) {
    bad("expected a generator and at least one neighbour, found " +
        std::to_string(positional.size()) + " files");
  }
  if (job.motionPath.empty()) bad("--motion CSV is missing");
  if (!(job.deflection > 0)) bad("--deflection must be greater than 0 mm");
  job.generatorPath = positional[0];
  job.neighbourPaths.assign(positional.begin() + 1, positional.end());
  job.options.curveSamples = static_cast<int>(curve);
  return job;
}

void readNeighbours(const std::string& path, const ClearanceJob& job,
                    [[maybe_unused]] RunContext& run, std::vector<ClearanceNeighbour>& out) {
  if (isSolidFile(path)) {
#ifdef HAVE_SWEPT_SOLID
    for (ImportedSolid& solid : readSolids(path, job.deflection, 0.2, run))
      out.push_back({solid.name, std::move(solid.mesh), job.deflection});
    return;
#else
    throw Error(Status::InvalidInput, "BadFormat",
                "'" + path +
                    "': this program was built without OpenCASCADE and cannot read solids; "
                    "give a mesh (ply, stl, obj, off)");
#endif
  }
  out.push_back(
      {pathFromUtf8(path).stem().string(), readMesh(path, job.neighbourUnit), job.neighbourChord});
}

void compareWithStamps(const ClearanceJob& job, const TriMesh& body, const Trajectory& motion,
                       const std::vector<ClearanceNeighbour>& parts, const ClearanceReport& report,
                       RunContext& run) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const StampedClearance least =
        stampedClearance(body, motion, parts[i].mesh, static_cast<int>(job.stamp), run);
    std::printf("stamped %lld poses against %s: smallest %.9g mm at t = %.9g s; motion %.9g mm\n",
                static_cast<long long>(least.poses), parts[i].name.c_str(), least.distance,
                least.timeSeconds, report.neighbours[i].distance);
  }
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

void writeCsv(const ClearanceReport& report, const std::string& path) {
  SafeFile file(path);
  file.stream() << "neighbour,verdict,distance_mm,guaranteed_mm,time_s,depth_mm,depth_bound_mm,"
                   "body_x,body_y,body_z,neighbour_x,neighbour_y,neighbour_z,seconds_below\n";
  file.stream().precision(12);
  for (const NeighbourClearance& row : report.neighbours) {
    double below = 0;
    for (const TimeInterval& span : row.below) below += span.to - span.from;
    file.stream() << quoted(row.name) << ',' << clearanceVerdictName(row.verdict) << ','
                  << row.distance << ',' << row.guaranteed << ',' << row.timeSeconds << ','
                  << row.penetration.depth << ',' << row.penetration.depthBound;
    for (const Eigen::Vector3d& x : {row.pointOnBody, row.pointOnNeighbour})
      file.stream() << ',' << x[0] << ',' << x[1] << ',' << x[2];
    file.stream() << ',' << below << '\n';
  }
  file.commit();
}

void writeJson(const ClearanceReport& report, const std::string& path) {
  if (path.empty()) return;
  const std::string text = toJson(report) + "\n";
  if (path == "-") {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return;
  }
  SafeFile file(path);
  file.stream() << text;
  file.commit();
}

void printTable(const ClearanceReport& report) {
  for (const NeighbourClearance& row : report.neighbours) {
    std::printf("%-28s %-8s %12.6g mm at t = %.6g s", row.name.c_str(),
                clearanceVerdictName(row.verdict), row.distance, row.timeSeconds);
    if (row.verdict == ClearanceVerdict::Clash && row.penetration.known)
      std::printf(", depth %.4g to %.4g mm", row.penetration.depth, row.penetration.depthBound);
    if (!row.below.empty()) std::printf(", %zu spans below", row.below.size());
    std::printf("  (%.2f s, %lld queries, %lld proofs)\n", row.seconds,
                static_cast<long long>(row.distanceQueries),
                static_cast<long long>(row.certificates));
  }
  std::printf("%s; %.2f s\n", report.summary.c_str(),
              report.seconds.empty() ? 0.0 : report.seconds.back().seconds);
  for (const Finding& finding : report.warnings)
    std::fprintf(stderr, "swept: note %s: %s\n", finding.code.c_str(), finding.text.c_str());
}

}  // namespace

int clearanceCommand(const std::vector<std::string>& words) {
  const ClearanceJob job = parseJob(words);
  checkReportTarget(job.reportPath);
  if (!job.csvPath.empty()) checkTarget(job.csvPath);
  ClearanceReport report;
  RunContext run;
  run.threads = static_cast<int>(job.threads);
  try {
    runWatched(run, job.quiet, [&] {
      const Body body = readBody(job.generatorPath, {job.generatorUnit, job.deflection, {}}, run);
      const Trajectory motion =
          readTrajectoryCsv(job.motionPath, job.motionUnit, job.interpolation);
      std::vector<ClearanceNeighbour> parts;
      for (const std::string& path : job.neighbourPaths) readNeighbours(path, job, run, parts);
      ClearanceOptions options = job.options;
      options.bodyChordError += body.chordError;
      report = checkClearance(body.mesh, motion, parts, options, run);
      report.warnings.insert(report.warnings.begin(), body.findings.begin(), body.findings.end());
      if (job.stamp >= 0 && report.status == Status::Ok)
        compareWithStamps(job, body.mesh, motion, parts, report, run);
    });
  } catch (const Error& error) {
    report = {};
    report.status = error.status();
    report.code = error.code();
    report.message = error.what();
  }
  writeJson(report, job.reportPath);
  if (report.status != Status::Ok) {
    printError(report.status, report.code, report.message);
    return exitStatus(report.status);
  }
  if (!job.csvPath.empty()) writeCsv(report, job.csvPath);
  if (!job.quiet && job.reportPath != "-") printTable(report);
  for (const NeighbourClearance& row : report.neighbours)
    if (row.verdict != ClearanceVerdict::Clear) return kExitNotClear;
  return kExitOk;
}

}  // namespace swept::cli
#endif  // HAVE_SWEPT_CLEARANCE
