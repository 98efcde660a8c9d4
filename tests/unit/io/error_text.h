// Returns the text of the error that a call must throw.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "swept/types.h"

namespace swept::test {

/// Runs `call`, which must throw Error with this status and code. Returns its text.
template <class Call>
std::string errorText(Status status, const std::string& code, Call call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(statusName(error.status()), std::string(statusName(status))) << error.what();
    EXPECT_EQ(error.code(), code) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "no error where " << code << " was due";
  return {};
}

}  // namespace swept::test
