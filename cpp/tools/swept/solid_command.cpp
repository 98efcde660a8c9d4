// swept solid MESH --output FILE: a closed mesh becomes a STEP or BREP file.
// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_SOLID
#include "base/limits.h"
#include "commands.h"
#include "report_file.h"
#include "runner.h"
#include "solid_options.h"
#include "swept/io.h"

namespace swept::cli {

// The options of solids follow; see main.cpp.
const char* const kSolidHelp =
    R"(swept solid MESH --output FILE [options]
  Makes a solid of a closed mesh (ply, stl, obj, off); FILE ends in step, stp, brep or brp. The file
  is read back and checked before it replaces an old one.
  --unit mm|cm|m|in       unit of the numbers in the mesh (default mm)
  --report FILE.json      write what was made as JSON; - for standard output
  --threads N             threads to use (default: all cores)
  --quiet                 no progress bar, no summary
  and the options of solids, see swept --help
)";

int solidCommand(const std::vector<std::string>& words) {
  std::string outputPath, reportPath;
  double unit = 1.0;
  std::int64_t threads = 0;
  bool quiet = false;
  StepOptions options;
  Arguments arguments;
  arguments.text("--output", outputPath);
  arguments.with("--unit", [&](const std::string& text) { unit = parseLengthUnit(text); });
  arguments.text("--report", reportPath);
  arguments.integer("--threads", threads, 0, kMaxThreads);
  arguments.flag("--quiet", quiet);
  addSolidOptions(arguments, options);
  const std::vector<std::string> positional = arguments.parse(words);
  if (positional.size() != 1 || outputPath.empty()) {
    throw Error(Status::InvalidInput, "BadOption",
                "expected one mesh file and --output FILE; see swept solid --help");
  }
  Report report;
  StepReport solid;
  RunContext run;
  run.threads = static_cast<int>(threads);
  checkReportTarget(reportPath);
  try {
    runWatched(run, quiet, [&] {
      const TriMesh mesh = readMesh(positional[0], unit);
      solid = writeSolid(mesh, outputPath, options, run);
    });
  } catch (const Error& error) {
    report.status = error.status();
    report.code = error.code();
    report.message = error.what();
  }
  const bool ok = report.status == Status::Ok;
  writeReport(report, reportPath, [&](JsonWriter& json) {
    json.field("output", ok ? outputPath : std::string());
    if (ok) writeSolidFields(solid, json);
  });
  if (!ok) printError(report.status, report.code, report.message);
  if (ok && !quiet && reportPath != "-") printSolid(solid, outputPath);
  return exitStatus(report.status);
}

}  // namespace swept::cli
#endif
