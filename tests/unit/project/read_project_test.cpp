#include "morph/project/read_project.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "morph/project/project.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/project/documents.h"

namespace morphkit::project {
namespace {

using test::expect_bad;
using test::with;
using test::with_line;
using test::with_shape;

class ReadFeatures : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) {
    test::write_text(directory_ / name, text);
    return directory_ / name;
  }
  test::TemporaryFolder directory_;
};

TEST(ReadProject, TheVersionIsReadBeforeAnythingElse) {
  expect_bad({R"({"unknown": 1, "morphkit": 2})", "/morphkit", "newer than this program"});
  expect_bad({R"({"unknown": 1})", "", "\"morphkit\" is missing"});
  expect_bad({R"({"unknown": 1, "morphkit": 1})", "/unknown", "unknown key"});
}

TEST_F(ReadFeatures, FeaturesAreLaidOverAProject) {
  Project project;
  project.pictures[project::kSource].image = "mine.png";
  project.pictures[project::kDestination].image = "yours.png";
  project.output.frames = 7;
  project.pull.a = 5;
  load_features(project, write("features.json", R"({"morphkit": 1, "groups": [{"id": "g"}],
    "features": [{"id": "p", "group": "g", "point": {"source": [1, 2], "destination": [3, 4]}}]})"));
  EXPECT_EQ(project.pictures[project::kSource].image, "mine.png");
  EXPECT_EQ(project.output.frames, 7);
  EXPECT_EQ(project.pull.a, 5);
  ASSERT_EQ(project.features.size(), 1U);
  EXPECT_EQ(project.features[0].group, "g");

  load_features(project, write("whole.json", test::kFull));
  EXPECT_EQ(project.pictures[project::kSource].image, "mine.png");
  EXPECT_EQ(project.output.frames, 7);
  EXPECT_EQ(project.pull.a, 1);
  EXPECT_EQ(project.features.size(), 3U);
}

TEST_F(ReadFeatures, AMeshIsLaidOverAProject) {
  Project project = parse(test::kFull, "");
  load_features(project, write("mesh.json", R"({"morphkit": 1, "mesh": {"size": [4, 3]}})"));
  EXPECT_EQ(project.pictures[project::kSource].image, "cat.png");
  EXPECT_TRUE(project.features.empty());
  ASSERT_TRUE(project.mesh);
  EXPECT_EQ(project.mesh->columns, 4);
  // What corresponds comes from the file alone.
  load_features(project, write("features.json", R"({"morphkit": 1, "features": []})"));
  EXPECT_FALSE(project.mesh);
}

TEST_F(ReadFeatures, AMeshAndTheSettingsThatItIsLaidOverMustAgree) {
  Project project = parse(with(R"("warp": {"border": "mirror"})"), "");
  const auto mesh = write("mesh.json", R"({"morphkit": 1, "mesh": {"size": [4, 3]}})");
  EXPECT_THROW(load_features(project, mesh), Error);
  EXPECT_FALSE(project.mesh);
  project = parse(test::kMesh, "");
  EXPECT_THROW(load_features(project, write("none.json", R"({"morphkit": 1, "features": []})")), Error);
  EXPECT_TRUE(project.mesh);
}

TEST_F(ReadFeatures, BadFeaturesLeaveTheProjectAlone) {
  Project project = parse(test::kFull, "");
  const Project before = project;
  for (const std::string& text : {std::string(R"({"morphkit": 1})"), std::string(R"({"morphkit": 1, "features": 3})"),
                                  with_line(R"("group": "nowhere")"), with_shape(R"("fast")")}) {
    EXPECT_THROW(load_features(project, write("bad.json", text)), Error) << text;
    EXPECT_TRUE(same_document(project, before));
  }
  EXPECT_THROW(load_features(project, directory_.path() / "missing.json"), Error);
}

}  // namespace
}  // namespace morphkit::project
