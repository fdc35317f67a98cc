#include "cli/edit/document/marks.h"

#include <gtest/gtest.h>

#include "cli/edit/document/document.h"
#include "morph/project/limits.h"
#include "tests/unit/edit/document/make_document.h"

namespace morphkit::edit {
namespace {

using test::document_of;
using test::empty_project;
using test::expect_near;
using test::expect_reads_back;
using test::feature;
using test::kHere;
using test::kNaN;
using test::kThere;
using test::marked_line;

TEST(MovePoint, DoesNotMakeAFeatureThatIsNone) {
  Document document = document_of();
  document.add_line(kHere, {10, 20}, {60, 20});
  document.add_curve(kHere, {{10, 20}, {60, 20}, {90, 90}}, false);
  EXPECT_FALSE(document.move_point(0, kHere, 0, {60, 20}));
  EXPECT_FALSE(document.move_point(0, kHere, 2, {5, 5}));
  EXPECT_FALSE(document.move_point(0, kHere, -1, {5, 5}));
  EXPECT_FALSE(document.move_point(7, kHere, 0, {5, 5}));
  EXPECT_FALSE(document.move_point(0, kHere, 0, {kNaN, 5}));
  EXPECT_FALSE(document.move_point(1, kHere, 2, {10, 20})) << "joined on one side only";
  EXPECT_TRUE(document.move_point(0, kHere, 0, {-9e9, 5}));
  EXPECT_EQ(feature(document, 0).places[project::kSource][0], cv::Point2d(-project::kMaxCoordinate, 5));
  expect_reads_back(document);
}

TEST(MovePoint, EndsThatMeetOnBothSidesMoveTogether) {
  project::Project project = empty_project();
  project.features.push_back(marked_line("dot", {{5, 5}, {5, 5}}, {{9, 9}, {9, 9}}));
  Document document(project, {400, 300}, {400, 300});
  EXPECT_TRUE(document.move_point(0, kThere, 1, {30, 40}));
  EXPECT_EQ(feature(document, 0).places[project::kDestination], (Points{{30, 40}, {30, 40}}));
}

TEST(Move, KeepsTheShapeAtTheLimits) {
  Document document = document_of();
  document.add_line(kHere, {10, 20}, {60, 40});
  document.move_selected(kHere, {5e6, -5e6});
  const Points& points = feature(document, 0).places[project::kSource];
  expect_near(points[1] - points[0], {50, 20}, 1e-6);
  EXPECT_EQ(points[1].x, project::kMaxCoordinate);
  EXPECT_EQ(points[0].y, -project::kMaxCoordinate);
}

TEST(Swap, OnBothSidesLeavesTheWarpAndOnOneTurnsIt) {
  Document document = document_of();
  document.add_line(kHere, {100, 100}, {200, 140});
  document.move_point(0, kThere, 0, {130, 80});
  const cv::Point2d before = document.counterpart(kHere, {50, 60});
  document.swap_ends_selected();
  EXPECT_EQ(feature(document, 0).places[project::kSource][0], cv::Point2d(200, 140));
  EXPECT_EQ(feature(document, 0).places[project::kDestination][1], cv::Point2d(130, 80));
  expect_near(document.counterpart(kHere, {50, 60}), before, 1e-3);
  document.swap_ends_on(kThere);
  EXPECT_EQ(feature(document, 0).places[project::kSource][0], cv::Point2d(200, 140));
  EXPECT_EQ(feature(document, 0).places[project::kDestination][0], cv::Point2d(130, 80));
}

TEST(Swap, AClosedCurveKeepsItsFirstPoint) {
  Document document = document_of();
  document.add_curve(kHere, {{0, 0}, {50, 0}, {50, 50}}, true);
  const Points before = feature(document, 0).places[project::kSource];
  document.swap_ends_selected();
  EXPECT_EQ(feature(document, 0).places[project::kSource], before);
  document.swap_ends_on(kHere);
  EXPECT_EQ(feature(document, 0).places[project::kSource], (Points{{0, 0}, {50, 50}, {50, 0}}));
}

TEST(Names, MustBeFreeAndFitTheFile) {
  Document document = document_of();
  document.add_point(kHere, {1, 2});
  document.add_point(kHere, {3, 4});
  EXPECT_TRUE(document.rename(0, ""));
  EXPECT_TRUE(document.rename(0, "point 2"));
  EXPECT_TRUE(document.rename(0, "two\nlines"));
  EXPECT_TRUE(document.rename(0, "\xff"));
  EXPECT_TRUE(document.rename(2, "nobody"));
  EXPECT_FALSE(document.rename(0, "left eye"));
  EXPECT_EQ(feature(document, 0).id, "left eye");
  expect_reads_back(document);
}

TEST(Marks, ASoundFeatureIsOneThatTheFileTakes) {
  project::Feature feature = marked_line("x", {{0, 0}, {9, 0}}, {{0, 0}, {9, 9}});
  EXPECT_TRUE(is_valid(feature));
  feature.places[kThere] = {{3, 3}, {3, 3}};
  EXPECT_FALSE(is_valid(feature)) << "a point on one side only";
  feature.places[kHere] = {{3, 3}, {3, 3}};
  EXPECT_TRUE(is_valid(feature));
  feature.places[kHere] = {{3, 3}, {3, 3}, {3, 3}};
  EXPECT_FALSE(is_valid(feature)) << "three ends";
}

TEST(Marks, PositionsAreSettledAndKept) {
  EXPECT_EQ(rounded_off({0.1 + 0.2, 1.0 / 3}), cv::Point2d(0.3, 0.333333));
  EXPECT_EQ(clamped({2e9, -2e9}), cv::Point2d(project::kMaxCoordinate, -project::kMaxCoordinate));
  EXPECT_FALSE(finite({1, kNaN}));
}

}  // namespace
}  // namespace morphkit::edit
