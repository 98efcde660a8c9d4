// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fuzz/promise.h"

#include <algorithm>

namespace swept::fuzz {

void limit(RunContext& run) {
  run.threads = 1;
  run.memoryLimitBytes = 64ull << 20;
}

void requireNamed(const std::string& what, Status status, const std::string& code,
                  const std::string& message, std::initializer_list<Status> allowed) {
  const bool expected = allowed.size() == 0
                            ? status != Status::InternalError
                            : std::find(allowed.begin(), allowed.end(), status) != allowed.end();
  if (expected && !code.empty() && !message.empty()) return;
  throw BrokenPromise(what + " ends with " + statusName(status) + "/" + code + ": " + message);
}

void requireNamed(const std::string& what, const Error& error,
                  std::initializer_list<Status> allowed) {
  requireNamed(what, error.status(), error.code(), error.what(), allowed);
}

}  // namespace swept::fuzz
