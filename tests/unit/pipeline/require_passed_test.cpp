// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pipeline/require_passed.h"

#include <gtest/gtest.h>

#include <string>

namespace swept::test {
namespace {

MeshCheck sound() {
  MeshCheck check;
  check.closed = check.manifold = check.oriented = true;
  check.shells = 3;
  return check;
}

std::string refusal(const MeshCheck& check) {
  try {
    requirePassed(check, "the envelope", 2.0);
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::InternalError);
    EXPECT_EQ(error.code(), "CheckFailed");
    return error.what();
  }
  return "";
}

TEST(RequirePassed, LetsASoundMeshThrough) { EXPECT_EQ(refusal(sound()), ""); }

TEST(RequirePassed, NamesEveryFaultAndWhatToDo) {
  MeshCheck check = sound();
  check.closed = check.manifold = check.oriented = false;
  check.openEdges = 4;
  check.nonManifoldVertices = 1;
  const std::string text = refusal(check);
  EXPECT_NE(text.find("4 open edges, 1 non-manifold vertices."), std::string::npos) << text;
  EXPECT_EQ(text.find("misoriented"), std::string::npos) << text;
  EXPECT_NE(text.find("try 1.8 mm instead of 2,"), std::string::npos) << text;
  EXPECT_NE(text.find("please report it"), std::string::npos) << text;
}

TEST(RequirePassed, NamesShellsWithTheWrongSideOut) {
  MeshCheck check = sound();
  check.oriented = false;
  EXPECT_NE(refusal(check).find("some of the 3 shells are inside out"), std::string::npos);
}

TEST(RequirePassed, NamesNumbersThatAreNone) {
  MeshCheck check = sound();
  check.finite = false;
  EXPECT_NE(refusal(check).find("coordinates that are not finite"), std::string::npos);
}

}  // namespace
}  // namespace swept::test
