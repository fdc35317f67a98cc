// Every sample: the same bytes every time, and a project with its marks on its pictures.

#include "samples/samples.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "morph/project/project.h"
#include "tests/support/threads.h"

namespace morphkit::samples {
namespace {

class EverySample : public testing::TestWithParam<std::string> {};

/// The sample, painted once for all tests of this program.
const Sample& painted(const std::string& name) {
  static std::map<std::string, Sample> all;
  const auto found = all.find(name);
  return found != all.end() ? found->second : all.emplace(name, paint(name)).first->second;
}

bool same_bytes(const cv::Mat4b& a, const cv::Mat4b& b) {
  return a.size() == b.size() && a.isContinuous() && b.isContinuous() &&
         std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

project::Project project_of(const Sample& sample) {
  return project::parse(sample.project, sample.name + ".json");
}

TEST_P(EverySample, IsTheSameForAnyNumberOfThreads) {
  const Sample& first = painted(GetParam());
  for (const int threads : {1, 2, 5}) {
    SCOPED_TRACE(threads);
    test::set_threads(threads);
    const Sample again = paint(GetParam());
    test::set_threads(0);
    ASSERT_EQ(again.pictures.size(), first.pictures.size());
    for (std::size_t i = 0; i < first.pictures.size(); ++i) {
      EXPECT_EQ(again.pictures[i].name, first.pictures[i].name);
      EXPECT_TRUE(same_bytes(again.pictures[i].pixels, first.pictures[i].pixels)) << first.pictures[i].name;
    }
    EXPECT_EQ(again.project, first.project);
  }
}

TEST_P(EverySample, IsTwoPicturesThatItsProjectNames) {
  const Sample& sample = painted(GetParam());
  const project::Project project = project_of(sample);
  EXPECT_EQ(sample.name, GetParam());
  EXPECT_FALSE(sample.title.empty());
  ASSERT_EQ(sample.pictures.size(), 2u);
  EXPECT_EQ(project.pictures[project::kSource].image, sample.pictures[0].name);
  EXPECT_EQ(project.pictures[project::kDestination].image, sample.pictures[1].name);
  for (const PaintedPicture& picture : sample.pictures) {
    cv::Scalar mean, deviation;
    cv::meanStdDev(picture.pixels, mean, deviation);
    EXPECT_GT(deviation[0] + deviation[1] + deviation[2], 30) << picture.name << " has hardly anything on it";
  }
}

TEST_P(EverySample, HasUniqueFeaturesOnItsPictures) {
  const Sample& sample = painted(GetParam());
  const project::Project project = project_of(sample);
  std::set<std::string> ids;
  for (const project::Feature& feature : project.features) {
    EXPECT_TRUE(ids.insert(feature.id).second) << feature.id;
    for (const bool is_source : {true, false}) {
      const cv::Size size = sample.pictures[is_source ? 0 : 1].pixels.size();
      for (const cv::Point2d& p :
           is_source ? feature.places[project::kSource] : feature.places[project::kDestination]) {
        EXPECT_TRUE(p.x >= 0 && p.y >= 0 && p.x <= size.width && p.y <= size.height)
            << feature.id << ": " << p.x << ", " << p.y;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, EverySample, testing::ValuesIn(names()),
                         [](const auto& sample) { return sample.param; });

double part_with_alpha(const cv::Mat4b& pixels, int low, int high) {
  return static_cast<double>(std::count_if(pixels.begin(), pixels.end(),
                                           [&](const cv::Vec4b& p) { return p[3] >= low && p[3] <= high; })) /
         static_cast<double>(pixels.total());
}

TEST(Samples, ObjectsAreCutOutAndTheOthersOpaque) {
  for (const std::string& name : names()) {
    for (const PaintedPicture& picture : painted(name).pictures) {
      SCOPED_TRACE(picture.name);
      if (name == "objects") {
        EXPECT_GT(part_with_alpha(picture.pixels, 0, 0), 0.2);      // nothing around them
        EXPECT_GT(part_with_alpha(picture.pixels, 1, 254), 0.001);  // soft edges, shadow or glass
        EXPECT_GT(part_with_alpha(picture.pixels, 255, 255), 0.01);
      } else {
        EXPECT_EQ(part_with_alpha(picture.pixels, 255, 255), 1);
      }
    }
  }
}

TEST(Samples, ScenesDifferInSize) {
  const Sample& scenes = painted("scenes");
  EXPECT_EQ(scenes.pictures[0].pixels.size(), cv::Size(1280, 720));
  EXPECT_EQ(scenes.pictures[1].pixels.size(), cv::Size(960, 800));
}

TEST(Samples, PortraitsHaveManyFeatures) {
  EXPECT_GE(project_of(painted("portraits")).features.size(), 25u);
}

TEST(Samples, UnknownNamesAreRefusedByName) {
  try {
    paint("protraits");
    FAIL() << "painted something";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("protraits"), std::string::npos);
  }
}

}  // namespace
}  // namespace morphkit::samples
