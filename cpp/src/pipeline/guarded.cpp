// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/guarded.h"

#include <exception>
#include <new>

#include "base/fault_text.h"

namespace swept {
namespace {

/// Empties the result and writes the failure to its report. `isFault`: the program itself has a
/// fault, and the message asks the user to report it.
void fail(Result& result, Status status, const char* code, const char* message,
          bool isFault = false) {
  result.mesh = TriMesh{};
  result.contactTime = {};
  result.featureEdges = {};
  result.sources = {};
  result.kept.reset();
  result.report.status = status;
  try {
    result.report.code = code;
    result.report.message = message;
    if (isFault)
      result.report.message += faultText("the part, the motion and the options") +
                               ". Another cell size may avoid the fault";
  } catch (const std::bad_alloc&) {
    // Both texts are short enough to need no allocation.
    result.report.status = Status::OutOfMemory;
    result.report.code = "OutOfMemory";
    result.report.message = "out of memory";
  }
}

}  // namespace

void failAsThrown(Result& result) {
  try {
    throw;
  } catch (const Error& error) {
    const bool isFault = error.code() == "InternalError";
    fail(result, error.status(), error.code().c_str(), error.what(), isFault);
  } catch (const std::bad_alloc&) {
    fail(result, Status::OutOfMemory, "OutOfMemory",
         "memory ran out, although the estimate was within the limit; use a larger cell");
  } catch (const std::exception& error) {
    fail(result, Status::InternalError, "InternalError", error.what(), true);
  }
}

}  // namespace swept
