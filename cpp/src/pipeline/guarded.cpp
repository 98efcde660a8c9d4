// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/guarded.h"

#include <exception>
#include <new>

namespace swept {
namespace {

/// Empties the result and writes the failure to its report. `remedy` is advice for the user,
/// appended to the message.
void fail(Result& result, Status status, const char* code, const char* message,
          const char* remedy = "") {
  result.mesh = TriMesh{};
  result.contactTime = {};
  result.featureEdges = {};
  result.sources = {};
  result.kept.reset();
  result.report.status = status;
  try {
    result.report.code = code;
    result.report.message = message;
    result.report.message += remedy;
  } catch (const std::bad_alloc&) {
    // Both texts are short enough to need no allocation.
    result.report.status = Status::OutOfMemory;
    result.report.code = "OutOfMemory";
    result.report.message = "out of memory";
  }
}

/// Advice for a failure with an unexpected exception.
constexpr const char* kReport =
    ". This is a fault of the program, which another cell size may avoid; please report it with "
    "the part, the motion and the options";

}  // namespace

void failAsThrown(Result& result) {
  try {
    throw;
  } catch (const Error& error) {
    const bool unforeseen = error.code() == "InternalError";
    fail(result, error.status(), error.code().c_str(), error.what(), unforeseen ? kReport : "");
  } catch (const std::bad_alloc&) {
    fail(result, Status::OutOfMemory, "OutOfMemory",
         "memory ran out, although the estimate was within the limit; use a larger cell");
  } catch (const std::exception& error) {
    fail(result, Status::InternalError, "InternalError", error.what(), kReport);
  }
}

}  // namespace swept
