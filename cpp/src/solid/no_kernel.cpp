// Stands for the kernel in a build without one: solids are then made only with a reader of the
// caller (swept/solid.h).
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/model/judge.h"
#include "swept/types.h"

namespace swept::step {

std::unique_ptr<Judge> openJudge() {
  throw Error(Status::ExportFailed, "NoKernel",
              "this build has no geometry kernel, which checks solids; write a mesh file, or use a "
              "program that was built with OpenCASCADE");
}

}  // namespace swept::step
