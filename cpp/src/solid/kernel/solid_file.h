// Writes kernel shapes to STEP and BREP files, and reads them. The caller holds the KernelSession.
// Throws Error(ExportFailed, "WriteFailed" | "RereadFailed" | "KernelFailure"), Error(Cancelled).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <istream>
#include <ostream>
#include <string>
#include <unordered_map>

#include "solid/kernel/kernel.h"
#include "swept/solid.h"

namespace swept::step {

/// Writes with the kernel's own translator, which adds the parameter curves of curved faces.
/// text/step_text.h is faster, but omits these curves.
void writeStepFile(const TopoDS_Shape& shape, const std::string& path,
                   const std::string& targetName, const StepOptions& options, KernelSession& kernel,
                   RunContext& run);
/// Maps a solid to the name of its product (the innermost one in an assembly). The key is the shape
/// without its location, which all instances of the solid share.
using ProductNames = std::unordered_map<const TopoDS_TShape*, std::string>;
/// Reads the shape as the kernel does by default: the kernel computes parameter curves and
/// tolerances. `names`, unless null, receives the names of the solids.
TopoDS_Shape readStepFile(const std::string& path, KernelSession& kernel, RunContext& run,
                          ProductNames* names = nullptr);
/// Does the same with a text in memory.
TopoDS_Shape readStepText(std::istream& text, KernelSession& kernel, RunContext& run);
/// Reads a file of plane faces without healing them, in a fifth of the time. `tolerance`: mm, as
/// stated in the file; tolerances of the shape are limited to it.
TopoDS_Shape readFlatStepFile(const std::string& path, double tolerance, KernelSession& kernel,
                              RunContext& run);
/// Reads a file that has some other faces besides plane triangles. The kernel heals only these
/// others.
TopoDS_Shape readMostlyFlatStepFile(const std::string& path, KernelSession& kernel,
                                    RunContext& run);
void writeBrep(const TopoDS_Shape& shape, std::ostream& out, RunContext& run);
TopoDS_Shape readBrepFile(const std::string& path, RunContext& run);

}  // namespace swept::step
