// Tests cli/cmd_import.cpp, cli/run_import.cpp, cli/cmd_export.cpp and cli/run_export.cpp.
// import and export as a person or a script meets them, wrong use included.

#include <filesystem>

#include <gtest/gtest.h>

#include "morph/media/image_file.h"
#include "morph/project/project.h"
#include "tests/cli/run_program.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::test {
namespace {

namespace fs = std::filesystem;

/// 3 x 2 vertices on a picture of 41 x 31 pixels.
constexpr const char* kMesh = "M2\n3 2\n0 0 0\n150 0 0\n400 0 0\n0 300 0\n200 300 0\n400 300 0\n";

/// Two pictures of different size in a folder of their own, two meshes beside it, and the program run from there.
class Import : public testing::Test {
 protected:
  Import() {
    fs::create_directory(folder_ / "plates");
    media::write_image(folder_ / "plates/a.png", warp::Image(31, 41, {0.5F, 0.25F, 0, 1}));
    media::write_image(folder_ / "plates/b.png", warp::Image(61, 81, {0, 0.25F, 0.5F, 1}));
    write_text(folder_ / "a.mesh", kMesh);
    write_text(folder_ / "b.mesh", kMesh);
  }

  RunResult run(const std::vector<std::string>& arguments) const {
    RunOptions options;
    options.folder = folder_.path();
    return run_morphkit(arguments, options);
  }
  RunResult run_import(const std::string& output, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"import",        "a.mesh",       "b.mesh", "--source", "plates/a.png",
                                          "--destination", "plates/b.png", "-o",     output};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  void expect_failure(const std::vector<std::string>& arguments, int code, const std::string& says) const {
    const std::vector<std::string> before = folder_.names();
    const RunResult result = run(arguments);
    EXPECT_EQ(result.exit_code, code) << result.err;
    EXPECT_TRUE(contains(result.err, says)) << result.err;
    EXPECT_EQ(folder_.names(), before);
  }

  TemporaryFolder folder_;
};

TEST_F(Import, MakesAProjectThatRenders) {
  const RunResult result = run_import("pair.json");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(contains(result.err, "b.mesh: drawn on 41 x 31 pixels, stretched to 81 x 61")) << result.err;
  EXPECT_TRUE(contains(result.err, "pair.json: a mesh of 3 x 2 vertices from xmorph")) << result.err;
  const project::Project project = project::load(folder_ / "pair.json");
  EXPECT_EQ(project.pictures[project::kSource].image, "plates/a.png");
  EXPECT_EQ(project.warp.method, project::MethodName::kMesh);
  EXPECT_EQ(project.mesh->vertices[project::kSource].at(1), cv::Point2d(15.5, 0));
  EXPECT_EQ(project.mesh->vertices[project::kDestination].at(5), cv::Point2d(81, 61));
  const RunResult rendered = run({"morph", "pair.json", "-t", "0.5", "-o", "middle.png"});
  EXPECT_EQ(rendered.exit_code, 0) << rendered.err;
}

TEST_F(Import, PicturesAreNamedAsTheProjectSeesThem) {
  fs::create_directories(folder_ / "shots/one");
  ASSERT_EQ(run_import("shots/one/pair.json", {"-q"}).exit_code, 0);
  const project::Project project = project::load(folder_ / "shots/one/pair.json");
  EXPECT_EQ(project.pictures[project::kSource].image, "../../plates/a.png");
  EXPECT_TRUE(fs::exists(project::resolve(project, project.pictures[project::kDestination].image)));

  // A link to the folder of the project: ".." starts where it leads.
  fs::create_directory_symlink("shots/one", folder_ / "link");
  ASSERT_EQ(run_import("link/other.json").exit_code, 0);
  const project::Project other = project::load(folder_ / "link/other.json");
  EXPECT_TRUE(fs::exists(project::resolve(other, other.pictures[project::kSource].image)))
      << other.pictures[project::kSource].image;
}

TEST_F(Import, AProjectIsReplacedOnlyWhenAsked) {
  write_text(folder_ / "pair.json", "mine");
  const RunResult refused = run_import("pair.json");
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_TRUE(contains(refused.err, "pair.json: already exists; use --overwrite")) << refused.err;
  EXPECT_EQ(read_text(folder_ / "pair.json"), "mine");
  EXPECT_EQ(run_import("pair.json", {"-y"}).exit_code, 0);
  EXPECT_NO_THROW(project::load(folder_ / "pair.json"));
}

TEST_F(Import, WrongUseAndBadFiles) {
  const std::vector<std::string> rest = {"--source",     "plates/a.png", "--destination",
                                         "plates/b.png", "-o",           "pair.json"};
  const auto import = [&](std::vector<std::string> files) {
    files.insert(files.begin(), "import");
    files.insert(files.end(), rest.begin(), rest.end());
    return files;
  };
  expect_failure({"import"}, 2, "FILE is required");
  expect_failure({"import", "a.mesh", "b.mesh", "--source", "plates/a.png", "-o", "pair.json"}, 2, "--destination");
  expect_failure(import({"a.mesh"}), 2, "two .mesh files");
  expect_failure(import({"a.mesh", "b.mesh", "c.mesh"}), 2, "3 files are named");
  expect_failure(import({"a.mesh", "plates/b.png"}), 2, "no format has the extension '.png'");
  expect_failure(import({"a.mesh", "missing.mesh"}), 4, "missing.mesh: cannot be read");
  write_text(folder_ / "cut.mesh", std::string(kMesh).substr(0, 30));
  expect_failure(import({"a.mesh", "cut.mesh"}), 3, "cut.mesh:");
  expect_failure(
      {"import", "a.mesh", "b.mesh", "--source", "none.png", "--destination", "plates/b.png", "-o", "p.json"}, 4,
      "none.png: does not exist");
}

TEST_F(Import, ASessionNeedsNoOtherNames) {
  write_text(folder_ / "plates/x.session",
             "<gtkmorph session>\n<image>\n<image file in>\na.png\n<mesh file>\n../a.mesh\n</image>\n"
             "<image>\n<image file in>\nb.png\n<mesh file>\n../b.mesh\n</image>\n"
             "<resulting_size>\n41 31\n</resulting_size>\n</gtkmorph session>\n");
  const RunResult result = run({"import", "plates/x.session", "-o", "pair.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(project::load(folder_ / "pair.json").pictures[project::kDestination].image, "plates/b.png");
  EXPECT_EQ(run({"morph", "pair.json", "-t", "0.5", "-o", "middle.png"}).exit_code, 0);
}

TEST_F(Import, ExportGivesTheMeshesBack) {
  ASSERT_EQ(run_import("pair.json").exit_code, 0);
  const RunResult result = run({"export", "pair.json", "x.mesh", "y.mesh"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.err, "x.mesh, y.mesh written")) << result.err;
  EXPECT_EQ(read_text(folder_ / "x.mesh"), kMesh);
  EXPECT_EQ(read_text(folder_ / "y.mesh"), "M2\n3 2\n0 0 0\n300 0 0\n800 0 0\n0 600 0\n400 600 0\n800 600 0\n");
  expect_failure({"export", "pair.json", "x.mesh", "z.mesh"}, 4, "x.mesh: already exists");
  EXPECT_EQ(run({"export", "pair.json", "x.mesh", "z.mesh", "-y", "-q"}).err, "");
}

TEST_F(Import, ExportOfWhatIsNotThere) {
  write_text(folder_ / "lines.json",
             R"({"morphkit": 1, "source": {"image": "plates/a.png"}, "destination": {"image": "plates/b.png"}})");
  expect_failure({"export", "lines.json", "x.mesh", "y.mesh"}, 3, "lines.json: has no \"mesh\"");
  expect_failure({"export", "lines.json"}, 2, "FILE is required");
  expect_failure({"export", "missing.json", "x.mesh", "y.mesh"}, 4, "missing.json");
  expect_failure({"export", "lines.json", "x.mesh"}, 2, "two .mesh files");
}

TEST_F(Import, ExportOfAnEvenMeshHasTheSizeOfThePictures) {
  write_text(folder_ / "even.json",
             R"({"morphkit": 1, "source": {"image": "plates/a.png"}, "destination": {"image": "plates/b.png"},
                 "mesh": {"size": [2, 2]}})");
  ASSERT_EQ(run({"export", "even.json", "x.mesh", "y.mesh"}).exit_code, 0);
  EXPECT_EQ(read_text(folder_ / "x.mesh"), "M2\n2 2\n0 0 0\n400 0 0\n0 300 0\n400 300 0\n");
  EXPECT_EQ(read_text(folder_ / "y.mesh"), "M2\n2 2\n0 0 0\n800 0 0\n0 600 0\n800 600 0\n");
}

}  // namespace
}  // namespace morphkit::test
