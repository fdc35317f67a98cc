// Tests cli/cmd_bench.cpp and cli/run_bench.cpp.
// morphkit bench: what it tells, and what it refuses. How fast it is, is nobody's business here.

#include <string>

#include <gtest/gtest.h>

#include "morph/media/image_file.h"
#include "tests/cli/run_program.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::test {
namespace {

RunResult bench(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"bench", "--size", "64x48"});
  return run_morphkit(arguments);
}

TEST(Bench, TellsEveryStage) {
  const RunResult result = bench({"--lines", "3", "--filter", "bilinear", "-j", "2"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* part : {"64x48", "3 features", "bilinear", "2 threads", "vectors ", "field", "sampling", "dissolve",
                           "whole frame", "to 8-bit PNG", "to raw video", "to .mp4"})
    EXPECT_TRUE(contains(result.out, part)) << part << " in " << result.out;
}

TEST(Bench, JsonHasTheStagesByName) {
  const RunResult result = bench({"--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out.front(), '{');
  for (const char* key : {"\"width\": 64", "\"height\": 48", "\"work\": \"50 features", "\"filter\": \"area\"",
                          "\"threads\": ", "\"vectors\": ", "\"field\": ", "\"sampling\": ", "\"dissolve\": ",
                          "\"frame\": ", "\"png\": ", "\"raw_video\": ", "\"mp4\": "})
    EXPECT_TRUE(contains(result.out, key)) << key << " in " << result.out;
}

TEST(Bench, SetChangesTheRandomProjectToo) {
  const RunResult result =
      run_morphkit({"bench", "--lines", "3", "--set", "output.size=[60, 40]", "--set", "warp.filter=nearest"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "60x40, 3 features as 3 lines; filter nearest")) << result.out;
}

TEST(Bench, AMeshIsMeasuredAsAWholeFrame) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "b.png"})
    media::write_image(folder / name, warp::Image(60, 80, warp::Pixel(0.5F, 0.25F, 0, 1)));
  write_text(folder / "pair.json", R"({"morphkit": 1, "source": {"image": "a.png"}, "destination": {"image": "b.png"},
    "mesh": {"size": [2, 2]}})");
  const RunResult result = run_morphkit({"bench", (folder / "pair.json").string()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "whole frame")) << result.out;
  for (const char* part : {"  field", "sampling", "dissolve"}) EXPECT_FALSE(contains(result.out, part)) << result.out;
  const RunResult folded = run_morphkit(
      {"bench", (folder / "pair.json").string(), "--set", "mesh.size=[3, 3]", "--set",
       "mesh.source=[[0, 0], [40, 0], [80, 0], [0, 30], [81, 30], [80, 30], [0, 60], [40, 60], [80, 60]]"});
  EXPECT_EQ(folded.exit_code, 0) << folded.err;
}

TEST(Bench, WhatCannotBeMeantIsRefused) {
  const auto refusal = [](const std::vector<std::string>& arguments) {
    const RunResult result = run_morphkit(arguments);
    EXPECT_EQ(result.out, "");
    return std::to_string(result.exit_code) + " " + result.err;
  };
  EXPECT_TRUE(contains(refusal({"bench", "pair.json", "--lines", "3"}), "2 morphkit: error: --lines"));
  EXPECT_TRUE(contains(refusal({"bench", "--size", "big"}), "2 morphkit: error: --size: 'big'"));
  EXPECT_TRUE(contains(refusal({"bench", "--filter", "best"}), "2 morphkit: error: bench: --filter"));
  EXPECT_TRUE(contains(refusal({"bench", "missing.json"}), "4 morphkit: error: missing.json"));
}

}  // namespace
}  // namespace morphkit::test
