// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/box_tree.h"

#include <limits>
#include <numeric>

namespace swept {
namespace {

constexpr std::size_t kItemGrain = 1 << 13;
constexpr std::uint32_t kHilbertBits = 10;  // per axis
using Keys = RawArray<std::uint64_t>;       // key in the upper half, item in the lower half

/// Returns the position along a Hilbert curve through a cube of 2^10 cells per side. Method
/// (Skilling 2004): undo the rotations bit by bit, then apply the Gray code.
std::uint32_t hilbertKey(std::array<std::uint32_t, 3> x) {
  for (std::uint32_t q = 1u << (kHilbertBits - 1); q > 1; q >>= 1) {
    const std::uint32_t p = q - 1;
    for (int i = 0; i < 3; ++i) {
      if ((x[i] & q) != 0) {
        x[0] ^= p;
      } else {
        const std::uint32_t t = (x[0] ^ x[i]) & p;
        x[0] ^= t;
        x[i] ^= t;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t t = 0;
  for (std::uint32_t q = 1u << (kHilbertBits - 1); q > 1; q >>= 1) {
    if ((x[2] & q) != 0) t ^= q - 1;
  }
  std::uint32_t key = 0;
  for (int bit = static_cast<int>(kHilbertBits) - 1; bit >= 0; --bit) {
    for (int i = 0; i < 3; ++i) key = (key << 1) | (((x[i] ^ t) >> bit) & 1u);
  }
  return key;
}

/// Sorts stably by the upper 32 bits: a radix sort with three passes of 11 bits. The size of the
/// parallel blocks depends only on the number of keys.
void sortByKey(Keys& keys) {
  constexpr std::size_t kFew = 1 << 12;  // for fewer items, a simple sort is faster
  if (keys.size() < kFew) {
    std::sort(keys.data(), keys.data() + keys.size());
    return;
  }
  constexpr std::size_t kDigits = 1 << 11;
  const std::size_t block = std::max<std::size_t>(1 << 15, keys.size() / 32 + 1);
  const std::size_t blocks = (keys.size() + block - 1) / block;
  Keys other(keys.size());
  std::vector<std::uint32_t> counts(blocks * kDigits);
  for (int shift = 32; shift < 64; shift += 11) {
    auto digit = [shift](std::uint64_t key) { return (key >> shift) & (kDigits - 1); };
    std::fill(counts.begin(), counts.end(), 0);
    parallelFor(blocks, [&](std::size_t b) {
      const std::size_t end = std::min(keys.size(), (b + 1) * block);
      for (std::size_t i = b * block; i < end; ++i) ++counts[b * kDigits + digit(keys[i])];
    });
    std::uint32_t sum = 0;
    for (std::size_t d = 0; d < kDigits; ++d) {
      for (std::size_t b = 0; b < blocks; ++b) {
        const std::uint32_t count = counts[b * kDigits + d];
        counts[b * kDigits + d] = sum;
        sum += count;
      }
    }
    parallelFor(blocks, [&](std::size_t b) {
      const std::size_t end = std::min(keys.size(), (b + 1) * block);
      for (std::size_t i = b * block; i < end; ++i) {
        other[counts[b * kDigits + digit(keys[i])]++] = keys[i];
      }
    });
    std::swap(keys, other);
  }
}

/// Converts to float and subtracts a few units in the last place. `value` is a rounded difference.
/// So neither its rounding nor the conversion can make a box smaller.
float roundedDown(double value) {
  const auto f = static_cast<float>(value);
  return f - std::abs(f) * 3e-7f - std::numeric_limits<float>::min();
}
float roundedUp(double value) { return -roundedDown(-value); }

template <class Box>
float extentOf(const Box& box) {
  return std::max({box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]});
}

/// Returns the median extent of about a thousand boxes from all parts of the list.
template <class Boxes>
float typicalExtent(const Boxes& boxes) {
  const std::size_t step = boxes.size() / 1024 + 1;
  std::vector<float> sample;
  for (std::size_t i = 0; i < boxes.size(); i += step) sample.push_back(extentOf(boxes[i]));
  std::nth_element(sample.begin(), sample.begin() + sample.size() / 2, sample.end());
  return sample[sample.size() / 2];
}

template <class Boxes>
Keys makeKeys(const Boxes& boxes, double extent) {
  const float typical = typicalExtent(boxes);
  const double half = (1u << kHilbertBits) / 2.0;
  const double scale = extent > 0 ? ((1u << kHilbertBits) - 1) / extent / 2 : 0;
  Keys keys(boxes.size());
  parallelBlocks(keys.size(), kItemGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto& box = boxes[i];
      std::array<std::uint32_t, 3> cell{};
      for (int axis = 0; axis < 3; ++axis) {
        const double twice = static_cast<double>(box.low[axis]) + box.high[axis];
        cell[axis] =
            static_cast<std::uint32_t>(std::clamp(twice * scale + half, 0.0, 2 * half - 1));
      }
      const float size = extentOf(box);
      const std::uint64_t sizeClass = size <= 4 * typical    ? 0
                                      : size <= 16 * typical ? 1
                                      : size <= 64 * typical ? 2
                                                             : 3;
      keys[i] = ((sizeClass << 30 | hilbertKey(cell)) << 32) | i;
    }
  });
  return keys;
}

/// Sorts items [first, last) by position, so that the nodes above them have compact boxes. Splits
/// the list after `capacity` items, along the axis on which the centres of their boxes spread most.
/// Then sorts both parts in the same way, with half the capacity.
template <class Boxes>
void sortByMedians(const Boxes& boxes, std::int32_t* first, std::int32_t* last,
                   std::size_t capacity) {
  constexpr std::size_t kSequential = 4096;  // shorter lists are sorted in the current task
  if (static_cast<std::size_t>(last - first) <= capacity) {
    if (capacity > 1) sortByMedians(boxes, first, last, capacity / 2);
    return;
  }
  const auto twiceMiddle = [&](std::int32_t i, int axis) {
    const auto& box = boxes[static_cast<std::size_t>(i)];
    return box.low[axis] + box.high[axis];
  };
  int axis = 0;
  float widest = -1;
  for (int a = 0; a < 3; ++a) {
    float low = HUGE_VALF, high = -HUGE_VALF;
    for (const std::int32_t* i = first; i != last; ++i) {
      low = std::min(low, twiceMiddle(*i, a));
      high = std::max(high, twiceMiddle(*i, a));
    }
    if (high - low > widest) axis = a;
    widest = std::max(widest, high - low);
  }
  std::int32_t* middle = first + capacity;
  std::nth_element(first, middle, last, [&](std::int32_t a, std::int32_t b) {
    const float x = twiceMiddle(a, axis), y = twiceMiddle(b, axis);
    return x != y ? x < y : a < b;
  });
  const auto lower = [&] { sortByMedians(boxes, first, middle, capacity / 2); };
  const auto upper = [&] { sortByMedians(boxes, middle, last, capacity / 2); };
  if (capacity < 2) return;
  if (static_cast<std::size_t>(last - first) > kSequential) {
    parallelActions(lower, upper);
  } else {
    lower();
    upper();
  }
}

constexpr float kInfinity = std::numeric_limits<float>::infinity();

void setEmpty(BoxTree::Group& group, int lane) {
  for (int axis = 0; axis < 3; ++axis) {
    group.low[axis][lane] = kInfinity;
    group.high[axis][lane] = -kInfinity;
  }
}

}  // namespace

BoxTree::FloatBox BoxTree::rounded(const Bounds& box) const {
  FloatBox out;
  for (int axis = 0; axis < 3; ++axis) {
    out.low[axis] = roundedDown(box.low[axis] - middle_[axis]);
    out.high[axis] = roundedUp(box.high[axis] - middle_[axis]);
  }
  return out;
}

void BoxTree::build(const RawArray<FloatBox>& boxes, Order order) {
  items_ = RawArray<std::int32_t>(boxes.size());
  if (order == Order::Curve) {
    Keys keys = makeKeys(boxes, (bounds_.high - bounds_.low).maxCoeff());
    sortByKey(keys);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      items_[i] = static_cast<std::int32_t>(keys[i] & 0xffffffffu);
    }
  } else {
    std::size_t half = 1;  // half the number of items that a tree of this height can hold
    while (2 * half < boxes.size()) half *= 2;
    std::iota(items_.data(), items_.data() + boxes.size(), 0);
    sortByMedians(boxes, items_.data(), items_.data() + boxes.size(), half);
  }
  std::size_t groups = 0;
  for (std::size_t nodes = boxes.size();; nodes = (nodes + kWidth - 1) / kWidth) {
    levels_.push_back({groups, static_cast<std::uint32_t>(nodes)});
    groups += (nodes + kWidth - 1) / kWidth;
    if (nodes == 1) break;
  }
  groups_ = RawArray<Group>(groups);
  const auto groupsOf = [&](std::size_t level) {
    return (levels_[level].nodes + kWidth - 1) / kWidth;
  };
  parallelBlocks(groupsOf(0), kItemGrain / kWidth, [&](std::size_t begin, std::size_t end) {
    for (std::size_t g = begin; g < end; ++g) {
      for (int lane = 0; lane < kWidth; ++lane) {
        const std::size_t place = kWidth * g + lane;
        if (place >= boxes.size()) {
          setEmpty(groups_[g], lane);
          continue;
        }
        const FloatBox& box = boxes[static_cast<std::size_t>(items_[place])];
        for (int axis = 0; axis < 3; ++axis) {
          groups_[g].low[axis][lane] = box.low[axis];
          groups_[g].high[axis][lane] = box.high[axis];
        }
      }
    }
  });
  for (std::size_t level = 1; level < levels_.size(); ++level) {
    parallelBlocks(groupsOf(level), kItemGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t g = begin; g < end; ++g) {
        Group& group = groups_[levels_[level].firstGroup + g];
        for (int lane = 0; lane < kWidth; ++lane) {
          const std::size_t node = kWidth * g + lane;
          if (node >= levels_[level].nodes) {
            setEmpty(group, lane);
            continue;
          }
          const Group& below = groups_[levels_[level - 1].firstGroup + node];
          for (int axis = 0; axis < 3; ++axis) {
            group.low[axis][lane] = *std::min_element(below.low[axis], below.low[axis] + kWidth);
            group.high[axis][lane] = *std::max_element(below.high[axis], below.high[axis] + kWidth);
          }
        }
      }
    });
  }
}

}  // namespace swept
