// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/widen.h"

#include <algorithm>
#include <cmath>

#include "path/contacts.h"

namespace swept::path {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr double kLongestMove = 0.5;  // radii of the part; longer moves get keys in between
constexpr std::size_t kMaxKeys = 300;
constexpr int kSamplesOfMove = 6;      // number of positions at which a free move is sampled
constexpr int kSamplesOfBlocked = 24;  // the same for a blocked move
constexpr int kRaiseRounds = 12;       // after this many rounds, a raise has failed
constexpr int kSweeps = 60;            // passes of the dual ascent
constexpr double kMaxKeyMove = 0.1;    // radii of the part; a key moves no farther in one round
// Pairs are opened to this multiple of the wanted distance. Tried on test cases of OMPL.app: with
// 1.02, blocked moves open too slowly; with 1.25 and more, wide detours use up the permitted
// length.
constexpr double kOpening = 1.1;
constexpr double kFirst = 2e-3;           // radii; the first raise
constexpr double kMinUsefulRaise = 2e-6;  // radii; smaller raises are not worth the time
constexpr double kMaxRaise = 0.25;        // radii; largest raise of all steps together
constexpr double kRaise = 2;              // factor from one raise to the next
// The search ends when the next raise to try is at most this multiple of the last successful one.
constexpr double kBracketRatio = 1.4;
constexpr double kMaxLengthening = 1.25;  // the path may become longer by this factor
constexpr int kShortcutsOfWidened = 100;  // shortcuts of the widened path

/// A linear inequality for the twists of two successive keys, which opens a pair of triangles
/// between them: row . (before * twist of the key + after * twist of the next key) >= least.
struct Opening {
  std::size_t key;
  double before, after;
  Vector6d row;
  double least, size, weight = 0;
};

Rule raised(const Rule& rule, double more) {
  Rule result = rule;
  for (double& distance : result)
    if (distance >= 0) distance += more;
  return result;
}

/// Moves the inner keys of a path until all moves of the path keep the wanted distances.
class Band {
 public:
  Band(const Scene& scene, const Rule& wanted, const WidenLimits& limits, RunContext& run)
      : scene_(scene),
        wanted_(wanted),
        within_(wanted),
        limits_(limits),
        run_(run),
        memory_(scene.memory()) {
    for (double& distance : within_)
      if (distance >= 0) distance *= kOpening;
  }

  /// Returns false if the wanted distances were not reached, or if the path became longer than
  /// `longest`.
  bool push(std::vector<State>& keys, double longest) {
    for (int round = 0; round < kRaiseRounds; ++round) {
      run_.checkpoint(Phase::Polish);
      if (lengthOf(scene_, keys) > longest) return false;
      openings_.clear();
      samples_.assign(keys.size() - 1, kSamplesOfMove);
      for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        if (!limits_.allowed(keys[i], keys[i + 1])) return false;
        if (!keepsApart(keys, i)) samples_[i] = kSamplesOfBlocked;
      }
      if (std::count(samples_.begin(), samples_.end(), kSamplesOfBlocked) == 0) return true;
      // Moves that are free must stay free.
      for (std::size_t i = 0; i + 1 < keys.size(); ++i)
        for (int k = 0; k <= samples_[i]; ++k)
          addContacts(keys, i, static_cast<double>(k) / samples_[i]);
      if (openings_.empty()) return false;
      move(keys);
      moved_ = true;
    }
    return false;
  }
  bool moved() const { return moved_; }

 private:
  // Returns whether the move is free. If it is blocked, adds the blocking pair.
  bool keepsApart(const std::vector<State>& keys, std::size_t i) {
    const Follow follow = scene_.follow(keys[i], keys[i + 1], wanted_, memory_);
    if (follow.fraction >= 1) return true;
    if (follow.neighbour < 0) return false;
    const auto k = static_cast<std::size_t>(follow.neighbour);
    const clearance::LeafPair blocking = memory_.pairs[k];
    if (blocking.body < 0) return false;
    const State state = scene_.stateBetween(keys[i], keys[i + 1], follow.fraction);
    const NearestPoints near =
        clearance::PairSearch(scene_.part(), scene_.neighbour(k))
            .leafDistance(state.pose.rotation.toRotationMatrix(), state.pose.translation, blocking);
    const double distance = std::sqrt(near.squared);
    if (distance > 0)
      add(keys, i, follow.fraction, state,
          {follow.neighbour, distance, near.a, (near.a - near.b) / distance});
    return false;
  }

  void addContacts(const std::vector<State>& keys, std::size_t i, double fraction) {
    const State state = scene_.stateBetween(keys[i], keys[i + 1], fraction);
    for (const Contact& contact : contactsOf(scene_, state, within_))
      add(keys, i, fraction, state, contact);
  }

  // Adds a linear inequality for a contact. The first and the last key do not move.
  void add(const std::vector<State>& keys, std::size_t i, double fraction, const State& state,
           const Contact& contact) {
    Opening opening;
    opening.key = i;
    opening.before = i == 0 ? 0 : 1 - fraction;
    opening.after = i + 2 == keys.size() ? 0 : fraction;
    opening.row << contact.normal,
        (contact.point - state.middle).cross(contact.normal) / scene_.radius();
    if (!limits_.turns) opening.row.tail<3>().setZero();
    opening.least = within_[static_cast<std::size_t>(contact.neighbour)] - contact.distance;
    opening.size = (opening.before * opening.before + opening.after * opening.after) *
                   opening.row.squaredNorm();
    if (opening.size > 1e-12) openings_.push_back(opening);
  }

  // Moves the keys by the smallest twists that open all pairs, to first order.
  void move(std::vector<State>& keys) {
    std::vector<Vector6d> twists(keys.size(), Vector6d::Zero());
    for (int sweep = 0; sweep < kSweeps; ++sweep)
      for (Opening& o : openings_) {
        const double opened = o.row.dot(o.before * twists[o.key] + o.after * twists[o.key + 1]);
        const double weight = std::max(0.0, o.weight + (o.least - opened) / o.size);
        const double change = weight - o.weight;
        if (change == 0) continue;
        o.weight = weight;
        twists[o.key] += change * o.before * o.row;
        twists[o.key + 1] += change * o.after * o.row;
      }
    for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
      Twist twist{twists[i].head<3>(), twists[i].tail<3>() / scene_.radius()};
      const double length = scene_.length(twist), longest = kMaxKeyMove * scene_.radius();
      if (length == 0) continue;
      if (length > longest) twist = twist * (longest / length);
      keys[i] = scene_.moved(keys[i], twist);
    }
  }

  const Scene& scene_;
  const Rule& wanted_;
  Rule within_;
  const WidenLimits& limits_;
  RunContext& run_;
  Memory memory_;
  bool moved_ = false;
  std::vector<int> samples_;  ///< for each move, the number of positions to sample
  std::vector<Opening> openings_;
};

// Adds keys between the keys, so that the path can bend.
std::vector<State> refined(const Scene& scene, const std::vector<State>& keys) {
  const double whole = lengthOf(scene, keys);
  const double longest =
      std::max(kLongestMove * scene.radius(), whole / static_cast<double>(kMaxKeys));
  std::vector<State> fine{keys.front()};
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    const int pieces =
        std::max(1, static_cast<int>(std::ceil(scene.distance(keys[i], keys[i + 1]) / longest)));
    for (int k = 1; k < pieces; ++k)
      fine.push_back(scene.stateBetween(keys[i], keys[i + 1], static_cast<double>(k) / pieces));
    fine.push_back(keys[i + 1]);
  }
  return fine;
}

// Returns by how much (at most `most`) the rule can be raised at both ends.
double roomAtEnds(const Scene& scene, const Rule& rule, const std::vector<State>& keys,
                  double most) {
  Memory memory = scene.memory();
  const auto keepsApartAtEnds = [&](double more) {
    const Rule wanted = raised(rule, more);
    return scene.isFree(keys.front(), wanted, memory) && scene.isFree(keys.back(), wanted, memory);
  };
  if (keepsApartAtEnds(most)) return most;
  double low = 0, high = most;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (low + high);
    (keepsApartAtEnds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

double widen(const Scene& scene, const Rule& rule, const WidenLimits& limits, RandomNumbers& random,
             std::vector<State>& keys, RunContext& run) {
  if (keys.size() < 3) return 0;
  const double longest = kMaxLengthening * lengthOf(scene, keys);
  const double room = roomAtEnds(scene, rule, keys, kMaxRaise * scene.radius());
  std::vector<State> best = refined(scene, keys);
  bool moved = false;  // if the path is wide enough already, it keeps its keys
  double reached = 0, failed = 0, next = std::min(kFirst * scene.radius(), room);
  while (next > kBracketRatio * reached && next > kMinUsefulRaise * scene.radius() &&
         !limits.over()) {
    std::vector<State> pushed = best;
    const Rule wanted = raised(rule, next);
    Band band(scene, wanted, limits, run);
    if (band.push(pushed, longest)) {
      reached = next;
      moved = moved || band.moved();
      best = std::move(pushed);
    } else {
      failed = next;
    }
    if (reached >= room) break;
    next = failed == 0    ? std::min(kRaise * next, room)
           : reached == 0 ? failed / (kRaise * kRaise)
                          : std::sqrt(reached * failed);
  }
  if (!moved) return 0;
  keys = std::move(best);
  shorten(scene, raised(rule, reached), limits.allowed, kShortcutsOfWidened, random, keys, run);
  return reached;
}

}  // namespace swept::path
