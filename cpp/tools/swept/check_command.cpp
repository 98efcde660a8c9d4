// swept check FILE...: checks meshes and solids in files.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include "commands.h"
#include "files.h"
#include "options.h"
#include "runner.h"
#include "swept/compute.h"
#ifdef HAVE_SWEPT_SOLID
#include "swept/solid.h"
#endif

namespace swept::cli {

namespace {

std::string faultsOf(const MeshCheck& check) {
  std::string text;
  const auto add = [&text](std::int64_t count, const char* what) {
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + what;
  };
  add(check.openEdges, "open edges");
  add(check.nonManifoldEdges, "non-manifold edges");
  add(check.nonManifoldVertices, "non-manifold vertices");
  add(check.misorientedEdges, "misoriented edges");
  add(check.degenerateTriangles, "degenerate triangles");
  if (!check.finite)
    text += std::string(text.empty() ? "" : ", ") + "vertices with coordinates that are not finite";
  if (text.empty() && !check.oriented) text = "shells that are inside out";
  return text.empty() ? "not a closed surface" : text;
}

struct CheckJob {
  std::vector<std::string> paths;
  std::string format;
  double unit = 1.0;
  CommonOptions common;
};

// The result for one file.
struct Checked {
  Report report;
#ifdef HAVE_SWEPT_SOLID
  std::optional<SolidCheck> solid;
#endif
};

void fail(Report& report, const std::string& path, const std::string& faults) {
  takeError(report, Status::InvalidInput, "CheckFailed", "'" + path + "': " + faults);
}

// Checks one file. `file`: a name under which the content of `path` can be read several times.
// Messages contain `path`.
void checkFile(const std::string& file, const std::string& path, const CheckJob& job,
               RunContext& run, Checked& found) {
  if (isSolidIn(file, path, job.format)) {
#ifdef HAVE_SWEPT_SOLID
    found.solid = checkSolidFile(file, run);
    if (!found.solid->valid) fail(found.report, path, found.solid->complaint);
    return;
#else
    throw Error(
        Status::InvalidInput, "BadFormat",
        "'" + path + "': this program was built without OpenCASCADE and cannot read solids");
#endif
  }
  MeshCheck& check = found.report.check;
  check = checkMesh(meshFrom(file, path, job.format, job.unit), run);
  if (!check.passes()) fail(found.report, path, faultsOf(check));
}

void checkOne(const std::string& path, const CheckJob& job, RunContext& run, Checked& found) {
  readRepeatably(path, [&](const std::string& file) { checkFile(file, path, job, run, found); });
}

void print(const std::string& path, const Checked& found) {
#ifdef HAVE_SWEPT_SOLID
  if (found.solid) {
    const SolidCheck& solid = *found.solid;
    std::printf("%s: %lld solids, %lld shells, %lld faces, %s, volume %.6g mm^3\n", path.c_str(),
                static_cast<long long>(solid.solids), static_cast<long long>(solid.shells),
                static_cast<long long>(solid.faces), solid.valid ? "closed, valid" : "not valid",
                solid.volume);
    return;
  }
#endif
  const MeshCheck& check = found.report.check;
  if (check.triangles == 0) return;
  std::printf(
      "%s: %lld triangles, %lld shells, %s, %s, %s, %lld self-intersections, "
      "volume %.6g mm^3, area %.6g mm^2\n",
      path.c_str(), static_cast<long long>(check.triangles), static_cast<long long>(check.shells),
      check.closed ? "closed" : "open", check.manifold ? "manifold" : "not manifold",
      check.oriented ? "oriented" : "not oriented",
      static_cast<long long>(check.selfIntersections.value_or(-1)), check.volume, check.area);
}

Json jsonOf(const std::string& path, const Checked& found) {
  const Report& report = found.report;
  Json json = reportHead("check", report.status, report.code, report.message);
  json["input"] = path;
  json.update(checkJson(report.check));
#ifdef HAVE_SWEPT_SOLID
  if (found.solid) {
    const SolidCheck& solid = *found.solid;
    json["solid"] = {{"solids", solid.solids}, {"shells", solid.shells}, {"faces", solid.faces},
                     {"edges", solid.edges},   {"valid", solid.valid},   {"closed", solid.valid},
                     {"volume", solid.volume}};
  }
#endif
  return json;
}

int runCheck(const CheckJob& job) {
  const CommonOptions& common = job.common;
  std::vector<RoledFile> inputs;
  for (const std::string& path : job.paths) inputs.push_back({"the file to check", path});
  checkIdentity(inputs, {{"--report", common.report}}, common.noClobber);
  checkAccess({}, {{"--report", common.report}});
  int status = kExitOk;
  Json files = Json::array();
  for (const std::string& path : job.paths) {
    Checked found;
    RunContext run;
    run.threads = common.threads;
    try {
      checkAccess({{"", path}}, {});
      keepStreams({{"", path}});
      runWatched(run, common.quiet, [&] { checkOne(path, job, run, found); });
    } catch (const Error& error) {
      takeError(found.report, error.status(), error.code(), error.what());
    }
    if (!common.quiet && common.report != "-") print(path, found);
    const Report& report = found.report;
    if (report.status != Status::Ok) printError(report.status, report.code, report.message);
    files.push_back(jsonOf(path, found));
    status = std::max(status, exitStatus(report.status));
    if (report.status == Status::Cancelled) break;
  }
  if (files.size() == 1 && job.paths.size() == 1) {
    writeReport(files[0], common.report);
    return status;
  }
  const auto bad = std::find_if(files.begin(), files.end(),
                                [](const Json& file) { return file["status"] != "Ok"; });
  Json json = bad == files.end() ? reportHead("check", Status::Ok, "", "") : Json();
  if (bad != files.end()) {
    for (const char* key : {"report_version", "command", "status", "code", "message"})
      json[key] = (*bad)[key];
  }
  json["files"] = std::move(files);
  writeReport(json, common.report);
  return status;
}

}  // namespace

Run addCheckCommand(CLI::App& program) {
  const auto job = std::make_shared<CheckJob>();
  CLI::App& app =
      *program.add_subcommand("check",
                              "Checks whether meshes are closed, manifold and oriented, counts "
                              "intersecting triangles, and measures volume and area. Checks "
                              "whether the solids in STEP and BREP files are closed and valid.");
  app.add_option("FILE", job->paths,
                 "files to check, of type ply, stl, obj, off, step, stp, brep or brp, or - for "
                 "standard input")
      ->type_name("FILE")
      ->required();
  addText(app, "--format", "ply|stl|obj|off|step|brep", job->format,
          "format of the files, in place of their file extensions");
  addUnit(app, "--unit", job->unit, "unit of the numbers in files that are meshes (default mm)");
  addCommonOptions(app, job->common);
  app.footer(
      "Exit status 0 only if every mesh is closed, manifold, oriented and without degenerate "
      "triangles,\nand every solid is valid.\n\nExamples:\n  swept check envelope.ply\n"
      "  swept check parts/*.stl --report -\n  cat a.stl | swept check - --format stl");
  return [job] { return runCheck(*job); };
}

}  // namespace swept::cli
