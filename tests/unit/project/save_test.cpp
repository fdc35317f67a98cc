#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "morph/project/project.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/project/documents.h"
#include "tests/unit/project/random_project.h"

namespace morphkit::project {
namespace {

using test::contains;
using test::RandomProject;
using test::with;
using test::with_output;
using test::with_shape;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Indices of the lines that differ; both texts have the same number of lines.
std::vector<std::size_t> changed_lines(const std::string& before, const std::string& after) {
  const auto a = lines_of(before), b = lines_of(after);
  EXPECT_EQ(a.size(), b.size()) << after;
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (a[i] != b[i]) changed.push_back(i);
  }
  return changed;
}

TEST(ToText, RandomProjectsReadBackEqual) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    const Project project = RandomProject(seed).make();
    const std::string text = to_text(project);
    ASSERT_TRUE(same_document(parse(text, "x.json"), project)) << text;
  }
}

TEST(ToText, ChangedRandomProjectsReadBackEqual) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    RandomProject random(seed);
    Project project = parse(to_text(random.make()), "x.json");
    for (int step = 0; step < 4; ++step) {
      random.change(project);
      const std::string text = to_text(project);
      ASSERT_TRUE(same_document(parse(text, "x.json"), project)) << text;
      if (random.coin()) project = parse(text, "x.json");
    }
  }
}

TEST(ToText, AnyProjectOverTheTextOfAnyOther) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Project project = RandomProject(seed).make();
    project.original = std::make_shared<const std::string>(to_text(RandomProject(seed + 5000).make()));
    const std::string text = to_text(project);
    ASSERT_TRUE(same_document(parse(text, "x.json"), project)) << *project.original << text;
  }
  const auto documents = test::good_documents();
  for (const std::string& original : documents) {
    for (const std::string& wanted : documents) {
      Project project = parse(wanted, "x.json");
      project.original = std::make_shared<const std::string>(original);
      const std::string text = to_text(project);
      ASSERT_TRUE(same_document(parse(text, "x.json"), project)) << original << wanted << text;
    }
  }
}

TEST(ToText, AnUntouchedDocumentIsTheSameText) {
  for (const std::string& text : test::good_documents()) EXPECT_EQ(to_text(parse(text, "x.json")), text);
  for (unsigned seed = 0; seed < 100; ++seed) {
    const std::string text = to_text(RandomProject(seed).make());
    EXPECT_EQ(to_text(parse(text, "x.json")), text) << seed;
  }
}

TEST(ToText, SavingTwiceChangesNothing) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    RandomProject random(seed);
    Project project = parse(to_text(random.make()), "x.json");
    random.change(project);
    const std::string once = to_text(project);
    EXPECT_EQ(to_text(parse(once, "x.json")), once) << seed;
  }
}

TEST(ToText, OneMovedPointChangesOneLine) {
  Project project = parse(test::kFull, "x.json");
  project.features[0].places[project::kDestination][1].y = 77.25;
  const std::string text = to_text(project);
  EXPECT_EQ(changed_lines(test::kFull, text), std::vector<std::size_t>{8});
  EXPECT_TRUE(contains(text, R"("destination": [[402, 198.0], [470, 77.25]]}},)")) << text;
}

TEST(ToText, OrderSpellingAndExplicitDefaultsSurviveChangesElsewhere) {
  Project project = parse(test::kFull, "x.json");
  project.output.frames = 96;
  project.features[2].pace.dissolve->delay = 0.5;
  const std::string text = to_text(project);
  EXPECT_EQ(changed_lines(test::kFull, text), (std::vector<std::size_t>{14, 20}));
  EXPECT_TRUE(contains(text, R"({"ease": "sine", "delay": 0.5, "duration": 0.5})")) << text;
  EXPECT_TRUE(contains(text, R"("output": {"fps": "24", "frames": 96, "size": [1280, 720], "background": "#FFffFF"})"));
}

TEST(ToText, ANewFeatureIsLaidOutLikeItsNeighbours) {
  Project project = parse(test::kFull, "x.json");
  Feature ear;
  ear.id = "ear";
  ear.places[project::kSource] = {{1, 2}, {3, 4}};
  ear.places[project::kDestination] = {{5, 6}, {7, 8.5}};
  project.features.push_back(ear);
  const auto before = lines_of(test::kFull), after = lines_of(to_text(project));
  ASSERT_EQ(after.size(), before.size() + 1);
  EXPECT_EQ(after[15], R"(    {"id": "ear", "line": {"source": [[1, 2], [3, 4]], "destination": [[5, 6], [7, 8.5]]}})");
  EXPECT_EQ(after[14], before[14] + ",");

  project.features.erase(project.features.begin() + 1);
  const auto removed = lines_of(to_text(project));
  EXPECT_EQ(removed.size(), before.size());
  EXPECT_EQ(removed[8], before[8]);
  EXPECT_EQ(removed[9], before[10]);
}

TEST(ToText, OtherLayoutsAreImitated) {
  const std::string tabs =
      "{\n\t\"morphkit\": 1,\n\t\"destination\": {\"image\": \"b\"},\n\t\"source\": {\"image\": \"a\"}\n}\n";
  Project project = parse(tabs, "x.json");
  project.output.frames = 9;
  EXPECT_EQ(to_text(project),
            "{\n\t\"morphkit\": 1,\n\t\"destination\": {\"image\": \"b\"},\n\t\"source\": {\"image\": \"a\"},"
            "\n\t\"output\": {\"frames\": 9}\n}\n");
  Project compact = parse(R"({"morphkit":1,"source":{"image":"a"},"destination":{"image":"b"}})", "x.json");
  compact.warp.filter = warp::Filter::kNearest;
  EXPECT_EQ(to_text(compact),
            R"({"morphkit":1,"source":{"image":"a"},"destination":{"image":"b"},"warp": {"filter": "nearest"}})"
            "\n");
}

TEST(ToText, RemovedSettingsVanishAndNewOnesStandInTheirPlace) {
  Project project = parse(test::kFull, "x.json");
  project.features[1].pull.a.reset();
  project.features[1].group = "face";
  project.pull.turns.reset();
  const std::string text = to_text(project);
  EXPECT_TRUE(contains(text, R"({"id": "nose", "group": "face", "point": {)")) << text;
  EXPECT_FALSE(contains(text, "1e1"));
  EXPECT_FALSE(contains(text, "turns"));
}

TEST(ToText, ARenamedFeatureKeepsTheRest) {
  Project project = parse(test::kFull, "x.json");
  project.features[0].id = "right eye";
  EXPECT_EQ(changed_lines(test::kFull, to_text(project)), std::vector<std::size_t>{8});
  EXPECT_TRUE(contains(to_text(project), "198.0"));
}

TEST(ToText, DefaultsAreLeftOutOfANewDocument) {
  Project project;
  project.pictures[project::kSource].image = "a.png";
  project.pictures[project::kDestination].image = "b.png";
  EXPECT_EQ(
      to_text(project),
      "{\n  \"morphkit\": 1,\n  \"source\": {\"image\": \"a.png\"},\n  \"destination\": {\"image\": \"b.png\"}\n}\n");
}

TEST(ToText, SpellingsOfTheSameValueAreKept) {
  for (const char* fps : {"24", "24.0", "\"24\"", "\"24/1\"", "29.97", "\"30000/1001\""}) {
    Project project = parse(with_output(std::string("\"frames\": 3, \"fps\": ") + fps), "");
    project.output.frames = 4;
    EXPECT_TRUE(contains(to_text(project), std::string("\"frames\": 4, \"fps\": ") + fps)) << to_text(project);
  }
  for (const char* shape :
       {R"("ease-in")", R"({"ease": "ease-in"})", R"({"ease":"cubic-bezier","handles":[0.42,0,1,1.0]})"}) {
    Project project = parse(with_shape(shape), "");
    project.blend = Blend::kDisplay;
    EXPECT_TRUE(contains(to_text(project), shape)) << to_text(project);
  }
}

TEST(ToText, LongCurvesAreWrapped) {
  Project project = parse(with(""), "");
  project.original = nullptr;
  Feature curve;
  curve.id = "outline";
  curve.mark = project::Curve{};
  for (int i = 0; i < 100; ++i) curve.places[project::kSource].push_back({i * 10.5, i * 3.25});
  curve.places[project::kDestination] = curve.places[project::kSource];
  project.features = {curve};
  for (const std::string& line : lines_of(to_text(project))) EXPECT_LE(line.size(), 120U) << line;
}

TEST(ToText, ANewMeshHasOneOfItsRowsOnEachLine) {
  Project project = parse(with(""), "");
  project.original = nullptr;
  project.groups = {{"face", {}, {}}};
  project.mesh = Mesh{3, 2, {{{0, 0}, {320, 0}, {640, 0}, {0, 480}, {300.5, 480}, {640, 480}}, {}}, {}};
  project.mesh->groups = {{"face", {{1, 0}, {1, 1}}}};
  const std::string mesh =
      R"(  "mesh": {
    "size": [3, 2],
    "source": [
      [0, 0], [320, 0], [640, 0],
      [0, 480], [300.5, 480], [640, 480]
    ],
    "groups": [
      {"group": "face", "vertices": [[1, 0], [1, 1]]}
    ]
  }
}
)";
  EXPECT_TRUE(to_text(project).ends_with(mesh)) << to_text(project);
}

TEST(ToText, AMovedVertexChangesOneLine) {
  Project project = parse(test::kMesh, "x.json");
  project.mesh->vertices[project::kSource][4].x = 310;
  const std::string text = to_text(project);
  EXPECT_EQ(changed_lines(test::kMesh, text), std::vector<std::size_t>{9});
  EXPECT_TRUE(contains(text, "      [0, 480], [310, 480], [640, 480]\n")) << text;
}

TEST(ToText, AMeshOfAnotherSizeIsLaidOutAnew) {
  Project project = parse(test::kMesh, "x.json");
  project.mesh->columns = 2;
  project.mesh->vertices[project::kSource] = {{0, 0}, {640, 0}, {0, 480}, {640, 480}};
  project.mesh->groups = {{"face", {{1, 0}}}};
  const std::string text = to_text(project);
  EXPECT_TRUE(contains(text, "\"source\": [\n      [0, 0], [640, 0],\n      [0, 480], [640, 480]\n    ],")) << text;
  EXPECT_TRUE(contains(text, "\n      {\"vertices\": [[1, 0]], \"group\": \"face\"}\n")) << text;
  EXPECT_TRUE(contains(text, "\"destination\": \"uniform\",")) << text;
}

TEST(ToText, ALargeMeshOnOneLineIsSavedInReasonableTime) {
  // A search for the start of the line at every number would take hours.
  Project project = parse(with(""), "");
  project.original = nullptr;
  project.mesh = Mesh{300, 300, {{}, {}}, {}};
  for (int i = 0; i < 300 * 300; ++i)
    project.mesh->vertices[project::kSource].emplace_back(i % 300 + 0.125, i / 300 + 0.5);
  std::string text = to_text(project);
  std::erase(text, '\n');
  project = parse(text, "x.json");
  project.mesh->vertices[project::kSource][77].x = 5;
  EXPECT_TRUE(same_document(parse(to_text(project), "x.json"), project));
}

TEST(ToText, WhatCannotBeWrittenIsRefused) {
  Project project = parse(with(""), "");
  project.pull.a = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(to_text(project), std::invalid_argument);
  project = parse(with(""), "");
  for (const char* bytes : {"\xFF.png", "\xC3", "\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE0\x80\x80"}) {
    project.pictures[project::kSource].image = bytes;
    EXPECT_THROW(to_text(project), Error);
  }
  for (const char* bytes : {"\xC3\xA4", "\xE2\x82\xAC", "\xF0\x9F\x98\xBA", "\xED\x9F\xBF", "\xF4\x8F\xBF\xBF"}) {
    project.pictures[project::kSource].image = bytes;
    EXPECT_TRUE(same_document(parse(to_text(project), ""), project));
  }
}

class Save : public ::testing::Test {
 protected:
  static std::string read(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::size_t files() const {
    const std::filesystem::directory_iterator list(directory_.path());
    return static_cast<std::size_t>(std::distance(begin(list), end(list)));
  }
  static ErrorKind code_of(const std::filesystem::path& file) {
    try {
      save(parse(test::kFull, ""), file);
    } catch (const Error& error) {
      EXPECT_EQ(error.place(), file.string());
      return error.kind();
    }
    return ErrorKind::kFailed;
  }
  test::TemporaryFolder directory_;
};

TEST_F(Save, WritesTheTextAndNothingElse) {
  const auto file = directory_.path() / "pair.json";
  save(parse(test::kFull, ""), file);
  EXPECT_EQ(read(file), test::kFull);
  Project changed = load(file);
  changed.output.frames = 5;
  save(changed, file);
  EXPECT_EQ(load(file).output.frames, 5);
  EXPECT_EQ(files(), 1U);
}

TEST_F(Save, KeepsPermissionsAndLinks) {
  namespace fs = std::filesystem;
  const fs::path file = directory_.path() / "pair.json", link = directory_.path() / "link.json";
  save(parse(test::kFull, ""), file);
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("pair.json", link);
  Project changed = load(link);
  changed.output.frames = 5;
  save(changed, link);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(load(file).output.frames, 5);
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Save, ReplacesOnlyWhatItMay) {
  const auto file = directory_.path() / "pair.json";
  save(parse(test::kFull, ""), file, false);
  EXPECT_THROW(save(parse(with(""), ""), file, false), Error);
  EXPECT_EQ(read(file), test::kFull);
  save(parse(with(""), ""), file);
  EXPECT_EQ(read(file), with(""));
}

TEST_F(Save, FailuresLeaveNothingBehind) {
  EXPECT_EQ(code_of(directory_.path() / "missing" / "pair.json"), ErrorKind::kIo);
  EXPECT_EQ(code_of(directory_.path()), ErrorKind::kIo);
  EXPECT_EQ(files(), 0U);
}

}  // namespace
}  // namespace morphkit::project
