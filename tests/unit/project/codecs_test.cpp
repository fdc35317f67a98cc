#include "morph/project/codecs.h"

#include <string>

#include <gtest/gtest.h>

#include "morph/json/json.h"
#include "morph/project/project.h"
#include "tests/unit/project/documents.h"

namespace morphkit::project {
namespace {

using test::Bad;
using test::expect_bad;
using test::with_feature;
using test::with_mesh;
using test::with_output;

TEST(Codecs, ValuesOutOfBoundsNameThePlace) {
  const Bad table[] = {
      {with_output(R"("size": [65536, 65536])"), "/output/size", "more than 1073741824 pixels"},
      {with_feature(R"({"id": "x", "point": {"source": [0, 1e999], "destination": [0, 0]}})"),
       "/features/0/point/source/1", "\"1e999\" is too large"},
      {with_mesh(R"("size": [1000, 501])"), "/mesh/size", "1000 x 501 is more than 500000 vertices"},
      {with_mesh(R"("size": [2, 2], "source": [[0, 0], [9, 0], [0, 9], [9, 9], [0, 0]])"), "/mesh/source",
       "expected 4 vertices [x, y] (2 columns x 2 rows, row by row), found an array of 5"},
  };
  for (const Bad& bad : table) expect_bad(bad);
}

TEST(Codecs, SizesMayReachTheLargestAreaInEitherDirection) {
  for (const char* size : {"[65536, 16384]", "[16384, 65536]", "[65536, 1]", "[1, 65536]"})
    EXPECT_NO_THROW(parse(with_output(std::string("\"size\": ") + size), "")) << size;
  expect_bad({with_output(R"("size": [65536, 16385])"), "/output/size", "more than 1073741824 pixels"});
}

TEST(Codecs, PlacesAndSizesAreWrittenAsTheyAreRead) {
  const auto text = [](const json::Node& node) { return json::write(node, ""); };
  const Facts one{.least = 1, .most = 1}, two{.least = 2, .most = 2};
  EXPECT_EQ(text(Codec<Points>::write({{1, 2.5}}, one, false)), text(json::parse("[1, 2.5]", "")));
  EXPECT_EQ(text(Codec<Points>::write({{1, 2}, {3, 4}}, two, false)), text(json::parse("[[1, 2], [3, 4]]", "")));
  EXPECT_EQ(text(Codec<cv::Size>::write({1280, 720}, {}, false)), text(json::parse("[1280, 720]", "")));
  EXPECT_EQ(text(GridCodec::write(parse(test::kMesh, "").mesh.value(), {}, false)), text(json::parse("[3, 2]", "")));
}

TEST(Codecs, VerticesStandRowByRowUnlessTheyAreUniform) {
  const Mesh mesh = parse(test::kMesh, "").mesh.value();
  EXPECT_EQ(write_vertices(mesh, kDestination).text(), "uniform");
  EXPECT_EQ(write_vertices(mesh, kSource).size(), 6U);
  EXPECT_EQ(write_vertices(mesh, kSource).hints().per_line, 3U);
}

}  // namespace
}  // namespace morphkit::project
