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
using test::with;
using test::with_feature;
using test::with_line;
using test::with_mesh;
using test::with_output;
using test::with_shape;

void expect_bad(const Bad& bad) {
  SCOPED_TRACE(bad.text.substr(0, 300));
  try {
    parse(bad.text, "dir/pair.json");
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_EQ(error.place(), bad.pointer.empty() ? "dir/pair.json" : "dir/pair.json: " + bad.pointer);
    EXPECT_NE(error.message().find(bad.says), std::string::npos) << error.message();
  }
}

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
  EXPECT_EQ(project.warp.mesh.spline, warp::MeshSpline::kMonotone);
  EXPECT_EQ(project.warp.mesh.order, warp::PassOrder::kRowsFirst);
}

TEST(Load, TheMethodIsAsTheProjectSaysOrHas) {
  const std::string features = R"(, "features": [{"id": "x", "point": {"source": [0, 0], "destination": [0, 0]}}])";
  const std::string mesh = R"("mesh": {"size": [2, 2]})";
  const auto method = [](const std::string& more) { return method_name_of(parse(with(more), "")); };
  EXPECT_EQ(method(""), MethodName::kLines);
  EXPECT_EQ(method(mesh), MethodName::kMesh);
  EXPECT_EQ(method(mesh + features), MethodName::kLines);
  EXPECT_EQ(method(mesh + features + R"(, "warp": {"method": "mesh"})"), MethodName::kMesh);
  EXPECT_EQ(method(mesh + R"(, "warp": {"method": "lines"})"), MethodName::kLines);
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

TEST(Load, FrameRates) {
  const auto rate = [](const std::string& fps) { return parse(with_output("\"fps\": " + fps), "").output.fps; };
  EXPECT_EQ(rate("25"), (Rate{25, 1}));
  EXPECT_EQ(rate("25.0"), (Rate{25, 1}));
  EXPECT_EQ(rate("\"25\""), (Rate{25, 1}));
  EXPECT_EQ(rate("\"25/2\""), (Rate{25, 2}));
  EXPECT_EQ(rate("\"30000/1001\""), (Rate{30000, 1001}));
  EXPECT_EQ(rate("23.976"), (Rate{24000, 1001}));
  EXPECT_EQ(rate("29.97"), (Rate{30000, 1001}));
  EXPECT_EQ(rate("59.94"), (Rate{60000, 1001}));
}

TEST(Load, FrameRatesAsPeopleTypeThem) {
  EXPECT_EQ(parse_rate("25"), (Rate{25, 1}));
  EXPECT_EQ(parse_rate("25/2"), (Rate{25, 2}));
  EXPECT_EQ(parse_rate("23.976"), (Rate{24000, 1001}));
  EXPECT_EQ(parse_rate("29.97"), (Rate{30000, 1001}));
  for (const char* text : {"", "fast", "12.5", "0", "-24", "24/0", "1001", "24 ", "24/1/1", "1e9", "nan"})
    EXPECT_FALSE(parse_rate(text)) << text;
}

TEST(Load, Backgrounds) {
  const auto background = [](const std::string& text) {
    return parse(with_output("\"background\": " + text), "").output.background;
  };
  EXPECT_EQ(background("\"transparent\""), Background(Color{0, 0, 0, 0}));
  EXPECT_EQ(background("\"black\""), Background(Color{0, 0, 0, 1}));
  EXPECT_EQ(background("\"#ff000080\""), Background(Color{1, 0, 0, 128 / 255.0}));
  EXPECT_EQ(background("\"#00Ff33\""), Background(Color{0, 1, 0.2, 1}));
  EXPECT_EQ(background("[0.1, 0.2, 0.3, 0.4]"), Background(Color{0.1, 0.2, 0.3, 0.4}));
  EXPECT_EQ(background("{\"image\": \"sky.png\"}"), Background(std::filesystem::path("sky.png")));
}

TEST(Load, AnEasingThatStartsLateFillsTheRest) {
  const auto shape = parse(with_shape(R"({"ease": "sine", "delay": 0.1})"), "").pace.shape;
  EXPECT_EQ(shape, (motion::Timing{motion::SineEase{}, 0.1, 0.9}));
  EXPECT_EQ(motion::progress(*shape, 1), 1);
}

TEST(Load, WrongStructureNamesThePlace) {
  for (const Bad& bad : test::structurally_bad_documents()) expect_bad(bad);
}

TEST(Load, WrongMeaningNamesThePlace) {
  const std::string line = R"({"id": "x", "line": {"source": [[0, 0], [1, 0]], "destination": [[0, 0], [2, 0]]}})";
  const std::string square = "[[0, 0], [9, 0], [9, 9], [0, 0]]", open = "[[0, 0], [9, 0], [9, 9], [0, 1]]";
  const auto curve = [](const std::string& a, const std::string& b, const std::string& more) {
    return with_feature(R"({"id": "x", "curve": {"source": )" + a + R"(, "destination": )" + b + more + "}}");
  };
  const Bad table[] = {
      {with_feature(line + "," + line), "/features/1/id", "\"x\" occurs twice"},
      {with(R"("groups": [{"id": "g"}, {"id": "g"}])"), "/groups/1/id", "\"g\" occurs twice"},
      {with(
           R"("groups": [{"id": "face"}], "features": [{"id": "x", "group": "faec", "point": {"source": [0, 0], "destination": [0, 0]}}])"),
       "/features/0/group", "did you mean \"face\"?"},
      {with_line(R"("group": "face")"), "/features/0/group", "add it to \"groups\""},
      {with_feature(R"({"id": "x", "line": {"source": [[1, 1], [1, 1]], "destination": [[0, 0], [1, 1]]}})"),
       "/features/0/line/source", "on this side only"},
      {with_feature(R"({"id": "x", "line": {"source": [[0, 0], [1, 1]], "destination": [[1, 1], [1, 1]]}})"),
       "/features/0/line/destination", "on this side only"},
      {curve(square, open, ""), "/features/0/curve/source", "ends where it starts on this side only"},
      {curve(open, square, ""), "/features/0/curve/destination", "ends where it starts on this side only"},
      {curve(open, "[[0, 0], [1, 1], [2, 2]]", R"(, "spline": "bezier")"), "/features/0/curve/destination", "3n + 1"},
      {curve(open, "[[5, 5], [5, 5]]", ""), "/features/0/curve/destination", "coincide"},
      {with_shape(R"({"delay": 0.5, "duration": 0.6})"), "/transition/shape", "at most 1"},
      {with_shape(R"({"ease": "parabolic", "t1": 0.8, "t2": 0.2})"), "/transition/shape", "t1 <= t2"},
      {with_shape(R"({"ease": "keys", "keys": [[0, 0], [0.5, 1], [0.5, 1], [1, 1]]})"), "/transition/shape", ""},
      {with_output(R"("size": [65536, 65536])"), "/output/size", "more than 1073741824 pixels"},
      {with_output(R"("fps": "1000000/3")"), "/output/fps", "at most 1000 frames per second"},
      {with_output(R"("fps": "24/0")"), "/output/fps", "a frame rate such as"},
      {with_line(R"("warp": {"a": 1, "b": 2, "a": 3})"), "/features/0/warp/a", "\"a\" occurs twice"},
      {R"({"morphkit": 1, "morphkit": 1})", "/morphkit", "occurs twice"},
      {with_feature(R"({"id": "x", "point": {"source": [0, 1e999], "destination": [0, 0]}})"),
       "/features/0/point/source/1", "\"1e999\" is too large"},
      {with_feature(R"({"id": "a\u0000b"})"), "/features/0/id", "a control character"},
      {with(R"("a/b~c": 1)"), "/a~1b~0c", "unknown key"},
      {with(R"("warp": {"method": "mesh"})"), "/warp/method", "needs a mesh; add \"mesh\": {\"size\""},
      {with(R"("mesh": {"size": [2, 2]}, "warp": {"border": "mirror"})"), "/warp/border", "cannot mirror"},
      {with(R"("features": [)" + line +
            R"(], "mesh": {"size": [2, 2]}, "warp": {"method": "mesh", "border": "mirror"})"),
       "/warp/border", "expected the border \"auto\""},
      {with_mesh(R"("size": [1000, 501])"), "/mesh/size", "1000 x 501 is more than 500000 vertices"},
      {with_mesh(R"("size": [2, 2], "source": [[0, 0], [9, 0], [0, 9], [9, 9], [0, 0]])"), "/mesh/source",
       "expected 4 vertices [x, y] (2 columns x 2 rows, row by row), found an array of 5"},
      {with_mesh(R"("size": [3, 2], "groups": [{"group": "g", "vertices": [[0, 1], [2, 2]]}])"),
       "/mesh/groups/0/vertices/1/1", "0 to 1"},
      {with_mesh(R"("size": [3, 2], "groups": [{"group": "g", "vertices": [[3, 0]]}])"), "/mesh/groups/0/vertices/0/0",
       "0 to 2"},
      {with_mesh(R"("size": [2, 2], "groups": [{"group": "gg", "vertices": []}])"), "/mesh/groups/0/group",
       "no group has the id \"gg\"; add it to \"groups\""},
      {with_mesh(R"("size": [2, 2], "groups": [{"group": "g", "vertices": []}, {"group": "g", "vertices": []}])"),
       "/mesh/groups/1/group", "list them all together"},
      {with_mesh(
           R"("size": [2, 2], "groups": [{"group": "g", "vertices": [[1, 0]]}, {"group": "h", "vertices": [[0, 0], [1, 0]]}])"),
       "/mesh/groups/1/vertices/1", "[1, 0] is in the group \"g\" already"},
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

TEST_F(LoadFile, FeaturesAreLaidOverAProject) {
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

TEST_F(LoadFile, AMeshIsLaidOverAProject) {
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

TEST_F(LoadFile, AMeshAndTheSettingsThatItIsLaidOverMustAgree) {
  Project project = parse(with(R"("warp": {"border": "mirror"})"), "");
  const auto mesh = write("mesh.json", R"({"morphkit": 1, "mesh": {"size": [4, 3]}})");
  EXPECT_THROW(load_features(project, mesh), Error);
  EXPECT_FALSE(project.mesh);
  project = parse(test::kMesh, "");
  EXPECT_THROW(load_features(project, write("none.json", R"({"morphkit": 1, "features": []})")), Error);
  EXPECT_TRUE(project.mesh);
}

TEST_F(LoadFile, BadFeaturesLeaveTheProjectAlone) {
  Project project = parse(test::kFull, "");
  const Project before = project;
  for (const std::string& text : {std::string(R"({"morphkit": 1})"), std::string(R"({"morphkit": 1, "features": 3})"),
                                  with_line(R"("group": "nowhere")"), with_shape(R"("fast")")}) {
    EXPECT_THROW(load_features(project, write("bad.json", text)), Error) << text;
    EXPECT_TRUE(same_document(project, before));
  }
  EXPECT_THROW(load_features(project, directory_.path() / "missing.json"), Error);
}

TEST(Effective, TheNearestSettingWins) {
  Project project = parse(test::kFull, "");
  const Pull nose = effective_pull(project, project.features[1]);
  EXPECT_EQ(nose.a, 10);  // its own
  EXPECT_EQ(nose.b, 2);   // the project's
  const Pull eye = effective_pull(project, project.features[0]);
  EXPECT_EQ(eye.a, 1);
  EXPECT_EQ(eye.b, 1.5);  // its group's
  EXPECT_EQ(effective_pace(project, project.features[0]).shape, project.groups[0].pace.shape);
  EXPECT_EQ(effective_pace(project, project.features[1]).shape, project.pace.shape);
}

TEST(Effective, OfAGroup) {
  const Project project = parse(test::kMesh, "");
  EXPECT_EQ(effective_pace(project, "face").shape, (motion::Timing{motion::SineEase{}, 0, 1}));
  EXPECT_EQ(effective_pace(project, "rim"), effective_pace(project));
  EXPECT_EQ(effective_pull(project, "rim"), effective_pull(project));
  EXPECT_EQ(effective_pace(project, std::string()), effective_pace(project));
}

TEST(Effective, NothingStaysOpen) {
  const Pull pull = effective_pull(Project{});
  const Pace pace = effective_pace(Project{});
  EXPECT_EQ(pull.a, 1);
  EXPECT_EQ(pull.b, 2);
  EXPECT_EQ(pull.p, 0);
  EXPECT_EQ(pull.scale, warp::LineScale::kAlong);
  EXPECT_EQ(pull.between, Between::kEndpoints);
  EXPECT_EQ(pull.turns, 0);
  EXPECT_EQ(pace.shape, motion::Timing{});
  EXPECT_EQ(pace.dissolve, motion::Timing{});
  EXPECT_EQ(effective_pull(Project{}, Feature{}), pull);
  EXPECT_EQ(effective_pace(Project{}, Feature{}), pace);
}

}  // namespace
}  // namespace morphkit::project
