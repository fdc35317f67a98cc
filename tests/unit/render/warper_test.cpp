#include "morph/render/warper.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/support/pictures.h"

namespace morphkit::render {
namespace {

using test::pictures;
using test::random_image;

TEST(Warper, RangesSpanTheWeightsOfEveryPicture) {
  const std::vector<project::Weights> weights = {{{}, {0.75, 0.25}}, {{}, {1, 0}}, {{}, {0.5, 0.5}}};
  const std::vector<WeightRange> ranges = ranges_of(weights);
  ASSERT_EQ(ranges.size(), 2u);
  EXPECT_EQ(ranges[0].least, 0.5);
  EXPECT_EQ(ranges[0].most, 1);
  EXPECT_EQ(ranges[1].least, 0);
  EXPECT_EQ(ranges[1].most, 0.5);
  EXPECT_TRUE(ranges[1].is_local());
  const std::vector<WeightRange> alone = ranges_of(std::vector<project::Weights>{{{}, {1, 0}}});
  EXPECT_FALSE(alone[0].is_local());
  EXPECT_TRUE(alone[0].shows());
  EXPECT_FALSE(alone[1].shows());
}

TEST(Warper, PicturesAreWholeAtEvenDistances) {
  EXPECT_EQ(end_of(0, 2), 0);
  EXPECT_EQ(end_of(1, 2), 1);
  EXPECT_EQ(end_of(1, 3), 0.5);
  EXPECT_EQ(end_of(0, 1), 0);
}

TEST(MakePlan, TheMethodOfTheProjectDoesTheWork) {
  project::Project project;
  const auto label = [&] {
    const Stage stage = make_stage(project, pictures(random_image({48, 32}, 1), random_image({48, 32}, 2)));
    const project::Evaluator moments(project);
    return make_plan(project, moments, stage, false)->at(moments.at(moments.clock().at(0.5)))->label();
  };
  const std::string lines = label();
  project.mesh = project::Mesh{3, 3, {{}, {}}, {}};
  EXPECT_NE(label(), lines);
  EXPECT_NE(label().find("mesh"), std::string::npos) << label();
}

}  // namespace
}  // namespace morphkit::render
