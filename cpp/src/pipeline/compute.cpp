// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/compute.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <new>
#include <optional>

#include "base/memory.h"
#include "base/threads.h"
#include "base/timer.h"
#include "input/options_check.h"
#include "pipeline/envelope_run.h"
#include "pipeline/guarded.h"
#include "pipeline/kept_surface.h"
#include "swept/preview.h"

namespace swept {
namespace {

/// Whether freed memory goes back to the operating system after the run. A preview session keeps
/// this memory for its next run.
enum class Freed : std::uint8_t { Returned, Kept };

/// Calls work() with an EnvelopeRun, in a task arena with the requested number of threads. Writes
/// the outcome to the report. Only this arena is limited; other work of the process continues
/// unchanged.
template <class Work>
Result runWith(const Options& options, RunContext& run, Freed freed, const Work& work) {
  Result result;
  const Timer total;
  std::optional<MemoryWatch> memory;
  guarded(result, [&] {
    memory.emplace();
    const int threads = threadsOf(run);
    result.report.threads = threads;
    tbb::task_arena arena(threads);
    arena.execute([&] {
      EnvelopeRun one(options, run, result);
      work(one);
    });
    run.checkpoint(Phase::Done);
  });
  const auto close = [&] {
    result.report.seconds.push_back({"total", total.seconds()});
    if (memory) result.report.peakMemoryBytes = memory->peakBytes();
    if (freed == Freed::Returned) returnFreeMemory();
  };
  if (result.report.status == Status::Ok) {
    guarded(result, close);
  } else {
    try {
      close();
      // The report already names the failure; only some figures are missing.
    } catch (const std::bad_alloc&) {
    }
  }
  return result;
}

}  // namespace

Result compute(const TriMesh& body, const Trajectory& trajectory, const Options& options,
               RunContext& run) {
  return runWith(options, run, Freed::Returned,
                 [&](EnvelopeRun& one) { one.compute(body, trajectory); });
}

struct PreviewSession::Warm : WarmBody {
  Options options;
};

PreviewSession::PreviewSession(const TriMesh& body, const Options& options, RunContext& run) {
  auto warm = std::make_unique<Warm>();
  warm->options = options;
  warm->options.tolerance = 0;
  checkOptions(warm->options);
  warm->setBody(checkBody(body, warm->options, run));
  warm_ = std::move(warm);
}
PreviewSession::~PreviewSession() {
  if (warm_ == nullptr) return;  // the session has been moved from
  warm_.reset();
  returnFreeMemory();
}
PreviewSession::PreviewSession(PreviewSession&&) noexcept = default;
PreviewSession& PreviewSession::operator=(PreviewSession&&) noexcept = default;

Result PreviewSession::compute(const Trajectory& trajectory, RunContext& run) {
  return runWith(warm_->options, run, Freed::Kept,
                 [&](EnvelopeRun& one) { one.compute(*warm_, trajectory, false); });
}

Result PreviewSession::sketch(const Trajectory& trajectory, RunContext& run) {
  return runWith(warm_->options, run, Freed::Kept, [&](EnvelopeRun& one) {
    if (warm_->options.conservative) {
      throw Error(Status::InvalidInput, "BadOption",
                  "a preview cannot be conservative; compute the envelope instead");
    }
    one.compute(*warm_, trajectory, true);
  });
}

std::int64_t PreviewSession::stepsKept() const { return warm_->cache.hits(); }

void recut(Result& result, double tolerance, RunContext& run) {
  Options requested;
  requested.tolerance = tolerance;
  checkOptions(requested);
  if (!result.kept) {
    throw Error(Status::InvalidInput, "NothingKept",
                "the unsimplified surface was not kept, because the envelope was computed without "
                "a simplification tolerance; compute it again, with a tolerance");
  }
  Result next;
  next.kept = result.kept;
  next.report = result.report;
  tbb::task_arena arena(threadsOf(run));
  arena.execute([&] { cutKept(next, tolerance, run); });
  result = std::move(next);
}

}  // namespace swept
