// Builds the model of a mesh within the limits of the options. Writing a solid and estimating its
// cost both use these functions.
// In:      closed mesh, mm.
// Out:     the model, which the judge has accepted.
// Cost:    see shape_maker.h; a few times as much if the limits require a search for a
//          tolerance.
// Throws Error(ExportFailed, ...), Error(OutOfMemory), Error(Cancelled).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ios>
#include <new>
#include <ostream>
#include <string>

#include "solid/mesh/half_edge.h"
#include "solid/model/judge.h"
#include "solid/shape_maker.h"
#include "swept/solid.h"

namespace swept::step {

/// Throws Error(ExportFailed, "BadOption") if an option is out of its range.
void checkOptions(const SolidOptions& options);

/// Returns the approximate size of the file in megabytes.
double megabytesOf(std::int64_t faces, const HalfEdgeMesh& mesh, const SolidOptions& options,
                   SolidFormat format);

/// Returns the mesh, thinned so that its surface moves by at most `limit` (mm).
HalfEdgeMesh thinned(const HalfEdgeMesh& mesh, double limit, RunContext& run);

/// Returns work(). If a tolerance as large as the body turns the surface inside out, halves the
/// tolerance and tries again.
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

/// Builds the solid with the given tolerance. If that is 0, tries 0 and then a series of
/// tolerances, and takes the first for which the solid is within the limits. `options` receives the
/// tolerance that was used.
Built buildWithinLimits(const HalfEdgeMesh& mesh, SolidOptions& options, SolidFormat format,
                        Judge& judge, RunContext& run);

/// Writes the text of the file. `name` is the file name for the header.
void writeBuilt(const Built& built, Judge& judge, std::ostream& out, const std::string& name,
                const SolidOptions& options, SolidFormat format, RunContext& run);

/// Returns whether a solid of facets only may succeed after this error.
bool isWorthFacets(const Error& error);

/// Returns work(options), which may change its copy of the options. If it fails because of the
/// exact faces of the sweep, calls it again without these. If it fails because of recognised
/// surfaces, calls it again without these, so that all faces are facets. `why` receives the message
/// of the failure that led to facets only; empty if there was none.
template <class Work>
auto orFacets(const SolidOptions& options, std::string& why, const Work& work) {
  SolidOptions used = options;
  why.clear();
  if (options.origin != nullptr) {
    try {
      return work(used);
    } catch (const Error& error) {
      if (!isWorthFacets(error)) throw;
    }
    used = options;
    used.origin.reset();
  }
  try {
    return work(used);
  } catch (const Error& error) {
    if (used.tolerance <= 0 || !options.recognise || !isWorthFacets(error)) throw;
    why = error.what();
  }
  used.recognise = false;
  return work(used);
}

[[noreturn]] void refuseMemory(std::size_t triangles);

/// Calls work(). Converts exceptions of the kernel and of the system to an Error. `triangles`:
/// number of triangles in the mesh, for the message.
template <class Work>
void withJudge(Judge& judge, std::size_t triangles, RunContext& run, const Work& work) {
  try {
    judge.guard(work, run);
  } catch (const std::bad_alloc&) {
    refuseMemory(triangles);
  } catch (const std::ios_base::failure& failure) {
    throw Error(Status::ExportFailed, "WriteFailed",
                std::string("the file could not be written (") + failure.what() +
                    "); check the free space, and the permissions of its folder");
  }
}

}  // namespace swept::step
