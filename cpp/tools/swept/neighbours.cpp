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

std::vector<ClearanceNeighbour> readNeighbours(const std::vector<std::string>& paths,
                                               const NeighbourFileOptions& options,
                                               [[maybe_unused]] RunContext& run) {
  std::vector<ClearanceNeighbour> list;
  for (const std::string& path : paths) {
    if (!isSolidFile(path)) {
      list.push_back({pathFromUtf8(path).stem().string(),
                      readMesh(path, options.millimetresPerUnit), options.chordError});
      continue;
    }
#ifdef HAVE_SWEPT_SOLID
    for (ImportedSolid& solid : readSolids(path, options.deflection, 0.2, run))
      list.push_back({solid.name, std::move(solid.mesh), options.deflection});
#else
    throw Error(Status::InvalidInput, "BadFormat",
                "'" + path +
                    "': this program was built without OpenCASCADE and cannot read solids; "
                    "give a mesh (ply, stl, obj, off)");
#endif
  }
  return list;
}

}  // namespace swept::cli
#endif  // HAVE_SWEPT_CLEARANCE
