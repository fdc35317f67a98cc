#include "morph/project/build.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/project/documents.h"

namespace morphkit::project {
namespace {

using Keys = std::vector<std::string>;

TEST(Build, ANewDocumentSaysWhatIsNotUsual) {
  EXPECT_EQ(build(parse(test::with(""), ""), false).keys(), (Keys{"morphkit", "source", "destination"}));
  const json::Node node = build(parse(test::with_output(R"("frames": 9)"), ""), false);
  ASSERT_TRUE(node.find("output"));
  EXPECT_EQ(node.find("output")->keys(), (Keys{"frames"}));
}

TEST(Build, WithDefaultsItSaysWhatIsUsualToo) {
  const json::Node node = build(parse(test::with(""), ""), true);
  ASSERT_TRUE(node.find("output") && node.find("warp"));
  EXPECT_EQ(node.find("output")->find("frames")->number(), 48);
  EXPECT_EQ(node.find("warp")->find("filter")->text(), "area");
}

TEST(Build, TheKeysOfTheDocumentStandOnLinesOfTheirOwn) {
  EXPECT_TRUE(build(Project{}, false).hints().expand);
}

}  // namespace
}  // namespace morphkit::project
