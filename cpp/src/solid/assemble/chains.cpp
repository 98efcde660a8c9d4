// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/assemble/chains.h"

#include <algorithm>
#include <iterator>

namespace swept::step {

Chain sumOf(const Chain& a, const Chain& b) {
  Chain sum;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum));
  return sum;
}

std::vector<int> ChainBasis::add(Chain chain, int name) {
  std::vector<int> names = reduce(chain);
  if (chain.empty()) return names;
  rows_[chain.front()] = {chain, sumOf(names, {name})};
  return {};
}

std::vector<int> ChainBasis::reduce(Chain& chain) const {
  Chain names;
  // A row has no edge before its first one. So edges before it do not come back.
  for (auto at = rows_.begin(); at != rows_.end() && !chain.empty(); ++at) {
    if (!std::binary_search(chain.begin(), chain.end(), at->first)) continue;
    chain = sumOf(chain, at->second.chain);
    names = sumOf(names, at->second.names);
  }
  return names;
}

}  // namespace swept::step
