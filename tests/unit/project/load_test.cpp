#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "morph/project/project.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/project/documents.h"

namespace morphkit::project {
namespace {

using test::Bad;
using test::expect_bad;
using test::with;
using test::with_feature;
using test::with_line;
using test::with_mesh;
using test::with_output;
using test::with_shape;

/// Syntax errors have a line and a column instead of a pointer.
void expect_syntax_error(const std::string& text, const std::string& place, const std::string& says) {
  SCOPED_TRACE(text.substr(0, 300));
  try {
    parse(text, "pair.json");
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_EQ(error.place(), place);
    EXPECT_NE(error.message().find(says), std::string::npos) << error.message();
    EXPECT_LT(error.message().size(), 300U);
  }
}

TEST(Load, EverythingThatAProjectCanSay) {
  const Project project = parse(test::kFull, "dir/pair.json");
  EXPECT_EQ(project.file, "dir/pair.json");
  EXPECT_EQ(project.pictures[project::kSource], (Picture{"source", "cat.png", "srgb"}));
  EXPECT_EQ(project.pictures[project::kDestination], (Picture{"destination", "tiger.png", ""}));

  ASSERT_EQ(project.groups.size(), 1U);
  Pull face;
  face.b = 1.5;
  const motion::Timing timing{motion::CubicBezierEase{0.42, 0, 0.58, 1}, 0, 1};
  EXPECT_EQ(project.groups[0], (Group{"face", face, Pace{timing, std::nullopt}}));

  ASSERT_EQ(project.features.size(), 3U);
  EXPECT_EQ(project.features[0].places, (std::vector<Points>{{{310, 220}, {365, 218}}, {{402, 198}, {470, 201}}}));
  EXPECT_EQ(project.features[0].group, "face");
  EXPECT_EQ(project.features[1].mark, Mark(Point{}));
  EXPECT_EQ(project.features[1].pull.a, 10);
  EXPECT_EQ(project.features[2].mark, Mark(Curve{}));
  EXPECT_EQ(project.features[2].places[project::kDestination].size(), 4U);
  EXPECT_EQ(project.features[2].pace.dissolve, (motion::Timing{motion::SineEase{}, 0.25, 0.5}));

  EXPECT_EQ(project.pull.between, Between::kCentre);
  EXPECT_EQ(project.pull.turns, -1);
  const motion::KeysEase keys{{{0, 0, std::nullopt}, {0.4, 0.9, 0.1}, {1, 1, std::nullopt}}};
  EXPECT_EQ(project.pace.shape, (motion::Timing{keys, 0, 1}));
  EXPECT_EQ(project.output.size, cv::Size(1280, 720));
  EXPECT_EQ(project.output.background, (Background{Color{1, 1, 1, 1}}));
}

TEST(Load, AMesh) {
  const Project project = parse(test::kMesh, "pair.json");
  ASSERT_TRUE(project.mesh);
  EXPECT_EQ(project.mesh->columns, 3);
  EXPECT_EQ(project.mesh->rows, 2);
  EXPECT_EQ(project.mesh->vertices[project::kSource],
            (std::vector<cv::Point2d>{{0, 0}, {320, 0}, {640, 0}, {0, 480}, {300.5, 480}, {640, 480}}));
  EXPECT_TRUE(project.mesh->vertices[project::kDestination].empty());
  EXPECT_EQ(project.mesh->groups, (std::vector<MeshGroup>{{"rim", {{0, 0}, {2, 1}}}, {"face", {{1, 0}}}}));
  EXPECT_EQ(project.warp.method, MethodName::kMesh);
  EXPECT_EQ(project.warp.of<MeshMethod>().spline, warp::MeshSpline::kMonotone);
  EXPECT_EQ(project.warp.of<MeshMethod>().order, warp::PassOrder::kRowsFirst);
}

TEST(Load, TheSmallestProjectHasTheDefaults) {
  const Project project = parse(with(""), "");
  Project expected;
  expected.pictures[project::kSource].image = "a.png";
  expected.pictures[project::kDestination].image = "b.png";
  EXPECT_TRUE(same_document(project, expected));
  EXPECT_EQ(project.warp.filter, warp::Filter::kArea);
  EXPECT_FALSE(project.warp.border);
  EXPECT_EQ(project.output.frames, 48);
  EXPECT_EQ(project.output.fit, Fit::kCover);
}

TEST(Load, AllGoodDocuments) {
  for (const std::string& text : test::good_documents()) {
    SCOPED_TRACE(text);
    EXPECT_NO_THROW(parse(text, "pair.json"));
  }
}

TEST(Load, WrongStructureNamesThePlace) {
  for (const Bad& bad : test::structurally_bad_documents()) expect_bad(bad);
}

TEST(Load, DoubledKeysAndOddNamesNameThePlace) {
  const Bad table[] = {
      {with_line(R"("warp": {"a": 1, "b": 2, "a": 3})"), "/features/0/warp/a", "\"a\" occurs twice"},
      {R"({"morphkit": 1, "morphkit": 1})", "/morphkit", "occurs twice"},
      {with_feature(R"({"id": "a\u0000b"})"), "/features/0/id", "a control character"},
      {with(R"("a/b~c": 1)"), "/a~1b~0c", "unknown key"},
  };
  for (const Bad& bad : table) expect_bad(bad);
}

TEST(Load, SyntaxErrorsNameLineAndColumn) {
  expect_syntax_error("{\n  \"morphkit\": 1,\n}", "pair.json:3:1", "comma before the closing bracket");
  expect_syntax_error("{\"morphkit\": 1", "pair.json:1:15", "cut off");
  expect_syntax_error("{\"morphkit\": NaN}", "pair.json:1:14", "no NaN");
  expect_syntax_error("{\n  // note\n}", "pair.json:2:3", "no comments");
  expect_syntax_error("{\"\xC3\xA4\xC3\xB6\": 1 2}", "pair.json:1:10", "comma missing");
  expect_syntax_error("{'morphkit': 1}", "pair.json:1:2", "double quotes");
  expect_syntax_error("{\"morphkit\": 1} {}", "pair.json:1:17", "ended already");
  expect_syntax_error("{\"id\": \"\xFF\"}", "pair.json:1:9", "not UTF-8");
  expect_syntax_error("{\"a\": \"\\ud800\"}", "pair.json:1:14", "not valid JSON");
  expect_syntax_error(std::string("{\"a\"\0: 1}", 9), "pair.json:1:5", "zero byte");
  expect_syntax_error("hello", "pair.json:1:1", "not valid JSON");
  expect_syntax_error("{\"a\": \"" + std::string(100000, 'x'), "pair.json:1:100008", "cut off");
}

TEST(Load, EmptyAndOtherwiseEncodedFiles) {
  expect_bad({"", "", "the file is empty"});
  expect_bad({" \n\t", "", "the file is empty"});
  expect_bad({"\xFF\xFE{\0", "", "UTF-16"});
  EXPECT_TRUE(same_document(parse("\xEF\xBB\xBF" + with(""), ""), parse(with(""), "")));
}

TEST(Load, HostileSizesEndEarly) {
  const std::string deep(10'000'000, '[');
  std::string innermost;
  for (int i = 0; i < 31; ++i) innermost += "/0";
  expect_bad({deep, innermost, "nested more than 32 deep"});
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_THROW(parse(objects, "deep.json"), Error);
  std::string many = "[0";
  for (int i = 0; i < 10'000'000; ++i) many += ",0";
  expect_bad({many + "]", "", "more than 10000000 values"});
  many.resize(5'000'000);
  expect_bad({many + ",0,\"\",\"\"" + many.substr(2) + "]", "", "more than 4000000 values outside of lists"});
  std::string repeated = "{";
  for (int i = 0; i < 200'000; ++i) repeated.append("\"").append(std::to_string(i)).append("\":0,");
  expect_bad({repeated + "\"7\":1}", "/7", "occurs twice"});
  expect_bad({with("\"" + std::string(1'000'000, 'k') + "\": 1"), "/" + std::string(100, 'k'), "..."});
}

class LoadFile : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) {
    const auto path = directory_.path() / name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  static ErrorKind code_of(const std::filesystem::path& file) {
    try {
      load(file);
    } catch (const Error& error) {
      EXPECT_EQ(error.place().find(file.string()), 0U) << error.what();
      return error.kind();
    }
    return ErrorKind::kFailed;
  }
  test::TemporaryFolder directory_;
};

TEST_F(LoadFile, RemembersWhereItCameFrom) {
  const auto file = write("pair.json", test::kFull);
  const Project project = load(file);
  EXPECT_EQ(project.file, file);
  EXPECT_EQ(*project.original, test::kFull);
  EXPECT_EQ(resolve(project, project.pictures[project::kSource].image), directory_.path() / "cat.png");
  EXPECT_EQ(resolve(project, "/abs.png"), "/abs.png");
}

TEST_F(LoadFile, MissingDirectoryAndUnreadable) {
  EXPECT_EQ(code_of(directory_.path() / "missing.json"), ErrorKind::kIo);
  EXPECT_EQ(code_of(directory_.path()), ErrorKind::kIo);
  EXPECT_EQ(code_of(write("empty.json", "")), ErrorKind::kBadInput);
  const auto secret = write("secret.json", test::kFull);
  std::filesystem::permissions(secret, std::filesystem::perms::none);
  if (::geteuid() != 0) {  // root reads everything
    EXPECT_EQ(code_of(secret), ErrorKind::kIo);
  }
}

}  // namespace
}  // namespace morphkit::project
