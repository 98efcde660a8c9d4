// Rules of neighbours: how they are written, which neighbours they match, and how they change a
// check.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "swept/neighbour_rule.h"

#include <gtest/gtest.h>

#include <random>

#include "support/shapes.h"
#include "swept/clearance.h"

namespace swept {
namespace {

using Eigen::Vector3d;
using namespace swept::test;

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "BadRule");
    return error.what();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

NeighbourRule rule(const std::string& text) { return parseRule(text); }

TEST(NeighbourRule, TextsAndBack) {
  for (const char* text : {"3", "0", "0.25", "contact", "contact:0.2", "ignore"})
    EXPECT_EQ(ruleText(parseRule(text)), text);
  EXPECT_EQ(ruleText(parseRule(" contact ")), "contact");
  EXPECT_EQ(ruleText({}), "");
  const NamedRule named = parseNamedRule(" a=b part* = contact:0.5");
  EXPECT_EQ(named.pattern, "a=b part*");
  EXPECT_EQ(named.rule.contact, 0.5);
}

TEST(NeighbourRule, WhatIsWrongIsNamed) {
  for (const char* text :
       {"", "touch", "contact:", "contact:x", "3 mm", "1e10", "nan", "-1", "contact:-0.1", "inf"})
    EXPECT_NE(refusal([&] { parseRule(text); }).find(std::string(text)), std::string::npos);
  EXPECT_NE(refusal([] { parseRule("-1"); }).find("-1 mm is not allowed"), std::string::npos);
  for (const char* text : {"", "bolt", "=3", "  =3"}) refusal([&] { parseNamedRule(text); });
  EXPECT_NE(refusal([] {
              checkRule({1.0, 0.0}, "the rule of neighbour 'a'");
            }).find("neighbour 'a' contradicts itself"),
            std::string::npos);
}

TEST(NeighbourRule, NamesAndPatterns) {
  const std::vector<std::string> names{"bolt 1", "bolt 2", "cover", "", "*"};
  const std::vector<NeighbourRule> found = rulesFor(
      names, {{"bolt*", rule("contact")}, {"bolt 2", rule("7")}, {"c?v*r", rule("ignore")}});
  EXPECT_EQ(ruleText(found[0]), "contact");
  EXPECT_EQ(ruleText(found[1]), "7") << "the whole name comes before a pattern";
  EXPECT_EQ(ruleText(found[2]), "ignore");
  EXPECT_EQ(ruleText(found[3]), "");
  EXPECT_EQ(ruleText(found[4]), "");
  for (const NeighbourRule& all : rulesFor(names, {{"*", rule("2")}}))
    EXPECT_EQ(ruleText(all), "2");
}

TEST(NeighbourRule, RulesThatFitNobodyOrContradict) {
  const std::vector<std::string> names{"bolt 1", "cover"};
  const std::string nobody = refusal([&] { rulesFor(names, {{"bolts*", rule("3")}}); });
  EXPECT_NE(nobody.find("'bolts*' names no neighbour; the neighbours are: 'bolt 1', 'cover'"),
            std::string::npos)
      << nobody;
  const std::string two = refusal([&] {
    rulesFor(names, {{"b*", rule("3")}, {"*1", rule("contact")}});
  });
  EXPECT_NE(two.find("'bolt 1'"), std::string::npos);
  EXPECT_NE(two.find("'b*=3' and '*1=contact'"), std::string::npos) << two;
  refusal([&] { rulesFor(names, {{"cover", rule("3")}, {"cover", rule("4")}}); });
  // The same rule twice is no contradiction.
  rulesFor(names, {{"b*", rule("3")}, {"*1", rule("3")}});
}

// Names and patterns of two letters and wildcards, compared with a recursive matcher.
TEST(NeighbourRule, PatternsAgreeWithTheirDefinition) {
  const std::function<bool(const char*, const char*)> fits = [&](const char* p, const char* n) {
    if (*p == 0) return *n == 0;
    if (*p == '*') return fits(p + 1, n) || (*n != 0 && fits(p, n + 1));
    return *n != 0 && (*p == '?' || *p == *n) && fits(p + 1, n + 1);
  };
  std::mt19937 engine(3);
  const auto word = [&](const char* letters, unsigned count, unsigned most) {
    std::string text;
    for (std::uint32_t k = static_cast<std::uint32_t>(engine()) % (most + 1); k-- > 0;)
      text += letters[engine() % count];
    return text;
  };
  int fitted = 0;
  for (int round = 0; round < 4000; ++round) {
    const std::string name = word("ab", 2, 7), pattern = word("ab*?", 4, 6);
    bool found = true;
    try {
      rulesFor({name}, {{pattern, rule("1")}});
    } catch (const Error&) {
      found = false;
    }
    EXPECT_EQ(found, fits(pattern.c_str(), name.c_str())) << pattern << " against " << name;
    fitted += found ? 1 : 0;
  }
  EXPECT_GT(fitted, 300);
}

Trajectory line(const Vector3d& from, const Vector3d& to) {
  return {{poseOf(0, placement({0, 0, 1}, 0, from)), poseOf(1, placement({0, 0, 1}, 0, to))},
          Interpolation::Linear};
}

ClearanceReport check(const TriMesh& body, const Trajectory& motion,
                      std::vector<ClearanceNeighbour> parts, double required = 0) {
  RunContext run;
  ClearanceOptions options;
  options.required = required;
  const ClearanceReport report = checkClearance(body, motion, parts, options, run);
  EXPECT_EQ(report.status, Status::Ok) << report.message;
  return report;
}

const TriMesh kBox = makeBox(Vector3d::Zero(), Vector3d::Constant(10));

// Four walls: the required distance of each decides its verdict and its times below it, and
// nothing else changes.
TEST(ClearanceRules, EachNeighbourByItsOwnDistance) {
  const Trajectory motion = line({0, 0, 0}, {30, 0, 0});  // the box ends at x = 40
  const TriMesh near = makeBox({43, 0, 0}, {50, 10, 10}), aside = makeBox({0, 18, 0}, {40, 20, 10});
  const ClearanceReport common = check(kBox, motion, {{"near", near}, {"aside", aside}}, 5);
  const ClearanceReport own =
      check(kBox, motion, {{"near", near, 0, rule("2.5")}, {"aside", aside, 0, rule("9")}}, 5);
  EXPECT_EQ(common.neighbours[0].verdict, ClearanceVerdict::BelowRequired);
  EXPECT_EQ(common.neighbours[1].verdict, ClearanceVerdict::Clear);
  EXPECT_EQ(own.neighbours[0].verdict, ClearanceVerdict::Clear);
  EXPECT_EQ(own.neighbours[1].verdict, ClearanceVerdict::BelowRequired);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(own.neighbours[i].distance, common.neighbours[i].distance);
    EXPECT_EQ(own.neighbours[i].meetsRule(), i == 0);
  }
  EXPECT_NEAR(own.neighbours[0].distance, 3, 1e-9);
  EXPECT_NEAR(own.neighbours[1].distance, 8, 1e-9);
  EXPECT_TRUE(own.neighbours[0].below.empty());
  ASSERT_EQ(own.neighbours[1].below.size(), 1u);  // 8 mm off all the time
  EXPECT_EQ(own.neighbours[1].below[0].from, 0);
  EXPECT_EQ(own.neighbours[1].below[0].to, 1);
  ASSERT_EQ(common.neighbours[0].below.size(), 1u);
  EXPECT_NEAR(common.neighbours[0].below[0].from, 28.0 / 30, 0.01);
}

TEST(ClearanceRules, ContactThatIsAllowedIsNoFault) {
  const TriMesh table = makeBox({-50, -50, -10}, {50, 50, 0});
  const Trajectory slide = line({-30, 3, 0}, {20, 5, 0});
  const NeighbourClearance bare = check(kBox, slide, {{"table", table}}, 5).neighbours[0];
  EXPECT_EQ(bare.verdict, ClearanceVerdict::Contact);
  EXPECT_FALSE(bare.meetsRule());
  const ClearanceReport report = check(kBox, slide,
                                       {{"table", table, 0, rule("contact")},
                                        {"wall", kBox, 0, rule("ignore")},
                                        {"far", makeBox({0, 40, 0}, {9, 49, 9})}},
                                       5);
  ASSERT_EQ(report.neighbours.size(), 2u);
  const NeighbourClearance& row = report.neighbours[0];
  EXPECT_EQ(row.verdict, ClearanceVerdict::Contact);
  EXPECT_TRUE(row.meetsRule());
  EXPECT_TRUE(row.below.empty());
  ASSERT_EQ(row.contact.size(), 1u);  // the times of contact are still reported
  EXPECT_EQ(report.ignored, std::vector<std::string>{"wall"});
  EXPECT_EQ(report.smallest, 1u);  // row 1, not row 0 with its allowed contact
  EXPECT_NE(report.summary.find("2 checked, 1 allowed contact, 1 ignored, smallest distance"),
            std::string::npos)
      << report.summary;
}

// A box is pushed into a block. Up to the allowed depth this is contact, deeper is a clash.
TEST(ClearanceRules, DeeperThanAllowedIsAClash) {
  const TriMesh block = makeBox({20, -30, -30}, {60, 40, 40});
  std::mt19937 engine(11);
  for (int round = 0; round < 12; ++round) {
    const double depth = 0.05 + 0.0002 * static_cast<double>(engine() % 10000);
    const Trajectory push = line({0, 0, 0}, {10 + depth, 0, 0});
    const auto verdict = [&](double allowed) {
      NeighbourRule own;
      own.contact = allowed;
      return check(kBox, push, {{"block", block, 0, own}}).neighbours[0];
    };
    EXPECT_EQ(verdict(0).verdict, ClearanceVerdict::Clash);
    const NeighbourClearance shallow = verdict(0.9 * depth - 0.01);
    EXPECT_EQ(shallow.verdict, ClearanceVerdict::Clash) << depth;
    EXPECT_FALSE(shallow.meetsRule());
    const NeighbourClearance deep = verdict(1.02 * depth + 0.01);
    EXPECT_EQ(deep.verdict, ClearanceVerdict::Contact) << depth;
    EXPECT_TRUE(deep.meetsRule());
    EXPECT_NEAR(deep.penetration.depth, depth, 0.011 + 0.01 * depth);
    EXPECT_LE(deep.penetration.depthBound, 1.02 * depth + 0.01);
  }
}

TEST(ClearanceRules, ImpossibleRulesAreRefused) {
  const auto refused = [&](std::vector<ClearanceNeighbour> parts) {
    RunContext run;
    const ClearanceReport report = checkClearance(kBox, line({0, 0, 0}, {1, 0, 0}), parts, {}, run);
    EXPECT_EQ(report.status, Status::InvalidInput);
    EXPECT_TRUE(report.neighbours.empty() && report.ignored.empty());
    return report.code + ": " + report.message;
  };
  const TriMesh far = makeBox({50, 0, 0}, {60, 10, 10});
  NeighbourRule negative, both;
  negative.required = -2;
  both.contact = 1;
  both.ignored = true;
  EXPECT_NE(refused({{"hose", far, 0, negative}}).find("BadRule: the rule of neighbour 'hose'"),
            std::string::npos);
  EXPECT_NE(refused({{"hose", far, 0, both}}).find("contradicts itself"), std::string::npos);
  EXPECT_NE(refused({{"hose", far, 0, rule("ignore")}}).find("NoNeighbours"), std::string::npos);
}

TEST(ClearanceRules, FirstContactsAreOffered) {
  // A box on a table, pressed 0.3 mm into a bush, beside a wall; it rises and turns away.
  const std::vector<ClearanceNeighbour> parts{
      {"table", makeBox({-50, -50, -10}, {50, 50, 0})},
      {"bush", makeBox({9.7, -5, 2}, {30, 15, 8})},
      {"wall", makeBox({-30, 0, 1}, {-0.5, 10, 9})},
      {"above", makeBox({0, 0, 30}, {10, 10, 40}), 0, rule("ignore")},
  };
  const Trajectory lift = line({0, 0, 0}, {0, 0, 100});
  RunContext run;
  const ClearanceReport report = firstContacts(kBox, lift, parts, {}, run);
  ASSERT_EQ(report.status, Status::Ok) << report.message;
  ASSERT_EQ(report.neighbours.size(), 4u);
  EXPECT_EQ(ruleText(report.neighbours[0].rule), "contact");
  EXPECT_EQ(ruleText(report.neighbours[2].rule), "");
  EXPECT_EQ(ruleText(report.neighbours[3].rule), "");  // the clash comes later
  const double depth = report.neighbours[1].rule.contact.value_or(0);
  EXPECT_GE(depth, 0.3);
  EXPECT_LE(depth, 0.34);
  std::vector<ClearanceNeighbour> ruled = parts;
  for (int i = 0; i < 2; ++i) ruled[i].rule = report.neighbours[i].rule;
  const Trajectory off = line({0, 0, 0}, {0, 0, 15});
  for (const NeighbourClearance& row : check(kBox, off, ruled).neighbours)
    EXPECT_TRUE(row.meetsRule()) << row.name;
}

}  // namespace
}  // namespace swept
