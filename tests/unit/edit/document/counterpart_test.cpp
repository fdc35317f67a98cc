#include "cli/edit/document/counterpart.h"

#include <vector>

#include <gtest/gtest.h>

#include "cli/edit/document/document.h"
#include "tests/unit/edit/document/make_document.h"

namespace morphkit::edit {
namespace {

using Points = std::vector<cv::Point2d>;
using test::document_of;
using test::expect_near;
using test::feature;
using test::kHere;
using test::kThere;

TEST(Counterpart, WithoutFeaturesIsWhereTheCanvasHasIt) {
  const Document same = document_of();
  EXPECT_EQ(same.counterpart(kHere, {123, 45}), cv::Point2d(123, 45));
  // kCover: the destination fills the canvas of 400x300 at a scale of 1.5, centred.
  const Document cover = document_of({400, 300}, {400, 200});
  expect_near(cover.counterpart(kHere, {200, 150}), {200, 100}, 1e-9);
  expect_near(cover.counterpart(kHere, {260, 150}), {240, 100}, 1e-9);
  expect_near(cover.counterpart(kThere, {240, 100}), {260, 150}, 1e-9);
}

TEST(Counterpart, FollowsASingleLineAsASimilarity) {
  Document document = document_of();
  document.add_line(kHere, {100, 100}, {200, 100});
  document.move_point(0, kThere, 0, {250, 50});
  document.move_point(0, kThere, 1, {250, 150});
  // A quarter turn: right becomes down, and 20 below the line becomes 20 to the left of it.
  expect_near(document.counterpart(kHere, {150, 120}), {230, 100}, 1e-3);
  expect_near(document.counterpart(kThere, {230, 100}), {150, 120}, 1e-3);
  expect_near(document.counterpart(kHere, {0, 250}), {100, 0}, 1e-3);
}

TEST(Counterpart, FollowsEveryLineThatHoldsFast) {
  Document document = document_of({400, 300}, {800, 900});
  document.tune(Tuning::kA, 0);
  document.add_line(kHere, {100, 100}, {200, 100});
  document.move_point(0, kThere, 0, {150, 310});
  document.add_line(kHere, {100, 200}, {250, 180});
  document.move_point(1, kThere, 1, {600, 500});
  for (const int i : {0, 1}) {
    const project::Feature& line = feature(document, i);
    for (const double s : {0.25, 0.5, 0.75}) {
      const cv::Point2d here = line.places[project::kSource][0] * (1 - s) + line.places[project::kSource][1] * s;
      const cv::Point2d there =
          line.places[project::kDestination][0] * (1 - s) + line.places[project::kDestination][1] * s;
      expect_near(document.counterpart(kHere, here), there, 0.02);
      expect_near(document.counterpart(kThere, there), here, 0.02);
    }
  }
}

TEST(Counterpart, StaysInThePicture) {
  Document document = document_of({400, 300}, {200, 300});
  EXPECT_EQ(document.counterpart(kHere, {-50, 9000}), cv::Point2d(0, 300));
  document.add_line(kHere, {100, 100}, {200, 100});
  document.move_selected(kThere, {500, 0});
  EXPECT_EQ(document.counterpart(kHere, {390, 100}).x, 200);
}

TEST(Counterpart, ByTheMeshThereAndBack) {
  Document document = document_of({400, 300}, {800, 200});
  document.make_mesh(4, 4);
  document.move_vertices(std::vector{5}, kHere, {20, -15});
  document.move_vertices(std::vector{10}, kThere, {-40, 10});
  const Points here = document.mesh_vertices(kHere), there = document.mesh_vertices(kThere);
  for (std::size_t i = 0; i < here.size(); ++i) expect_near(document.counterpart(kHere, here[i]), there[i], 1e-9);
  for (const cv::Point2d at : Points{{11, 12}, {150, 140}, {399, 1}, {222.5, 288}}) {
    expect_near(document.counterpart(kThere, document.counterpart(kHere, at)), at, 1e-9);
  }
}

}  // namespace
}  // namespace morphkit::edit
