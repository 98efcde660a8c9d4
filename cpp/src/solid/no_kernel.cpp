// Replaces the geometry kernel in a build that has none. Solids are then made and read only with a
// reader that the application provides (swept/solid.h, swept/body.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/model/judge.h"
#include "swept/solid.h"
#include "swept/types.h"

namespace swept {
namespace step {

std::unique_ptr<Judge> openJudge() {
  throw Error(Status::ExportFailed, "NoKernel",
              "this build has no geometry kernel, which checks solids; write a mesh file, or use a "
              "program that was built with OpenCASCADE");
}

}  // namespace step

namespace {

[[noreturn]] void refuseToRead(const std::string& path) {
  throw Error(Status::InvalidInput, "BadFormat",
              "'" + path +
                  "': this program was built without OpenCASCADE and cannot read solids; give a "
                  "mesh (ply, stl, obj, off)");
}

}  // namespace

std::vector<ImportedSolid> readSolids(const std::string& path, double /*linearDeflection*/,
                                      double /*angularDeflection*/, RunContext& /*run*/,
                                      std::shared_ptr<const BodyShape>* /*shape*/) {
  refuseToRead(path);
}

std::shared_ptr<const BodyShape> readBodyShape(const std::string& path, RunContext& /*run*/) {
  refuseToRead(path);
}

SolidCheck checkSolidFile(const std::string& path, RunContext& /*run*/) { refuseToRead(path); }

}  // namespace swept
