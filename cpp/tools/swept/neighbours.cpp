// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef HAVE_SWEPT_CLEARANCE
#include "neighbours.h"

#include "base/safe_file.h"
#include "swept/body.h"
#include "swept/io.h"
#ifdef HAVE_SWEPT_SOLID
#include "swept/solid.h"
#endif

namespace swept::cli {

CLI::Option* addNeighbourOptions(CLI::App& app, NeighbourFiles& files) {
  CLI::Option* option =
      app.add_option("NEIGHBOUR", files.paths,
                     "parts that stand still: ply, stl, obj, off, step, stp, brep, brp; one "
                     "neighbour a solid");
  option->type_name("FILE")->required();
  addUnit(app, "--neighbour-unit", files.millimetresPerUnit, "unit of neighbours that are meshes");
  addNumber(app, "--neighbour-chord", "MM", files.chordError,
            "how far the triangles of neighbours given as meshes leave their exact surfaces "
            "(default 0)");
  addNumber(app, "--deflection", "MM", files.deflection,
            "chord error to which solids, the moving one too, are tessellated (default 0.05)");
  return option;
}

void checkNeighbourOptions(const NeighbourFiles& files) {
  if (!(files.deflection > 0)) badOption("--deflection must be greater than 0 mm");
}

std::vector<ClearanceNeighbour> readNeighbours(const NeighbourFiles& files,
                                               [[maybe_unused]] RunContext& run) {
  std::vector<ClearanceNeighbour> list;
  for (const std::string& path : files.paths) {
    if (!isSolidFile(path)) {
      list.push_back({pathFromUtf8(path).stem().string(), readMesh(path, files.millimetresPerUnit),
                      files.chordError});
      continue;
    }
#ifdef HAVE_SWEPT_SOLID
    for (ImportedSolid& solid : readSolids(path, files.deflection, 0.2, run))
      list.push_back({solid.name, std::move(solid.mesh), files.deflection});
#else
    throw Error(Status::InvalidInput, "BadFormat",
                "'" + path +
                    "': this program was built without OpenCASCADE and cannot read solids; "
                    "give a mesh (ply, stl, obj, off)");
#endif
  }
  return list;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace swept::cli
#endif  // HAVE_SWEPT_CLEARANCE
