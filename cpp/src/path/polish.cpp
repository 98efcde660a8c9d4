// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path/polish.h"

#include <algorithm>

namespace swept::path {
namespace {

constexpr int kTrialsToGiveUp = 40;
constexpr int kPasses = 3;  // each takes shortcuts, then removes keys
constexpr int kTrialsToMerge = 24;
/// A key that replaces two others lies at most this fraction of their distance beside the move
/// between them.
constexpr double kMaxOffset = 0.7;

class Shortener {
 public:
  Shortener(const Scene& scene, const Rule& rule, const MoveAllowed& allowed, RandomNumbers& random,
            std::vector<State>& keys)
      : scene_(scene),
        rule_(rule),
        allowed_(allowed),
        random_(random),
        keys_(keys),
        memory_(scene.memory()) {}

  bool isFree(const State& a, const State& b) {
    if (!allowed_(a, b)) return false;
    // Most moves are blocked. A blocked placement on the move shows this much faster than a proof
    // that fails.
    for (const double fraction : {0.5, 0.25, 0.75})
      if (!scene_.isFree(scene_.stateBetween(a, b, fraction), rule_, memory_)) return false;
    return scene_.follow(a, b, rule_, memory_).fraction >= 1;
  }

  // Removes keys without which the path is still free.
  void dropKeys() {
    for (std::size_t first = 0; first + 2 < keys_.size(); ++first) {
      // Tries a move to the last key, then to a key half as far ahead, and so on.
      for (std::size_t reach = keys_.size() - 1 - first; reach >= 2; reach = reach / 2) {
        if (!isFree(keys_[first], keys_[first + reach])) continue;
        keys_.erase(keys_.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                    keys_.begin() + static_cast<std::ptrdiff_t>(first + reach));
        break;
      }
    }
    for (std::size_t i = 1; i + 1 < keys_.size();) {
      if (isFree(keys_[i - 1], keys_[i + 1]))
        keys_.erase(keys_.begin() + static_cast<std::ptrdiff_t>(i));
      else
        ++i;
    }
  }

  // Replaces two consecutive keys by one between them, or near the line between them. Returns false
  // if this is not possible for any pair.
  bool mergeKeys() {
    for (std::size_t i = 1; i + 2 < keys_.size(); ++i) {
      const double length = scene_.distance(keys_[i], keys_[i + 1]);
      for (int trial = 0; trial < kTrialsToMerge; ++trial) {
        State one =
            scene_.stateBetween(keys_[i], keys_[i + 1], trial == 0 ? 0.5 : random_.fraction());
        // The first three candidates lie on the move between the keys, later ones beside it.
        const double aside = kMaxOffset * length * trial / kTrialsToMerge;
        if (trial > 2)
          one = scene_.moved(
              one, {aside * random_.direction(), aside / scene_.radius() * random_.direction()});
        if (!isFree(keys_[i - 1], one) || !isFree(one, keys_[i + 2])) continue;
        keys_[i] = one;
        keys_.erase(keys_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        return true;
      }
    }
    return false;
  }

  // Tries a shortcut between two random points of the path. Returns true if it was accepted.
  bool cut() {
    const double whole = lengthOf(scene_, keys_);
    double a = random_.fraction() * whole, b = random_.fraction() * whole;
    if (random_.fraction() < 0.5) b = a + (2 * random_.fraction() - 1) * 0.2 * whole;
    if (a > b) std::swap(a, b);
    a = std::max(a, 0.0);
    b = std::min(b, whole);
    std::size_t first = 0, last = 0;
    const State from = stateAt(a, first), to = stateAt(b, last);
    if (first == last) return false;
    double replaced = b - a;
    if (scene_.distance(from, to) > 0.999 * replaced - 1e-3 * scene_.radius() * 0.01) return false;
    if (!isFree(from, to)) return false;
    // With screw interpolation, a part of a move can differ from the screw between the ends of this
    // part. So the remaining parts of the two moves are tested again.
    if (!isFree(keys_[first], from) || !isFree(to, keys_[last + 1])) return false;
    std::vector<State> next(keys_.begin(), keys_.begin() + static_cast<std::ptrdiff_t>(first) + 1);
    for (const State& state : {from, to})
      if (scene_.distance(next.back(), state) > 1e-9 * scene_.radius()) next.push_back(state);
    std::size_t after = last + 1;
    if (scene_.distance(next.back(), keys_[after]) <= 1e-9 * scene_.radius() && next.size() > 1)
      next.pop_back();
    next.insert(next.end(), keys_.begin() + static_cast<std::ptrdiff_t>(after), keys_.end());
    keys_ = std::move(next);
    return true;
  }

 private:
  State stateAt(double at, std::size_t& key) const {
    for (key = 0; key + 2 < keys_.size(); ++key) {
      const double length = scene_.distance(keys_[key], keys_[key + 1]);
      if (at <= length) break;
      at -= length;
    }
    const double length = scene_.distance(keys_[key], keys_[key + 1]);
    const double fraction = length > 0 ? std::min(1.0, at / length) : 0;
    return fraction <= 0   ? keys_[key]
           : fraction >= 1 ? keys_[key + 1]
                           : scene_.stateBetween(keys_[key], keys_[key + 1], fraction);
  }

  const Scene& scene_;
  const Rule& rule_;
  const MoveAllowed& allowed_;
  RandomNumbers& random_;
  std::vector<State>& keys_;
  Memory memory_;
};

}  // namespace

double lengthOf(const Scene& scene, const std::vector<State>& keys) {
  double sum = 0;
  for (std::size_t i = 1; i < keys.size(); ++i) sum += scene.distance(keys[i - 1], keys[i]);
  return sum;
}

void shorten(const Scene& scene, const Rule& rule, const MoveAllowed& allowed, int trials,
             RandomNumbers& random, std::vector<State>& keys, RunContext& run) {
  Shortener shortener(scene, rule, allowed, random, keys);
  shortener.dropKeys();
  for (int pass = 0; pass < kPasses; ++pass) {
    int failed = 0;
    for (int trial = 0; trial < trials && failed < kTrialsToGiveUp && keys.size() > 2; ++trial) {
      run.checkpoint(Phase::Polish, static_cast<std::uint64_t>(pass * trials + trial),
                     static_cast<std::uint64_t>(kPasses * trials));
      if (shortener.cut()) {
        failed = 0;
        if (trial % 8 == 0) shortener.dropKeys();
      } else {
        ++failed;
      }
    }
    shortener.dropKeys();
    while (shortener.mergeKeys()) run.checkpoint(Phase::Polish);
    shortener.dropKeys();
  }
}

}  // namespace swept::path
