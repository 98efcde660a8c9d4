// Kernel shape <-> STEP or BREP file. The caller holds the KernelSession.
// Throws Error(ExportFailed, "WriteFailed" | "RereadFailed" | "KernelFailure"), Error(Cancelled).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <istream>
#include <ostream>
#include <string>

#include "solid/kernel/kernel.h"
#include "swept/solid.h"

namespace swept::step {

/// By the kernel's own translator, which knows the parameter curves of curved faces. (Solids of
/// plane faces only are written by step_text.h.)
void writeStepFile(const TopoDS_Shape& shape, const std::string& path,
                   const std::string& targetName, const StepOptions& options, KernelSession& kernel,
                   RunContext& run);
/// The shape as the kernel usually reads it: it finds parameter curves and tolerances by itself.
TopoDS_Shape readStepFile(const std::string& path, KernelSession& kernel, RunContext& run);
/// The same from memory.
TopoDS_Shape readStepText(std::istream& text, KernelSession& kernel, RunContext& run);
/// The shape as it stands in a file of plane faces, with the tolerance (mm) that the file states;
/// takes a fifth of the time.
TopoDS_Shape readFlatStepFile(const std::string& path, double tolerance, KernelSession& kernel,
                              RunContext& run);
/// The same for a file with some other faces: only those the kernel mends as it usually does, plane
/// triangles stay as they stand.
TopoDS_Shape readMostlyFlatStepFile(const std::string& path, KernelSession& kernel,
                                    RunContext& run);
void writeBrep(const TopoDS_Shape& shape, std::ostream& out, RunContext& run);
TopoDS_Shape readBrepFile(const std::string& path, RunContext& run);

}  // namespace swept::step
