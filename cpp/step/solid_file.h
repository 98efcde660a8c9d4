// Kernel shape <-> STEP or BREP file. The caller holds the KernelSession.
// Throws Error(ExportFailed, "WriteFailed" | "RereadFailed" | "KernelFailure"), Error(Cancelled).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>

#include "kernel.h"
#include "swept/step_export.h"

namespace swept::step {

void writeStepFile(const TopoDS_Shape& shape, const std::string& path,
                   const std::string& targetName, const StepOptions& options, KernelSession& kernel,
                   RunContext& run);
TopoDS_Shape readStepFile(const std::string& path, KernelSession& kernel, RunContext& run);
void writeBrepFile(const TopoDS_Shape& shape, const std::string& path, RunContext& run);
TopoDS_Shape readBrepFile(const std::string& path, RunContext& run);

}  // namespace swept::step
