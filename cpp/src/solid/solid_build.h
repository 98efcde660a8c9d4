// Builds a solid from a mesh within the limits of the options. Export and trial estimate share this
// code.
// In: closed mesh, mm. Out: the model and the kernel shape. Cost: that of kernel/shape_maker.h, or
// a few times that if the tolerance must be searched to meet a limit. The caller holds the
// KernelSession. Throws Error(ExportFailed, ...), Error(OutOfMemory), Error(Cancelled).
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

/// Returns the approximate size of the file.
double megabytesOf(std::int64_t faces, const HalfEdgeMesh& mesh, const StepOptions& options,
                   SolidFormat format);

/// Returns a copy with fewer triangles that deviates by at most about `limit` (mm).
HalfEdgeMesh thinned(const HalfEdgeMesh& mesh, double limit, RunContext& run);

/// Runs work() and returns its result. If the tolerance is as large as the body, the surface may
/// turn inside out; then halves the tolerance and tries again, up to eight times.
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

/// Builds with the tolerance of the options. If this is 0 and the exact solid exceeds a limit, uses
/// the smallest tolerance of a series that meets the limits, and stores it in `options`.
Built buildWithinLimits(const HalfEdgeMesh& mesh, StepOptions& options, SolidFormat format,
                        KernelSession& kernel, RunContext& run);

/// Writes the text of the file. `name`: the name of the file, for its header.
void writeBuilt(const Built& built, std::ostream& out, const std::string& name,
                const StepOptions& options, SolidFormat format, RunContext& run);

/// Returns whether a solid with facets only may succeed after this error.
bool isWorthFacets(const Error& error);

/// Runs work() with a copy of the options, which it may change, and returns its result. If that
/// fails because of recognised surfaces, runs work() once more with facets only. `why` then
/// receives the message of the failure; otherwise it is empty.
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

/// Runs work() and converts exceptions of the kernel to Error. `triangles`: their number in the
/// mesh, for the message.
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
