// swept check MESH: what the mesh checker finds in a file.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cstdio>

#include "arguments.h"
#include "base/limits.h"
#include "commands.h"
#include "report_file.h"
#include "runner.h"
#include "swept/compute.h"
#include "swept/io.h"

namespace swept::cli {

const char* const kCheckHelp =
    R"(swept check MESH [options]
  Checks a mesh: closed, manifold, oriented, self-intersections, volume, area.
  Exit status 0 only if it is closed, manifold, oriented and without degenerate triangles.
  --unit mm|cm|m|in       unit of the numbers in the file (default mm)
  --report FILE.json      write what was found as JSON; - for standard output
  --threads N             threads to use (default: all cores)
  --quiet                 no progress bar, no summary
)";

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
  if (!check.finite) text += std::string(text.empty() ? "" : ", ") + "vertices that are not finite";
  if (text.empty() && !check.oriented) text = "shells that are inside out";
  return text.empty() ? "not a closed surface" : text;
}

}  // namespace

int checkCommand(const std::vector<std::string>& words) {
  std::string reportPath;
  double unit = 1.0;
  std::int64_t threads = 0;
  bool quiet = false;
  Arguments arguments;
  arguments.with("--unit", [&](const std::string& text) { unit = parseLengthUnit(text); });
  arguments.text("--report", reportPath);
  arguments.integer("--threads", threads, 0, kMaxThreads);
  arguments.flag("--quiet", quiet);
  const std::vector<std::string> positional = arguments.parse(words);
  if (positional.size() != 1) {
    throw Error(Status::InvalidInput, "BadOption",
                "expected one mesh file, found " + std::to_string(positional.size()) +
                    "; see swept check --help");
  }

  Report report;
  RunContext run;
  run.threads = static_cast<int>(threads);
  checkReportTarget(reportPath);
  try {
    runWatched(run, quiet, [&] { report.check = checkMesh(readMesh(positional[0], unit), run); });
    if (!report.check.passes()) {
      report.status = Status::InvalidInput;
      report.code = "CheckFailed";
      report.message = "'" + positional[0] + "': " + faultsOf(report.check);
    }
  } catch (const Error& error) {
    report.status = error.status();
    report.code = error.code();
    report.message = error.what();
  }
  writeReport(report, reportPath, [&](JsonWriter& json) { json.field("file", positional[0]); });
  const MeshCheck& check = report.check;
  if (!quiet && reportPath != "-" && check.triangles > 0) {
    std::printf(
        "%s: %lld triangles, %lld shells, %s, %s, %s, %lld self-intersections, "
        "volume %.6g mm^3, area %.6g mm^2\n",
        positional[0].c_str(), static_cast<long long>(check.triangles),
        static_cast<long long>(check.shells), check.closed ? "closed" : "open",
        check.manifold ? "manifold" : "not manifold", check.oriented ? "oriented" : "not oriented",
        static_cast<long long>(check.selfIntersections), check.volume, check.area);
  }
  if (report.status != Status::Ok) printError(report.status, report.code, report.message);
  return exitStatus(report.status);
}

}  // namespace swept::cli
