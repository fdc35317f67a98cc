#include "morph/render/line_check.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "morph/render/check.h"
#include "tests/support/pictures.h"

namespace morphkit::render {
namespace {

using test::line;
using test::pictures;
using test::point;
using test::random_image;

std::vector<Finding> findings(const project::Project& project) {
  return check(Renderer(project, pictures(random_image({96, 64}, 1), random_image({96, 64}, 2))));
}

TEST(LineCheck, NamesCrossingLinesOnceAndWhere) {
  project::Project project;
  project.features = {line("a", {{10, 10}, {50, 50}}, {{10, 10}, {50, 50}}),
                      line("b", {{10, 50}, {50, 10}}, {{60, 50}, {90, 10}})};
  const std::vector<Finding> found = findings(project);
  ASSERT_GE(found.size(), 1u);
  EXPECT_EQ(found[0].kind, Finding::Kind::kCrossing);
  EXPECT_EQ(found[0].where, "source");
  EXPECT_EQ(found[0].features, (std::vector<std::string>{"a", "b"}));
  EXPECT_NEAR(found[0].position.x, 30, 1e-9);
  EXPECT_NEAR(found[0].position.y, 30, 1e-9);
  EXPECT_EQ(
      std::count_if(found.begin(), found.end(), [](const Finding& f) { return f.kind == Finding::Kind::kCrossing; }),
      1);
}

TEST(LineCheck, FindsLinesThatCrossOnlyInBetween) {
  project::Project project;
  // b jumps from left of a to right of it, turning on its way.
  project.features = {line("a", {{48, 8}, {48, 56}}, {{48, 8}, {48, 56}}),
                      line("b", {{10, 30}, {20, 34}}, {{86, 30}, {76, 34}})};
  project.features[1].places[project::kSource] = {{10, 20}, {40, 40}};
  project.features[1].places[project::kDestination] = {{56, 20}, {86, 40}};
  const std::vector<Finding> found = findings(project);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].kind, Finding::Kind::kCrossing);
  EXPECT_EQ(found[0].where, "in between");
}

TEST(LineCheck, TouchingEndsAndChainsDoNotCross) {
  project::Project project;
  project.features = {line("a", {{10, 10}, {50, 30}}, {{10, 10}, {50, 30}}),
                      line("b", {{50, 30}, {80, 10}}, {{50, 30}, {80, 10}})};
  EXPECT_TRUE(findings(project).empty());
}

TEST(LineCheck, NamesTwinsThatDisagree) {
  project::Project project;
  project.features = {line("a", {{10, 30}, {80, 30}}, {{10, 20}, {80, 20}}),
                      line("b", {{12, 31}, {78, 31}}, {{12, 45}, {78, 45}})};
  const std::vector<Finding> found = findings(project);
  EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                          [](const Finding& f) { return f.kind == Finding::Kind::kTwins && f.where == "source"; }));
}

TEST(LineCheck, TwinsThatAgreeAreFine) {
  project::Project project;
  project.features = {line("a", {{10, 30}, {80, 30}}, {{10, 20}, {80, 50}}),
                      line("b", {{24, 30}, {38, 30}}, {{24, 26}, {38, 32}}), point("c", {60, 10}, {61, 12}),
                      point("d", {61, 12}, {62, 14})};
  EXPECT_TRUE(findings(project).empty());
}

TEST(LineCheck, NamesTwinsThatRunAgainstEachOther) {
  project::Project project;
  project.features = {line("a", {{10, 30}, {80, 30}}, {{10, 30}, {80, 30}}),
                      line("b", {{10, 31}, {80, 31}}, {{80, 31}, {10, 31}})};
  const std::vector<Finding> found = findings(project);
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(std::ranges::any_of(found, [](const Finding& f) { return f.kind == Finding::Kind::kTwins; }));
}

TEST(LineCheck, NamesPointsThatTearOnePlaceApart) {
  project::Project project;
  project.features = {point("a", {40, 30}, {30, 30}), point("b", {42, 30}, {52, 30})};
  const std::vector<Finding> found = findings(project);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].kind, Finding::Kind::kTwins);
  EXPECT_EQ(found[0].features, (std::vector<std::string>{"a", "b"}));
}

TEST(LineCheck, NamesMarksOutsideTheirPicture) {
  project::Project project;
  project.features = {point("nose", {48, 32}, {48, 64.5})};
  const std::vector<Finding> found = findings(project);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, Finding::Kind::kOutsideImage);
  EXPECT_EQ(found[0].where, "destination");
  EXPECT_NE(found[0].message.find("96x64"), std::string::npos);
}

}  // namespace
}  // namespace morphkit::render
