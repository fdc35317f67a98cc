#include "morph/render/check.h"

#include <gtest/gtest.h>

#include "tests/support/pictures.h"

namespace morphkit::render {
namespace {

using test::line;
using test::pictures;
using test::random_image;
using test::small_project;

std::vector<Finding> findings(const project::Project& project) {
  return check(Renderer(project, pictures(random_image({96, 64}, 1), random_image({96, 64}, 2))));
}

TEST(Check, HasNothingToSayOfAGoodProject) {
  for (const Finding& finding : findings(small_project())) ADD_FAILURE() << finding.message;
}

TEST(Check, FindsFoldsAndTheFeaturesNearest) {
  project::Project project;
  // Two neighbouring lines change places.
  project.features = {line("left", {{40, 10}, {40, 54}}, {{56, 10}, {56, 54}}),
                      line("right", {{56, 10}, {56, 54}}, {{40, 10}, {40, 54}}),
                      line("far", {{2, 2}, {2, 60}}, {{2, 2}, {2, 60}})};
  const std::vector<Finding> found = findings(project);
  const auto fold =
      std::find_if(found.begin(), found.end(), [](const Finding& f) { return f.kind == Finding::Kind::kFold; });
  ASSERT_NE(fold, found.end());
  EXPECT_GT(fold->area_px, 100);
  EXPECT_GE(fold->count, 1);
  EXPECT_EQ(fold->features.size(), 3u);
  EXPECT_NE(fold->features[0], "far");
}

}  // namespace
}  // namespace morphkit::render
