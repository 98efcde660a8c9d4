// Kernel shape <-> STEP or BREP file. The caller holds the KernelSession.
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
/// (text/step_text.h writes solids of plane faces only.)
void writeStepFile(const TopoDS_Shape& shape, const std::string& path,
                   const std::string& targetName, const StepOptions& options, KernelSession& kernel,
                   RunContext& run);
/// Name of the product that a solid belongs to (the innermost one in an assembly). The key is the
/// shape without its location, which all instances of the solid have in common.
using ProductNames = std::unordered_map<const TopoDS_TShape*, std::string>;
/// The shape as the kernel reads it by default: it computes parameter curves and tolerances by
/// itself. `names`: of the solids, where asked for.
TopoDS_Shape readStepFile(const std::string& path, KernelSession& kernel, RunContext& run,
                          ProductNames* names = nullptr);
/// The same from memory.
TopoDS_Shape readStepText(std::istream& text, KernelSession& kernel, RunContext& run);
/// The shape of a file of plane faces, unchanged, with the tolerance (mm) that the file states;
/// takes a fifth of the time.
TopoDS_Shape readFlatStepFile(const std::string& path, double tolerance, KernelSession& kernel,
                              RunContext& run);
/// The same for a file that also has some other faces: the kernel heals only these; plane triangles
/// stay unchanged.
TopoDS_Shape readMostlyFlatStepFile(const std::string& path, KernelSession& kernel,
                                    RunContext& run);
void writeBrep(const TopoDS_Shape& shape, std::ostream& out, RunContext& run);
TopoDS_Shape readBrepFile(const std::string& path, RunContext& run);

}  // namespace swept::step
