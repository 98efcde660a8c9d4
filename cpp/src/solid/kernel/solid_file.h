// Writes and reads kernel shapes as STEP or BREP files. The caller must hold a KernelSession.
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

/// Writes the text of a STEP file with the kernel's own translator, which adds the parameter curves
/// of curved faces. text/step_text.h writes files without them.
void writeStepFile(const TopoDS_Shape& shape, std::ostream& out, const std::string& targetName,
                   const SolidOptions& options, KernelSession& kernel, RunContext& run);
/// Maps a solid to the name of its product (the innermost one in an assembly). The key is the shape
/// without its location, which is the same for all instances of the solid.
using ProductNames = std::unordered_map<const TopoDS_TShape*, std::string>;
/// Reads a shape with the default settings of the kernel. The kernel then computes parameter curves
/// and tolerances itself. `names`, unless null, receives the names of the solids.
TopoDS_Shape readStepFile(const std::string& path, KernelSession& kernel, RunContext& run,
                          ProductNames* names = nullptr);
/// Does the same with a text in memory.
TopoDS_Shape readStepText(std::istream& text, KernelSession& kernel, RunContext& run);
/// Reads a file that has plane faces only. The kernel does not change the shape and uses the
/// tolerance (mm) that the file states. This takes a fifth of the time of readStepFile().
TopoDS_Shape readFlatStepFile(const std::string& path, double tolerance, KernelSession& kernel,
                              RunContext& run);
/// Reads a file that has mostly plane faces. Plane triangles stay unchanged; the kernel heals only
/// the other faces.
TopoDS_Shape readMostlyFlatStepFile(const std::string& path, KernelSession& kernel,
                                    RunContext& run);
void writeBrep(const TopoDS_Shape& shape, std::ostream& out, RunContext& run);
TopoDS_Shape readBrepFile(const std::string& path, RunContext& run);

}  // namespace swept::step
