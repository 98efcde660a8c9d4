// Sequences: parts that are installed one after the other; what is installed is in the way of what
// comes after it.
// In:    parts, each with where it belongs and how it comes there (a search as in path.h, or a
//        motion that exists); parts that stand still all the time; what is asked of pairs. Units:
//        mm, s, rad. All in one world.
// Out:   for each part a motion that the clearance engine finds clear of all that is installed by
//        then, and all motions on one timeline; or which part stopped it, by whom, how far it came.
// Order: the one that is given, or one that is found by taking apart: what can be taken out among
//        the parts that are left goes, and the order is turned round. A part that can be taken out
//        among many can be taken out among fewer, so it never matters which one goes first.
// Cost:  one search a part in a given order. To find one, at most one search of each length for
//        each part and each part that was in its way.
// Promise: nothing is called found that is not certified. The same answer for the same seed and any
//        count of threads, unless the wall-clock budget ends a search.
// Source: R. Wilson, J.-C. Latombe, Geometric reasoning about mechanical assembly (1994): an order
//        by disassembly, one part after the other, in both ends of each move; Y. Tian et al.,
//        Assemble them all (2022): the effort of the searches grows from round to round.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

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
  std::string name;  ///< of its own
  TriMesh mesh;
  double chordError = 0;  ///< mm, how far the triangles may lie off the exact surface
  PathTask task;          ///< goal: where it belongs; and how it comes there
  /// Instead of a search: the motion that ends where the part belongs. `task` is not read then.
  std::optional<Trajectory> motion = {};
};

/// Stands still from the beginning to the end.
struct StillPart {
  std::string name;
  TriMesh mesh;
  double chordError = 0;  ///< mm
};

struct SequenceOptions {
  /// Of all searches. The budget is that of the whole sequence; the chord error is not read.
  PathOptions path = {};
  bool findOrder = false;  ///< else the parts come in the order in which they are given
  /// What pairs ask for in place of the common clearance: a distance, or ignored.
  std::vector<PairRule> rules = {};
};

/// NoOrder: it is proven that, one part after the other, no order exists (only where parts do not
/// turn or have motions of their own). NotFound: nothing is proven.
enum class SequenceVerdict { NotFound, Found, NoOrder };
const char* sequenceVerdictName(SequenceVerdict verdict);  // not_found | found | no_order

/// One part on its way.
struct SequenceStep {
  std::size_t part = 0;  ///< index as given
  /// Of the part among what is installed before it; the keys begin at time 0 or as given. If no
  /// order was found, of the last search for it among all parts that are left.
  PathReport path;
  double begin = 0;  ///< s, on the common timeline; 0 unless the sequence is found
  double end = 0;
};

struct SequenceReport {
  Status status = Status::Ok;
  std::string code;
  std::string message;
  SequenceVerdict verdict = SequenceVerdict::NotFound;
  std::string summary;
  bool orderFound = false;           ///< the order was to be found, not given
  std::vector<std::string> names;    ///< of the parts, as given
  std::vector<std::string> still;    ///< names
  std::vector<SequenceStep> steps;   ///< in order; parts for which none was found come first
  std::vector<Trajectory> timeline;  ///< of each part as given, all from 0 to the same end
  std::vector<PartPair> ignored;     ///< numbers of parts, behind them those that stand still
  double duration = 0;               ///< s, of the timeline
  double clearance = 0;              ///< mm, the smallest guaranteed one of all paths
  double required = 0;
  double tolerance = 0;
  double release = 0;
  std::uint64_t seed = 0;
  bool budgetEnded = false;  ///< the wall clock ended a search
  std::int64_t searches = 0;
  std::int64_t moves = 0;  ///< tried by all searches
  std::int64_t triangles = 0;
  std::string interpolation;
  int threads = 0;
  std::vector<StageSeconds> seconds;  ///< "total" is the last entry
  std::vector<Finding> warnings;
};

/// What somebody who watches may see: the part that is looked at, how many have their path, and the
/// placement that came farthest out.
class SequenceWatch {
 public:
  struct Seen {
    int part = -1;  ///< index as given; -1: none yet
    int found = 0;
    std::optional<Pose> farthest;
  };
  Seen seen() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    Seen now = seen_;
    if (now.part >= 0) now.farthest = path_->farthest();
    return now;
  }
  /// For who computes: the watch of the search that begins.
  std::shared_ptr<PathWatch> begin(std::size_t part, std::size_t found) {
    const std::lock_guard<std::mutex> lock(mutex_);
    seen_ = {static_cast<int>(part), static_cast<int>(found), {}};
    path_ = std::make_shared<PathWatch>();
    return path_;
  }

 private:
  mutable std::mutex mutex_;
  Seen seen_;
  std::shared_ptr<PathWatch> path_;
};

/// Never throws except std::bad_alloc; failures are in report.status. Codes besides those of
/// findPath(), whose messages name the part: NoParts, PartTwice, UnknownPart, BadRule,
/// PartsIntersect (two parts lie in each other where they belong: which, how deep), PartsTooNear
/// (nearer than the clearance there, and no release is given).
SequenceReport findSequence(const std::vector<SequencePart>& parts,
                            const std::vector<StillPart>& still, const SequenceOptions& options,
                            RunContext& run, SequenceWatch* watch = nullptr);

/// The report as JSON text (UTF-8); keys as in docs/paths.md.
std::string toJson(const SequenceReport& report);

}  // namespace swept
