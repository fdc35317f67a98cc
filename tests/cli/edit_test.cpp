// Tests cli/cmd_edit.cpp and cli/run_edit.cpp.
// What can be said of `morphkit edit` without a display; tests/gui has one.

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "cli/cmd_edit.h"
#include "morph/media/image_file.h"
#include "tests/cli/run_program.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::cli {
namespace {

namespace fs = std::filesystem;

class Edit : public testing::Test {
 protected:
  Edit() {
    media::write_image(folder_ / "a.png", test::random_image({8, 6}, 1));
    media::write_image(folder_ / "b.png", test::random_image({8, 6}, 2));
  }

  /// As on a machine that nobody sits at.
  test::RunResult run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "edit");
    test::RunOptions options;
    options.folder = folder_.path();
    options.environment = {"DISPLAY=", "WAYLAND_DISPLAY=", "QT_QPA_PLATFORM="};
    return test::run_morphkit(arguments, options);
  }

  static EditOptions pair(const fs::path& a, const fs::path& b, const fs::path& output) {
    EditOptions options;
    options.project.inputs = {a, b};
    options.output = output;
    return options;
  }

  test::TemporaryFolder folder_;
};

TEST_F(Edit, SaysThatThereIsNoDisplay) {
  const test::RunResult result = run({"a.png", "b.png"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(
      result.err,
      "morphkit: error: edit: there is no display to open a window on (DISPLAY and WAYLAND_DISPLAY are not set)\n");
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"a.png", "b.png"}));
}

TEST_F(Edit, RefusesWhatIsNotToBeUnderstood) {
  EXPECT_EQ(run({}).exit_code, 2);
  EXPECT_EQ(run({"a.png"}).exit_code, 2);
  EXPECT_EQ(run({"a.png", "b.png", "--window", "100x100"}).exit_code, 2);
  const test::RunResult large = run({"a.png", "b.png", "--window", "large"});
  EXPECT_EQ(large.exit_code, 2);
  EXPECT_NE(large.err.find("--window: 'large' is no size"), std::string::npos) << large.err;
  EXPECT_EQ(run({"missing.json"}).exit_code, 4);
  test::write_text(folder_ / "bad.json", "{");
  EXPECT_EQ(run({"bad.json"}).exit_code, 3);
  test::write_text(folder_ / "good.json",
                   R"({"morphkit": 1, "source": {"image": "a.png"}, "destination": {"image": "b.png"}})");
  EXPECT_EQ(run({"good.json", "-o", "other.json"}).exit_code, 2);
}

TEST_F(Edit, DoesNotPutFeaturesOverAProjectThatIsThere) {
  test::write_text(folder_ / "a-b.json",
                   R"({"morphkit": 1, "source": {"image": "a.png"}, "destination": {"image": "b.png"},
                                             "features": [{"id": "tip", "point": {"source": [1, 1], "destination": [2, 2]}}]})");
  const test::RunResult result = run({"a.png", "b.png", "--features", "a-b.json"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("a-b.json is there already"), std::string::npos) << result.err;
}

TEST_F(Edit, RefusesToOpenWhatItCouldNotSave) {
  const test::RunResult result = run({"a.png", "b.png", "-o", "nowhere/pair.json"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_NE(result.err.find("nowhere"), std::string::npos) << result.err;
}

TEST_F(Edit, TellsOtherPicturesFromMissingOnes) {
  test::write_text(folder_ / "a-b.json",
                   R"({"morphkit": 1, "source": {"image": "c.png"}, "destination": {"image": "b.png"}})");
  EXPECT_NE(run({"a.png", "b.png"}).err.find("is a project of other pictures (c.png)"), std::string::npos);
  EXPECT_NE(run({"x.png", "b.png", "-o", "a-b.json"}).err.find("x.png: does not exist"), std::string::npos);
}

TEST_F(Edit, NamesTheProjectAfterThePictures) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_.path());
  const project::Project project = project_to_edit(pair("a.png", "b.png", {}));
  fs::current_path(before);
  EXPECT_EQ(project.file, "a-b.json");
  EXPECT_EQ(project.pictures[project::kSource].image, "a.png");
}

TEST_F(Edit, NamesPicturesAsTheProjectSeesThem) {
  fs::create_directory(folder_ / "projects");
  const fs::path file = folder_ / "projects" / "pair.json";
  const fs::path before = fs::current_path();
  fs::current_path(folder_.path());
  const project::Project project = project_to_edit(pair("a.png", "b.png", file));
  fs::current_path(before);
  EXPECT_EQ(project.pictures[project::kSource].image, "../a.png");
  EXPECT_TRUE(
      fs::equivalent(project::resolve(project, project.pictures[project::kDestination].image), folder_ / "b.png"));
}

TEST_F(Edit, GoesOnWithAProjectOfTheSamePicturesOnly) {
  project::Project made = test::small_project();
  made.pictures[project::kSource].image = "a.png";
  made.pictures[project::kDestination].image = "b.png";
  const fs::path file = folder_ / "pair.json";
  project::save(made, file);
  const fs::path a = folder_ / "a.png";
  const fs::path b = folder_ / "b.png";
  EXPECT_EQ(project_to_edit(pair(a, b, file)).features.size(), made.features.size());
  EXPECT_THROW(project_to_edit(pair(b, a, file)), Error);
}

TEST_F(Edit, ChangesByTheCommandLineAreChangesOfTheProject) {
  const std::string text = R"({"morphkit": 1, "source": {"image": "a.png"}, "destination": {"image": "b.png"}})";
  test::write_text(folder_ / "pair.json", text);
  EditOptions options;
  options.project.inputs = {folder_ / "pair.json"};
  options.project.changes.sets = {"output.frames=9"};
  const project::Project project = project_to_edit(options);
  EXPECT_EQ(project.output.frames, 9);
  EXPECT_EQ(*project.original, text) << "the file has not changed";
  options.project = {};
  options.project.changes.sets = {"output.frames=9"};
  options.project.inputs = {folder_ / "a.png", folder_ / "b.png"};
  options.output = folder_ / "pair.json";
  EXPECT_EQ(project_to_edit(options).output.frames, 9);

  const test::RunResult other = run({"pair.json", "--set", "source.image=b.png"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("--set: the pictures of a project stay while it is edited"), std::string::npos) << other.err;
}

}  // namespace
}  // namespace morphkit::cli
