// Finds paths for parts that are installed one after the other. Each installed part is an obstacle
// for the parts after it.
// In:    parts, each with its goal and either a task for a search (path.h) or a given motion; parts
//        that always stand still; rules for pairs. All in world coordinates. Units: mm, s, rad.
// Out:   for each part a motion that the clearance check finds clear of all parts installed before,
//        and all motions on one time axis. If there is none: which part was blocked, by which
//        parts, and how far it came.
// Order: given, or found by disassembly: a part that can be taken out from among the remaining
//        parts is removed, and the resulting order is reversed. A part that can be taken out among
//        many parts can also be taken out among fewer, so it does not matter which one is removed
//        first.
// Cost:  in a given order one search for each part. To find an order, the searches for a part
//        become longer from round to round. They are repeated when a part that was in its way has
//        been removed.
// Promise: a sequence is returned only if it is certified. The same seed gives the same answer with
//        any number of threads, unless the time limit ends a search.
// Source: R. Wilson, J.-C. Latombe, Geometric reasoning about mechanical assembly (1994): order by
//        disassembly, one part at a time. Y. Tian et al., Assemble them all (2022): the effort of
//        the searches grows from round to round.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "swept/mechanism.h"
#include "swept/path.h"

namespace swept {

struct SequencePart {
  std::string name;  ///< different for each part
  TriMesh mesh;
  double chordError = 0;  ///< mm, how far the triangles may deviate from the exact surface
  PathTask task;          ///< its goal, and how it gets there
  /// A motion that ends at the goal, in place of a search. If set, `task` is ignored.
  std::optional<Trajectory> motion = {};
};

/// A part that stands still all the time.
struct StillPart {
  std::string name;
  TriMesh mesh;
  double chordError = 0;  ///< mm, how far the triangles may deviate from the exact surface
};

struct SequenceOptions {
  /// Options of all searches. The time limit is that of the whole sequence; the chord error is
  /// ignored.
  PathOptions path = {};
  bool findOrder = false;  ///< search for an order; false: install the parts in the order given
  /// Rules of pairs, in place of the common clearance: a distance, or ignored.
  std::vector<PairRule> rules = {};
};

/// NoOrder: proven that no order exists in which the parts are installed one after the other
/// (possible only if parts do not turn, or have given motions). NotFound: nothing is proven.
enum class SequenceVerdict { NotFound, Found, NoOrder };
const char* sequenceVerdictName(SequenceVerdict verdict);  // not_found | found | no_order

/// One part and its path.
struct SequenceStep {
  std::size_t part = 0;  ///< index in the order given
  /// Path of the part past the parts installed before it. Its keys begin at time 0, or as given. If
  /// no order was found: result of the last search for this part among all remaining parts.
  PathReport path;
  double begin = 0;  ///< s, on the common time axis; 0 unless the sequence is found
  double end = 0;
};

struct SequenceReport : RunReport {
  SequenceVerdict verdict = SequenceVerdict::NotFound;
  std::string summary;
  bool orderFound = false;          ///< true: the order was searched for, not given
  std::vector<std::string> names;   ///< names of the parts, in the order given
  std::vector<std::string> still;   ///< names of the parts that stand still
  std::vector<SequenceStep> steps;  ///< in order of installation; parts without a path come first
  /// Motion of each part, in the order given, all from time 0 to the same end.
  std::vector<Trajectory> timeline;
  /// Indices of parts; the parts that stand still come after the others.
  std::vector<PartPair> ignored;
  double duration = 0;   ///< s, duration of the common time axis
  double clearance = 0;  ///< mm, smallest guaranteed distance of all paths
  double required = 0;
  double tolerance = 0;
  double release = 0;
  std::uint64_t seed = 0;
  bool budgetEnded = false;  ///< the time limit ended a search
  std::int64_t searches = 0;
  std::int64_t moves = 0;  ///< number of moves that all searches tried
  std::int64_t triangles = 0;
  std::string interpolation;
};

/// Shows the progress of a search to another thread: the current part, the number of parts that
/// have a path, and the farthest placement.
class SequenceWatch {
 public:
  struct Seen {
    /// Index of the current part, in the order given. Not set before the first search.
    std::optional<std::size_t> part;
    int found = 0;
    std::optional<Pose> farthest;
  };
  Seen seen() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    Seen now = seen_;
    if (now.part) now.farthest = path_->farthest();
    return now;
  }
  /// For the search: returns the PathWatch of the search that begins now.
  std::shared_ptr<PathWatch> begin(std::size_t part, std::size_t found) {
    const std::lock_guard<std::mutex> lock(mutex_);
    seen_ = {part, static_cast<int>(found), {}};
    path_ = std::make_shared<PathWatch>();
    return path_;
  }

 private:
  mutable std::mutex mutex_;
  Seen seen_;
  std::shared_ptr<PathWatch> path_;
};

/// Never throws except std::bad_alloc; report.status describes a failure. Codes besides those of
/// findPath(), whose messages name the part: NoParts, PartTwice, UnknownPart, BadRule,
/// PartsIntersect (two parts overlap in their installed positions; the text says which and how
/// deep), PartsTooNear (they are closer there than the clearance, and no release distance is
/// given).
SequenceReport findSequence(const std::vector<SequencePart>& parts,
                            const std::vector<StillPart>& still, const SequenceOptions& options,
                            RunContext& run, SequenceWatch* watch = nullptr);

/// Returns the report as JSON text (UTF-8). docs/paths.md describes the keys.
std::string toJson(const SequenceReport& report);

}  // namespace swept
