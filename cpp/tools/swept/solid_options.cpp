// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_SOLID
#include "solid_options.h"

#include <cstdio>

namespace swept::cli {

void addSolidOptions(CLI::App& app, StepOptions& options) {
  constexpr const char* kGroup = "Options of solids (step, stp, brep, brp)";
  const auto in = [](CLI::Option* option) { option->group(kGroup); };
  in(addNumber(app, "--solid-tolerance", "MM", options.tolerance,
               "the solid may leave the mesh by this; surfaces are recognised, the rest is "
               "simplified (default 0: flat regions are merged; more only as the limits ask)"));
  in(addInteger(app, "--max-faces", options.maxFaces, 4, std::int64_t{1} << 31U,
                "at most this many faces (default 20000)"));
  in(addNumber(app, "--max-megabytes", "N", options.maxMegabytes,
               "at most this much in the file (default: no limit)"));
  in(addConverted(
      app, "--schema", "ap214|ap242|ap242-tessellated",
      [&options](const std::string& text) { options.schema = parseStepSchema(text); },
      "of the STEP file; tessellated: the mesh as it is (default ap214)"));
  in(app.add_flag("--exact", options.exact,
                  "never leave the mesh: above a limit refuse instead of simplifying"));
  in(app.add_flag_callback(
      "--facets", [&options] { options.recognise = false; }, "plane faces only"));
  in(addText(app, "--author", "TEXT", options.author, "for the header of the STEP file"));
  in(addText(app, "--organization", "TEXT", options.organization, "for the header too"));
  in(addText(app, "--product", "TEXT", options.productName, "name of the product"));
}

void printSolid(const StepReport& solid, const std::string& path) {
  std::string kinds;
  for (const auto& [kind, count] : solid.facesByKind) {
    kinds += (kinds.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
  }
  std::printf("%s: %lld solid(s), %lld faces (%s), %.3g MB, deviation %.3g mm, %.1f s\n",
              path.c_str(), static_cast<long long>(solid.solids),
              static_cast<long long>(solid.faces), kinds.c_str(),
              static_cast<double>(solid.fileBytes) / 1e6, solid.deviation,
              solid.secondsBuild + solid.secondsWrite + solid.secondsReread);
}

}  // namespace swept::cli
#endif
