// Tests samples/bulb.cpp, samples/desert.cpp, samples/lake.cpp, samples/man.cpp, samples/pear.cpp, samples/portrait.cpp
// and samples/woman.cpp.
// Every sample, rendered from its files to 8-bit pictures, against golden pictures that people have approved. Renew
// with scripts/renew-goldens.sh.

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "morph/job/pictures.h"
#include "morph/media/image_file.h"
#include "morph/project/project.h"
#include "morph/render/check.h"
#include "morph/render/renderer.h"
#include "samples/samples.h"
#include "samples/write.h"
#include "tests/golden/golden.h"
#include "tests/support/temporary_folder.h"

namespace morphkit {
namespace {

namespace fs = std::filesystem;

/// Long side of golden pictures, px: large enough to judge, small enough for the repository.
constexpr int kLongSide = 320;

project::Project small(project::Project project) {
  const cv::Size size = *project.output.size;
  const double scale = static_cast<double>(kLongSide) / std::max(size.width, size.height);
  project.output.size = cv::Size(static_cast<int>(size.width * scale), static_cast<int>(size.height * scale));
  return project;
}

/// Painted once: painting takes longer than rendering.
const samples::Sample& painted(const std::string& name) {
  static std::map<std::string, samples::Sample> known;
  const auto found = known.find(name);
  return found != known.end() ? found->second : known.emplace(name, samples::paint(name)).first->second;
}

class Golden : public testing::TestWithParam<std::tuple<std::string, double>> {};

TEST_P(Golden, LooksAsItDid) {
  const auto& [sample, t] = GetParam();
  const std::string name = fmt::format("{}-{:03.0f}", sample, t * 100);
  const test::TemporaryFolder folder;

  const project::Project project = small(project::load(samples::write(painted(sample), folder.path(), true)));
  const render::Renderer renderer(project, job::footage_of(job::load_pictures(project)));
  const fs::path file = folder / (name + ".png");
  media::write_image(file, renderer.frame(renderer.clock().at(t)));
  test::expect_golden(name, file);
}

INSTANTIATE_TEST_SUITE_P(
    Samples, Golden, testing::Combine(testing::ValuesIn(samples::names()), testing::Values(0.0, 0.25, 0.5, 0.75, 1.0)),
    [](const auto& parameter) {
      return fmt::format("{}_{:03.0f}", std::get<0>(parameter.param), std::get<1>(parameter.param) * 100);
    });

class SampleCheck : public testing::TestWithParam<std::string> {};

TEST_P(SampleCheck, HasNoFindings) {
  const test::TemporaryFolder folder;
  const project::Project project = project::load(samples::write(painted(GetParam()), folder.path(), true));
  const render::Renderer renderer(project, job::footage_of(job::load_pictures(project)));
  for (const render::Finding& finding : render::check(renderer)) ADD_FAILURE() << finding.message;
}

INSTANTIATE_TEST_SUITE_P(Samples, SampleCheck, testing::ValuesIn(samples::names()),
                         [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace morphkit
