// compute() for tests that expect the status Ok and a mesh without faults.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gtest/gtest.h>

#include "swept/compute.h"

namespace swept::test {

inline Result checkedCompute(const TriMesh& body, const Trajectory& motion,
                             const Options& options) {
  RunContext run;
  Result result = compute(body, motion, options, run);
  EXPECT_EQ(result.report.status, Status::Ok) << result.report.message;
  EXPECT_TRUE(result.report.check.passes());
  return result;
}

}  // namespace swept::test
