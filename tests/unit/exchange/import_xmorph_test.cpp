#include "morph/exchange/import_xmorph.h"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "morph/project/limits.h"
#include "tests/support/errors.h"
#include "tests/unit/exchange/xmorph_meshes.h"

namespace morphkit::exchange {
namespace {

using test::contains;
using test::error_of;
using test::kXmorphMesh;
using test::largest_distance;
using test::parsed;
using test::random_mesh;
using Points = std::vector<cv::Point2d>;

TEST(XmorphMesh, TenthsOfPixelsFromTheCentreOfTheFirst) {
  std::vector<std::string> remarks;
  const warp::Mesh mesh = parsed(kXmorphMesh, {101, 51}, &remarks);
  EXPECT_EQ(mesh.columns, 3);
  EXPECT_EQ(mesh.rows, 3);
  const Points expected = {{0, 0},      {48.5, 0}, {101, 0},   {0, 24.5}, {52, 26.8},
                           {101, 26.5}, {0, 51},   {50.5, 51}, {101, 51}};
  EXPECT_LT(largest_distance(mesh.vertices, expected), 1e-12);
  for (const std::size_t corner : {0, 2, 6, 8}) EXPECT_EQ(mesh.vertices[corner], expected[corner]);
  EXPECT_EQ(remarks, std::vector<std::string>{});
}

TEST(XmorphMesh, SpellingsOfTheSame) {
  const warp::Mesh mesh = parsed(kXmorphMesh, {101, 51});
  const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
    return text;
  };
  const std::string spellings[] = {replaced(kXmorphMesh, "\n", "\r\n"),
                                   replaced(kXmorphMesh, " 0\n", "\n"),
                                   replaced(kXmorphMesh, " ", " \t"),
                                   replaced(kXmorphMesh, "\n", "\n\n") + "  \n",
                                   replaced(kXmorphMesh, "515 263", "5.15e2 263.0"),
                                   std::string(kXmorphMesh).substr(0, std::string(kXmorphMesh).size() - 1)};
  // "0 0 0" without its label is "0 0", "480 0 0" is "480 0": all but the label stays.
  for (const std::string& text : spellings) EXPECT_EQ(parsed(text, {101, 51}), mesh) << text;
  EXPECT_NEAR(parsed(replaced(kXmorphMesh, "515 263", "515.25 263"), {101, 51}).at(1, 1).x, 52.025, 1e-12);
}

TEST(XmorphMesh, TagsOfGtkmorphThatSayNothingOfPlacesAreLeftOut) {
  std::vector<std::string> remarks;
  const std::string tags = "<SIS>\n<eye>\n7 8\n</eye>\n<eye>\n9 8\n</eye>\n</SIS>\n<features>\n7 nonsense \xFF\n";
  EXPECT_EQ(parsed(kXmorphMesh + tags, {101, 51}, &remarks), parsed(kXmorphMesh, {101, 51}));
  EXPECT_EQ(remarks, std::vector<std::string>{"a.mesh: left out: \"<eye>\", \"<features>\""});
}

/// The frame of 101 x 51 shows the part of 201 x 101 at (20, 10) of a picture of 300 x 200.
TEST(XmorphMesh, LiesOnThePartOfThePictureThatTheTagsName) {
  std::vector<std::string> remarks;
  const std::string tags =
      "<SIS>\n<orig>\n300 200\n</orig>\n<rect>\n20 10 201 101\n</rect>\n</SIS>\n"
      "<resulting image size>\n101 51\n</resulting image size>\n";
  const warp::Mesh mesh = parsed(kXmorphMesh + tags, {300, 200}, &remarks);
  ASSERT_EQ(cv::Size(mesh.columns, mesh.rows), cv::Size(5, 5));
  EXPECT_EQ(mesh.at(2, 2), cv::Point2d(20 + 2 * 51.5 + 0.5, 10 + 2 * 26.3 + 0.5));
  EXPECT_EQ(mesh.at(1, 1), cv::Point2d(20.5, 10.5));
  EXPECT_EQ(mesh.at(3, 3), cv::Point2d(220.5, 110.5));
  EXPECT_EQ(mesh.at(0, 0), cv::Point2d(0, 0));
  EXPECT_EQ(mesh.at(4, 4), cv::Point2d(300, 200));
  EXPECT_EQ(mesh.at(0, 1), cv::Point2d(0, 10.5));
  EXPECT_EQ(remarks, (std::vector<std::string>{
                         "a.mesh: lies on the part 201 x 101 at (20, 10) of the picture",
                         "a.mesh: covers a part of the picture; vertices on the border were added (left, right, top, "
                         "bottom)"}));
  // The same picture at half the size.
  const warp::Mesh half = parsed(kXmorphMesh + tags, {150, 100});
  EXPECT_NEAR(half.at(2, 2).x, 10 + 51.5 * 99.5 / 100 + 0.5, 1e-9);
}

TEST(XmorphMesh, TheFrameIsTheResultingSizeAndNotTheLastVertex) {
  std::string text = kXmorphMesh;
  text.replace(text.find("1000 500 0"), 10, "800 400 0");
  const warp::Mesh mesh = parsed(text + "<resulting image size>\n101 51\n", {101, 51});
  ASSERT_EQ(cv::Size(mesh.columns, mesh.rows), cv::Size(4, 4)) << "a row and a column for the free corner";
  EXPECT_EQ(mesh.at(2, 2), cv::Point2d(80.5, 40.5));
  EXPECT_EQ(mesh.at(1, 1), cv::Point2d(52, 26.8));
}

TEST(XmorphMesh, BadTagsNameTheLine) {
  const auto error = [](const std::string& tags) {
    return std::string(error_of([&] { parsed(kXmorphMesh + tags, {101, 51}); }).what());
  };
  EXPECT_TRUE(contains(error("<rect>\n1 2 3\n"), "a.mesh:13: expected 4 numbers after <rect>, found \"1 2 3\""))
      << error("<rect>\n1 2 3\n");
  EXPECT_TRUE(contains(error("<rect>\n1 2 0 9\n"), "a.mesh:13: <rect> is empty"));
  EXPECT_TRUE(contains(error("<resulting image size>\n1 99\n"), "a.mesh:13: <resulting image size> is too small"));
  EXPECT_TRUE(contains(error("<orig>"), "expected 2 numbers after <orig>, found the end of the file"));
  EXPECT_TRUE(contains(error("<orig>\nnan 5"), "expected 2 numbers"));
}

TEST(XmorphMesh, IsStretchedToThePicture) {
  std::vector<std::string> remarks;
  const warp::Mesh mesh = parsed(kXmorphMesh, {201, 26}, &remarks);
  EXPECT_NEAR(mesh.at(1, 1).x, 51.5 * 2 + 0.5, 1e-12);
  EXPECT_NEAR(mesh.at(1, 1).y, 26.3 / 2 + 0.5, 1e-12);
  EXPECT_EQ(mesh.at(2, 2), cv::Point2d(201, 26));
  EXPECT_EQ(remarks, std::vector<std::string>{"a.mesh: drawn on 101 x 51 pixels, stretched to 201 x 26"});
}

TEST(XmorphMesh, ABorderThatIsOffIsMovedAndToldOf) {
  std::vector<std::string> remarks;
  std::string text = kXmorphMesh;
  text.replace(text.find("0 240 0"), 7, "23 240 ");
  EXPECT_EQ(parsed(text, {101, 51}, &remarks), parsed(kXmorphMesh, {101, 51}));
  EXPECT_EQ(remarks,
            std::vector<std::string>{"a.mesh: vertices of the border were up to 2.3 pixels off and moved onto it"});
}

TEST(XmorphMesh, OnTheSmallestPicture) {
  const warp::Mesh mesh = parsed(kXmorphMesh, {1, 1});
  EXPECT_EQ(mesh.at(0, 0), cv::Point2d(0, 0));
  EXPECT_EQ(mesh.at(1, 1), cv::Point2d(0.5, 0.5));
  EXPECT_EQ(mesh.at(2, 2), cv::Point2d(1, 1));
}

TEST(XmorphMesh, BadFilesNameTheLine) {
  const struct {
    std::string text;
    std::string place;
    std::string says;
  } table[] = {
      {"", "a.mesh:1", "the file is empty"},
      {"\n \r\n", "a.mesh:2", "the file is empty"},
      {"hello\n", "a.mesh:1", "expected \"M2\", the first line of a mesh of xmorph, found \"hello\""},
      {std::string("\x89PNG\r\n\0\xFF\xFE", 9), "a.mesh:1", "expected \"M2\""},
      {"M2", "a.mesh:1", "the file ends here; expected the numbers of columns and rows"},
      {"M2\n3\n", "a.mesh:2", "two whole numbers"},
      {"M2\n3 3 3\n", "a.mesh:2", "two whole numbers"},
      {"M2\n3 x\n", "a.mesh:2", "found \"3 x\""},
      {"M2\n3.5 3\n", "a.mesh:2", "two whole numbers"},
      {"M2\n-3 3\n", "a.mesh:2", "a mesh of -3 x 3 vertices; expected 2 to 1000 each way"},
      {"M2\n1 3\n", "a.mesh:2", "a mesh of 1 x 3 vertices"},
      {"M2\n1000000000 1000000000\n0 0\n", "a.mesh:2", "together at most 500000"},
      {"M2\n1000 501\n0 0\n", "a.mesh:2", "together at most 500000"},
      {"M2\n99999999999999999999999 3\n", "a.mesh:2", "two whole numbers"},
      {"M2\n1000 500\n0 0 0\n", "a.mesh:3", "the file ends after 1 of 500000 vertices (1000 x 500)"},
      {"M2\n2 2\n0 0\n9 0\n\n0 9\n", "a.mesh:6", "the file ends after 3 of 4 vertices (2 x 2)"},
      {"M2\n2 2\n0 0\n9 0\n<SIS>\n0 9\n9 9\n", "a.mesh:5", "a tag after 2 of 4 vertices"},
      {"M2\n2 2\n0 0\n9 0\n0 9\n9 9\n5 5\n", "a.mesh:7", "expected the end of the file after 4 vertices (2 x 2)"},
      {"M2\n2 2\n0 0\n9\n0 9\n9 9\n", "a.mesh:4", "expected a vertex, \"x y\" or \"x y label\""},
      {"M2\n2 2\n0 0\n9 0 0 0\n0 9\n9 9\n", "a.mesh:4", "expected a vertex"},
      {"M2\n2 2\n0 0\n9 0 label\n0 9\n9 9\n", "a.mesh:4", "expected a vertex"},
      {"M2\n2 2\n0 0\n9,5 0\n0 9\n9 9\n", "a.mesh:4", "found \"9,5 0\""},
      {"M2\n2 2\n0 0\nnan 0\n0 9\n9 9\n", "a.mesh:4", "\"nan 0\" is out of range"},
      {"M2\n2 2\n0 0\n9 -inf\n0 9\n9 9\n", "a.mesh:4", "out of range"},
      {"M2\n2 2\n0 0\n9 1e300\n0 9\n9 9\n", "a.mesh:4", "out of range"},
      {"M2\n2 2\n0 0\n9 1e999\n0 9\n9 9\n", "a.mesh:4", "expected a vertex"},
      {"M2\n2 2\n0 0\n9 0\n0 9\n0 9\n", "a.mesh:6", "the last vertex, the lower right corner, is at (0, 9)"},
      {"M2\n2 2\n0 0\n9 0\n0 9\n9 -9\n", "a.mesh:6", "is at (9, -9); expected the size of a picture"},
      {"M2\n2 2\n0 0\n9 0\n0 9\n1e-300 9\n\n<t>\n", "a.mesh:6", "the last vertex"},
      {"M2\n2 2\n0 0\n1e7 0\n0 9\n1 9\n", "a.mesh:6", "far outside the picture"},
  };
  for (const auto& [text, place, says] : table) {
    SCOPED_TRACE(text);
    const Error error = error_of([&, &bad = text] { parsed(bad, {640, 480}); });
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_EQ(error.place(), place);
    EXPECT_TRUE(contains(error.message(), says)) << error.what();
    EXPECT_LT(error.message().size(), 300U);
  }
}

TEST(XmorphMesh, EveryCutIsRefusedOrTheSame) {
  const std::string text = kXmorphMesh;
  const warp::Mesh mesh = parsed(text, {101, 51});
  int whole = 0;
  for (std::size_t length = 0; length < text.size(); ++length) {
    try {
      // The last line without its label, or a part of its last number, is a vertex all the same.
      const warp::Mesh cut = parsed(text.substr(0, length), {101, 51});
      EXPECT_EQ(cut.columns, mesh.columns);
      EXPECT_GE(length, text.size() - std::string(" 500 0\n").size());
      ++whole;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    }
  }
  EXPECT_GE(whole, 3);
}

TEST(XmorphMesh, WhatIsWrittenReadsBackWithinATenthOfAPixel) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> extent(2, 5000);
    const cv::Size size(extent(random), extent(random));
    const warp::Mesh mesh = random_mesh(random, size);
    std::vector<std::string> remarks;
    const warp::Mesh once = parsed(xmorph_mesh_text(mesh, size), size, &remarks);
    ASSERT_EQ(once.columns, mesh.columns);
    EXPECT_LE(largest_distance(once.vertices, mesh.vertices), 0.05 + 1e-9);
    EXPECT_EQ(remarks, std::vector<std::string>{});
    // What is on tenths stays there.
    EXPECT_EQ(xmorph_mesh_text(once, size), xmorph_mesh_text(mesh, size));
  }
}

TEST(XmorphMesh, AMeshThatWasStretchedSurvivesExport) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> extent(2, 5000);
    const cv::Size drawn(extent(random), extent(random)), size(extent(random), extent(random));
    const warp::Mesh first = parsed(xmorph_mesh_text(random_mesh(random, drawn), drawn), size);
    const warp::Mesh second = parsed(xmorph_mesh_text(first, size), size);
    EXPECT_LE(largest_distance(first.vertices, second.vertices), 0.05 + 1e-9);
  }
}

TEST(XmorphMesh, WritesWholeTenthsWithTheBorderOnTheOutermostPixels) {
  EXPECT_EQ(xmorph_mesh_text({2, 3, {{0, 0}, {640, 0}, {0, 240.26}, {640, 250}, {0, 480}, {640, 480}}}, {640, 480}),
            "M2\n2 3\n0 0 0\n6390 0 0\n0 2398 0\n6390 2495 0\n0 4790 0\n6390 4790 0\n");
}

}  // namespace
}  // namespace morphkit::exchange
