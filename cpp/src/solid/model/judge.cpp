// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solid/model/judge.h"

namespace swept::step {

std::optional<Assembly> Judge::assemble(const SolidOptions& /*options*/,
                                        const HalfEdgeMesh& /*mesh*/, RunContext& /*run*/) {
  return std::nullopt;
}

std::optional<Assembly> Judge::fill(const SolidOptions& /*options*/, std::int64_t /*mostFaces*/,
                                    const HalfEdgeMesh& /*mesh*/, RunContext& /*run*/) {
  return std::nullopt;
}

void Judge::writeAssembled(std::ostream& /*out*/, const std::string& /*name*/,
                           const SolidOptions& /*options*/, SolidFormat /*format*/,
                           RunContext& /*run*/) {}

}  // namespace swept::step
