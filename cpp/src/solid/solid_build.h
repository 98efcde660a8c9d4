// Mesh -> model and kernel shape within the limits of the options: what writing a solid and trying
// it out have in common.
// In: closed mesh, mm. Out: the shape, and what it stands for. Cost: see kernel/shape_maker.h, a
// few times that where a limit asks for a tolerance. The caller holds the KernelSession. Throws
// Error(ExportFailed, ...), Error(OutOfMemory), Error(Cancelled).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_ErrorHandler.hxx>
#include <Standard_Failure.hxx>
#include <ios>
#include <new>
#include <ostream>
#include <string>

#include "solid/kernel/kernel.h"
#include "solid/kernel/shape_maker.h"
#include "solid/mesh/half_edge.h"
#include "swept/solid.h"

namespace swept::step {

/// Throws Error(ExportFailed, "BadOption").
void checkOptions(const StepOptions& options);

/// Of the file, about.
double megabytesOf(std::int64_t faces, const HalfEdgeMesh& mesh, const StepOptions& options,
                   SolidFormat format);

/// Without what lies within a tolerance, mm.
HalfEdgeMesh thinned(const HalfEdgeMesh& mesh, double limit, RunContext& run);

/// If the tolerance is as large as the body, its surface may turn inside out; then tries half of
/// it.
template <class Work>
auto uprightWithin(double& tolerance, const Work& work) {
  constexpr int kHalvings = 8;
  for (int n = 0;; ++n) {
    try {
      return work();
    } catch (const Error& error) {
      if (error.code() != "InvertedShell" || n == kHalvings) throw;
      tolerance /= 2;
    }
  }
}

/// With the given tolerance, or with the smallest of a series that meets the limits; `options` then
/// contains the one that was used.
Built buildWithinLimits(const HalfEdgeMesh& mesh, StepOptions& options, SolidFormat format,
                        KernelSession& kernel, RunContext& run);

/// The text of the file; name: that of the file, for its header.
void writeBuilt(const Built& built, std::ostream& out, const std::string& name,
                const StepOptions& options, SolidFormat format, RunContext& run);

bool isWorthFacets(const Error& error);

/// work(options), which may write into them; where that fails for the sake of surfaces, once more
/// with simplified facets alone. why: receives what failed then, else nothing.
template <class Work>
auto orFacets(const StepOptions& options, std::string& why, const Work& work) {
  StepOptions used = options;
  why.clear();
  try {
    return work(used);
  } catch (const Error& error) {
    if (used.tolerance <= 0 || !options.recognise || !isWorthFacets(error)) throw;
    why = error.what();
  }
  used.recognise = false;
  return work(used);
}

[[noreturn]] void refuseKernelFailure(const Standard_Failure& failure, const KernelSession& kernel,
                                      RunContext& run);
[[noreturn]] void refuseMemory(std::size_t triangles);

/// Runs work() with what the kernel throws told as an Error. triangles: of the mesh.
template <class Work>
auto withKernel(const KernelSession& kernel, std::size_t triangles, RunContext& run,
                const Work& work) {
  try {
    OCC_CATCH_SIGNALS
    return work();
  } catch (const Standard_Failure& failure) {
    refuseKernelFailure(failure, kernel, run);
  } catch (const std::bad_alloc&) {
    refuseMemory(triangles);
  } catch (const std::ios_base::failure& failure) {
    throw Error(Status::ExportFailed, "WriteFailed",
                std::string("writing failed: ") + failure.what());
  }
}

}  // namespace swept::step
