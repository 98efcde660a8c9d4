// swept overlap PART PART ...: measures distances, depths and shared volumes of still parts.
// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_CLEARANCE
#include <algorithm>
#include <cstdio>
#include <locale>
#include <memory>
#include <sstream>

#include "commands.h"
#include "neighbours.h"
#include "reported_run.h"
#include "swept/io.h"
#include "swept/overlap.h"

namespace swept::cli {
namespace {

struct OverlapJob {
  NeighbourFiles files;
  std::string csvPath, sharedPath;
  OverlapOptions options;
  CommonOptions common;
};

void addOptions(CLI::App& app, OverlapJob& job) {
  app.add_option("PART", job.files.paths,
                 "two or more parts: files of type ply, stl, obj, off, step, stp, brep or brp. "
                 "Each solid of a file is a part")
      ->type_name("FILE")
      ->required();
  addUnit(app, "--unit", job.files.millimetresPerUnit,
          "unit of the numbers in parts that are meshes (default mm)");
  addNumber(app, "--part-chord", "MM", job.files.chordError,
            "how far the triangles of parts that are meshes deviate from their exact surfaces "
            "(default 0)");
  keepEarlierName(app, "--chord", "--part-chord");
  addNumber(app, "--deflection", "MM", job.files.deflection,
            "how far the triangles of solids may deviate from their surfaces (default 0.05)");
  addDistanceOptions(app, job.options);
  addText(app, "--shared", "FILE", job.sharedPath,
          "write the shared volumes of all pairs as one mesh of type ply, stl, obj, off or 3mf, or "
          "- for standard output as ply");
  addText(app, "--csv", "FILE", job.csvPath,
          "write the results as a CSV table, or - for standard output");
  addCommonOptions(app, job.common);
  app.footer(
      "Exit status 0 if all pairs are apart, 3 if a pair is below the required distance, in "
      "contact or in clash.\n\n"
      "Examples:\n"
      "  swept overlap envelope_left.ply envelope_right.ply --shared shared.ply\n"
      "  swept overlap reserved.step frame.step --required 5 --csv -");
}

void writeCsv(const OverlapReport& report, const std::string& path) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "first,second,verdict,distance_mm,guaranteed_mm,depth_mm,depth_bound_mm,volume_mm3,"
          "first_x,first_y,first_z,second_x,second_y,second_z\n";
  text.precision(12);
  for (const PairOverlap& pair : report.pairs) {
    const NeighbourClearance& row = pair.clearance;
    text << quoted(report.names[pair.parts.first]) << ',' << quoted(report.names[pair.parts.second])
         << ',' << clearanceVerdictName(row.verdict) << ',' << row.distance << ',' << row.guaranteed
         << ',' << row.penetration.depth << ',' << row.penetration.depthBound << ',';
    if (pair.volume) text << *pair.volume;
    for (const Eigen::Vector3d& x : {row.pointOnBody, row.pointOnNeighbour})
      text << ',' << x[0] << ',' << x[1] << ',' << x[2];
    text << '\n';
  }
  writeText(text.str(), path);
}

void printTable(const OverlapReport& report) {
  for (const PairOverlap& pair : report.pairs) {
    const NeighbourClearance& row = pair.clearance;
    std::printf("%-36s %-8s %12.6g mm", row.name.c_str(), clearanceVerdictName(row.verdict),
                row.distance);
    if (row.verdict == ClearanceVerdict::Clash && row.penetration.known)
      std::printf(", depth %.4g to %.4g mm", row.penetration.depth, row.penetration.depthBound);
    if (!pair.volume)
      std::printf(", shared volume not known");
    else if (*pair.volume > 0)
      std::printf(", %.6g mm^3 shared", *pair.volume);
    std::printf("\n");
  }
  std::printf("%s; %.2f s\n", report.summary.c_str(),
              report.seconds.empty() ? 0.0 : report.seconds.back().seconds);
}

/// Returns all shared volumes as one mesh.
TriMesh joined(const OverlapReport& report) {
  TriMesh all;
  for (const PairOverlap& pair : report.pairs) {
    const auto first = static_cast<std::int32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), pair.shared.vertices.begin(),
                        pair.shared.vertices.end());
    for (const auto& tri : pair.shared.triangles)
      all.triangles.push_back({tri[0] + first, tri[1] + first, tri[2] + first});
  }
  return all;
}

void checkShared(const std::string& path) {
  if (path.empty() || path == "-" || isMeshSuffix(suffixOf(path))) return;
  badOption("--shared '" + path + "': unknown format '" + suffixOf(path) +
            "'; allowed: ply, stl, obj, off, 3mf");
}

void writeShared(const OverlapReport& report, const std::string& path) {
  const TriMesh all = joined(report);
  if (all.triangles.empty())
    throw Error(Status::ExportFailed, "NothingShared",
                "'" + path + "' is not written, because no two of the parts share a volume (" +
                    report.summary + ")");
  writeOutputFile(path, "ply", [&](const std::string& file) { writeMesh(all, file); });
}

OverlapReport compute(const OverlapJob& job, RunContext& run) {
  std::vector<ClearanceNeighbour> read = readNeighbours(job.files, run);
  makeNamesUnique(read);
  std::vector<OverlapPart> parts;
  for (ClearanceNeighbour& part : read)
    parts.push_back({std::move(part.name), std::move(part.mesh), part.chordError});
  return checkOverlaps(parts, job.options, run);
}

int runOverlap(const OverlapJob& job) {
  const CommonOptions& common = job.common;
  std::vector<RoledFile> inputs;
  for (const std::string& path : job.files.paths) inputs.push_back({"a part", path});
  const std::vector<RoledFile> outputs{
      {"--csv", job.csvPath}, {"--report", common.report}, {"--shared", job.sharedPath}};
  const auto report = runReported<OverlapReport>(
      common, inputs, outputs, [&](RunContext& run) { return compute(job, run); },
      [&](const OverlapReport& found) {
        if (!job.csvPath.empty()) writeCsv(found, job.csvPath);
        if (!job.sharedPath.empty()) writeShared(found, job.sharedPath);
      });
  if (report.status != Status::Ok) return exitStatus(report.status);
  const bool isTaken = common.report == "-" || job.csvPath == "-" || job.sharedPath == "-";
  if (!common.quiet && !isTaken) printTable(report);
  return finishReported(report, common,
                        std::all_of(report.pairs.begin(), report.pairs.end(),
                                    [](const auto& pair) { return pair.clearance.meetsRule(); }));
}

}  // namespace

Run addOverlapCommand(CLI::App& program) {
  const auto job = std::make_shared<OverlapJob>();
  CLI::App& app =
      *program.add_subcommand("overlap",
                              "Compares all pairs of parts that stand still: measures the smallest "
                              "distance, or the depth of the overlap and the shared volume.");
  addOptions(app, *job);
  return [job] {
    checkNeighbourOptions(job->files, "");
    checkShared(job->sharedPath);
    return runOverlap(*job);
  };
}

}  // namespace swept::cli
#endif  // HAVE_SWEPT_CLEARANCE
