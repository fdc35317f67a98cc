// Tests cli/cmd_warp.cpp and cli/run_warp.cpp.
// warp as a person or a script meets it, wrong use included; and what a mesh does to morph, map and check.

#include <gtest/gtest.h>

#include "morph/media/image_file.h"
#include "tests/cli/run_program.h"
#include "tests/support/temporary_folder.h"
#include "warp/image/compare.h"

namespace morphkit::test {
namespace {

/// 3 x 3 vertices on a picture of 41 x 31 pixels, the middle one at (20, 15) or moved.
std::string mesh_file(const std::string& middle) {
  return "M2\n3 3\n0 0 0\n200 0 0\n400 0 0\n0 150 0\n" + middle + " 0\n400 150 0\n0 300 0\n200 300 0\n400 300 0\n";
}

class Warp : public testing::Test {
 protected:
  Warp() {
    picture_.create(31, 41);
    for (int y = 0; y < picture_.rows; ++y)
      for (int x = 0; x < picture_.cols; ++x)
        picture_(y, x) = {static_cast<float>(x) / 40, static_cast<float>(y) / 30, 0.5F, 1};
    media::write_image(folder_ / "a.exr", picture_);
    write_text(folder_ / "even.mesh", mesh_file("200 150"));
    write_text(folder_ / "bent.mesh", mesh_file("260 110"));
    write_text(folder_ / "folded.mesh", mesh_file("430 150"));
    write_text(folder_ / "pair.json",
               R"({"morphkit": 1, "source": {"image": "a.exr"}, "destination": {"image": "a.exr"},
      "mesh": {"size": [3, 3], "destination": [[0, 0], [20, 0], [41, 0], [0, 15], [26, 11], [41, 15],
                                               [0, 31], [20, 31], [41, 31]]}, "output": {"frames": 3}})");
  }

  RunResult run(const std::vector<std::string>& arguments) const {
    RunOptions options;
    options.folder = folder_.path();
    return run_morphkit(arguments, options);
  }
  void expect_done(const std::vector<std::string>& arguments) const {
    const RunResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
  void expect_failure(const std::vector<std::string>& arguments, int code, const std::string& says) const {
    const std::vector<std::string> before = folder_.names();
    const RunResult result = run(arguments);
    EXPECT_EQ(result.exit_code, code) << result.err;
    EXPECT_NE(result.err.find(says), std::string::npos) << result.err;
    EXPECT_EQ(folder_.names(), before);
  }
  warp::Image read(const std::string& name) const { return media::read_picture(folder_ / name).image; }

  TemporaryFolder folder_;
  warp::Image picture_;
};

TEST_F(Warp, BendsAnImageOntoAMesh) {
  expect_done({"warp", "a.exr", "--mesh", "bent.mesh", "-o", "bent.exr", "--depth", "float"});
  const warp::Image bent = read("bent.exr");
  ASSERT_EQ(bent.size(), picture_.size());
  // What was in the middle, half red, has moved to the vertex.
  EXPECT_NEAR(bent(11, 26)[0], picture_(15, 20)[0], 0.03);
  EXPECT_NEAR(bent(11, 26)[1], picture_(15, 20)[1], 0.03);
}

TEST_F(Warp, AMeshOntoItselfChangesNothing) {
  expect_done({"warp", "a.exr", "--from", "bent.mesh", "--mesh", "bent.mesh", "-o", "same.exr", "--depth", "float"});
  EXPECT_TRUE(warp::compare(read("same.exr"), read("a.exr")).identical());
}

TEST_F(Warp, AProjectGivesBothMeshes) {
  expect_done({"warp", "a.exr", "--mesh", "pair.json", "-o", "project.exr", "--depth", "float"});
  expect_done({"morph", "pair.json", "--frames", "3", "-o", "frame.%d.exr", "--depth", "float"});
  const warp::Image bent = read("project.exr");
  EXPECT_NEAR(bent(11, 26)[0], picture_(15, 20)[0], 0.03);
  EXPECT_TRUE(warp::compare(read("frame.3.exr"), read("a.exr")).identical());
}

TEST_F(Warp, SizesAndTheImageBetweenThePasses) {
  expect_done({"warp", "a.exr", "--mesh", "bent.mesh", "-o", "large.exr", "--size", "82x93", "--order", "rows-first",
               "--intermediate", "between.exr"});
  EXPECT_EQ(read("large.exr").size(), cv::Size(82, 93));
  EXPECT_EQ(read("between.exr").size(), cv::Size(82, 31));
  expect_done({"warp", "a.exr", "--mesh", "bent.mesh", "-o", "columns.exr", "--size", "82x93", "--order",
               "columns-first", "--intermediate", "between.exr", "-y"});
  EXPECT_EQ(read("between.exr").size(), cv::Size(41, 93));
}

TEST_F(Warp, SetChangesTheProjectThatTheMeshComesFrom) {
  const auto bent = [&](const std::string& file, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"warp", "a.exr", "-o", file, "--depth", "float"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_done(arguments);
    return read(file);
  };
  const warp::Image plain = bent("plain.exr", {"--mesh", "pair.json"});
  const warp::Image linear = bent("short.exr", {"--mesh", "pair.json", "--spline", "linear"});
  EXPECT_FALSE(warp::compare(plain, linear).identical());
  EXPECT_TRUE(
      warp::compare(linear, bent("set.exr", {"--mesh", "pair.json", "--set", "warp.spline=linear"})).identical());
  EXPECT_EQ(bent("large.exr", {"--mesh", "bent.mesh", "--set", "output.size=[82, 93]"}).size(), cv::Size(82, 93));
  EXPECT_TRUE(
      warp::compare(read("a.exr"), bent("even.exr", {"--mesh", "pair.json", "--set", "mesh.destination=uniform"}))
          .identical());
  expect_failure({"warp", "a.exr", "--mesh", "bent.mesh", "-o", "no.exr", "--set", "mesh.size=[3, 3]"}, 2,
                 "the mesh is that of bent.mesh");
  const RunResult unused = run({"warp", "a.exr", "--mesh", "bent.mesh", "-o", "unused.exr", "--set", "warp.b=1"});
  EXPECT_NE(unused.err.find("\"b\" of \"warp\" is not used"), std::string::npos) << unused.err;
}

TEST_F(Warp, TellsTheOrderThatItTook) {
  const RunResult told = run({"warp", "a.exr", "--mesh", "bent.mesh", "-o", "bent.exr", "-v"});
  EXPECT_NE(told.err.find("mesh of 3 x 3 vertices; "), std::string::npos) << told.err;
  EXPECT_NE(told.err.find(" first)"), std::string::npos) << told.err;
}

TEST_F(Warp, FoldsAreRefusedUnlessAllowed) {
  expect_failure({"warp", "a.exr", "--mesh", "folded.mesh", "-o", "out.exr"}, 3,
                 "folded.mesh: the mesh folds over: the vertex in column 2, row 1 is not right of its left neighbour");
  expect_failure({"warp", "a.exr", "--mesh", "folded.mesh", "-o", "out.exr"}, 3,
                 "; move it back into order, or render what can be rendered with --allow-folds\n");
  expect_done({"warp", "a.exr", "--mesh", "folded.mesh", "-o", "out.exr", "--allow-folds"});
  expect_failure({"warp", "a.exr", "--mesh", "bent.mesh", "-o", "out.exr"}, 4,
                 "out.exr: already exists; use --overwrite to replace it\n");
}

TEST_F(Warp, WrongUseIsExplained) {
  write_text(folder_ / "small.mesh", "M2\n2 2\n0 0 0\n400 0 0\n0 300 0\n400 300 0\n");
  write_text(folder_ / "lines.json",
             R"({"morphkit": 1, "source": {"image": "a.exr"}, "destination": {"image": "a.exr"}})");
  expect_failure({"warp", "a.exr", "-o", "out.exr"}, 2, "--mesh");
  expect_failure({"warp", "a.exr", "--mesh", "none.mesh", "-o", "out.exr"}, 4, "none.mesh");
  expect_failure({"warp", "none.exr", "--mesh", "bent.mesh", "-o", "out.exr"}, 4, "none.exr");
  expect_failure({"warp", "a.exr", "--from", "small.mesh", "--mesh", "bent.mesh", "-o", "out.exr"}, 3,
                 "small.mesh: is a mesh of 2 x 2 vertices, but bent.mesh has 3 x 3");
  expect_failure({"warp", "a.exr", "--mesh", "lines.json", "-o", "out.exr"}, 3, "lines.json: has no \"mesh\"");
  expect_failure({"warp", "a.exr", "--mesh", "bent.mesh", "-o", "out.exr", "--spline", "bezier"}, 2, "--spline");
  expect_failure({"warp", "a.exr", "--mesh", "bent.mesh", "-o", "out.exr", "--size", "0x10"}, 2, "--size");
  expect_failure({"warp", "a.exr", "--mesh", "bent.mesh", "-o", "a.exr"}, 4, "a.exr");
  expect_failure({"warp", "a.exr", "--mesh", "bent.mesh", "-o", "a.exr", "--intermediate", "between.exr"}, 4, "a.exr");
  expect_failure({"warp", "a.exr", "--mesh", "bent.mesh", "-o", "b.exr", "--intermediate", "./b.exr"}, 2, "same file");
  expect_failure({"export", "pair.json", "b.mesh", "./b.mesh"}, 2, "named twice");
}

TEST_F(Warp, AFoldedMeshIsRefusedBeforeAnyFrameAndReportedByCheck) {
  write_text(folder_ / "folded.json",
             R"({"morphkit": 1, "source": {"image": "a.exr"}, "destination": {"image": "a.exr"},
    "mesh": {"size": [3, 3], "destination": [[0, 0], [20, 0], [41, 0], [0, 15], [40.9, 40], [41, 15],
                                             [0, 31], [20, 31], [41, 31]]}, "output": {"frames": 3}})");
  expect_failure({"morph", "folded.json", "-o", "frame.%d.png"}, 3,
                 "folded.json: /mesh/destination/7: the destination mesh folds over: the vertex in column 1, row 2");
  EXPECT_EQ(run({"check", "folded.json"}).exit_code, 5);
  const RunResult report = run({"check", "folded.json", "--json"});
  EXPECT_NE(report.out.find("\"mesh-fold\""), std::string::npos) << report.out;
  expect_done({"morph", "folded.json", "--allow-folds", "-o", "frame.%d.png"});
  expect_done({"map", "pair.json", "-t", "0.5", "-o", "map.exr"});
}

}  // namespace
}  // namespace morphkit::test
