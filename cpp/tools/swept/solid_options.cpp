// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_SOLID
#include "solid_options.h"

#include <cstdio>

#include "base/number_text.h"

namespace swept::cli {

void addSolidOptions(CLI::App& app, SolidOptions& options) {
  constexpr const char* kGroup = "Options for solid output (step, stp, brep, brp)";
  const auto in = [](CLI::Option* option) { option->group(kGroup); };
  in(addNumber(app, "--solid-tolerance", "MM", options.tolerance,
               "how far the solid may deviate from the mesh. Above 0, surfaces such as cylinders "
               "are recognised, and the rest is simplified (default 0: only flat regions are "
               "merged, unless a limit below is exceeded)"));
  in(addInteger(app, "--max-faces", options.maxFaces, 4, std::int64_t{1} << 31U,
                "largest number of faces (default 20000). A solid with more faces is simplified "
                "until it fits; with --solid-tolerance, it is refused"));
  in(addNumber(app, "--max-megabytes", "N", options.maxMegabytes,
               "largest size of the file in MB (default 0: no limit). A solid with a larger file "
               "is simplified or refused, as with --max-faces"));
  in(addConverted(
      app, "--schema", "ap214|ap242|ap242-tessellated",
      [&options](const std::string& text) { options.schema = parseStepSchema(text); },
      "schema of the STEP file (default ap214). ap242-tessellated writes the triangles of the mesh "
      "unchanged"));
  in(app.add_flag("--exact", options.exact,
                  "never deviate from the mesh: a solid above a limit is refused, not simplified"));
  in(app.add_flag_callback(
      "--facets", [&options] { options.recognise = false; },
      "make plane faces only; recognise no curved surfaces"));
  in(addText(app, "--author", "TEXT", options.author,
             "author named in the header of the STEP file"));
  in(addText(app, "--organization", "TEXT", options.organization,
             "organisation named in the header of the STEP file"));
  in(addText(app, "--product", "TEXT", options.productName,
             "name of the product in the STEP file"));
}

void printSolid(const WrittenSolid& solid, const std::string& path) {
  std::string kinds;
  for (const auto& [kind, count] : solid.facesByKind) {
    kinds += (kinds.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
  }
  std::printf("%s: %s, %lld faces (%s), %.3g MB, deviation %.3g mm, %.1f s\n", path.c_str(),
              counted(solid.solids, "solid").c_str(), static_cast<long long>(solid.faces),
              kinds.c_str(), static_cast<double>(solid.fileBytes) / 1e6, solid.deviation,
              solid.secondsBuild + solid.secondsWrite + solid.secondsReread);
}

}  // namespace swept::cli
#endif
