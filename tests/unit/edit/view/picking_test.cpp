#include "cli/edit/view/picking.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/edit/document/make_document.h"

namespace morphkit::edit {
namespace {

using test::kHere;
using test::kThere;

/// Pictures of 400x300, shown one to one.
Model model_with(project::Project project) {
  Model model(std::move(project), {400, 300}, {400, 300}, {1600, 900});
  model.source_view = model.destination_view = model.result_view = {1, {200, 150}};
  return model;
}

project::Project one_line() {
  project::Project project = test::empty_project();
  project.features = {test::marked_line("x", {{100, 100}, {300, 100}}, {{100, 200}, {300, 200}})};
  return project;
}

std::optional<Handle> hit(const Model& model, SideIndex side, cv::Point2d position) {
  const Panes panes = panes_of(model.canvas_size);
  return hit_test(model, panes, to_canvas(model, panes, pane_of(side), position));
}

TEST(Picking, CanvasAndContentAreInverse) {
  Model model = model_with(one_line());
  model.source_view = {2.5, {120, 80}};
  const Panes panes = panes_of(model.canvas_size);
  for (const Pane pane : kPanes) {
    const cv::Point2d there = to_canvas(model, panes, pane, {33, 44});
    test::expect_near(to_content(model, panes, pane, there), {33, 44}, 1e-9);
  }
  const cv::Rect rect = panes.pane(Pane::kSource);
  test::expect_near(to_content(model, panes, Pane::kSource, cv::Point2d(rect.tl() + rect.br()) / 2), {120, 80}, 0.5);
}

TEST(Picking, EndsComeBeforeBodiesWithinTheirReaches) {
  const Model model = model_with(one_line());
  EXPECT_EQ(hit(model, kHere, {100 + kHandleReach - 1, 100}), (Handle{kHere, 0, 0, -1}));
  EXPECT_EQ(hit(model, kHere, {200, 100 + kBodyReach - 1}), (Handle{kHere, 0, -1, -1}));
  EXPECT_FALSE(hit(model, kHere, {200, 100 + kBodyReach + 1}));
  EXPECT_EQ(hit(model, kThere, {300, 200}), (Handle{kThere, 0, 1, -1}));
}

TEST(Picking, ReachesAreThoseOfTheScreen) {
  Model model = model_with(one_line());
  model.source_view.zoom = 4;
  EXPECT_EQ(hit(model, kHere, {200, 100 + (kBodyReach - 1) / 4}), (Handle{kHere, 0, -1, -1}));
  EXPECT_FALSE(hit(model, kHere, {200, 100 + (kBodyReach + 1) / 4}));
}

TEST(Picking, WhatIsHiddenIsNotHit) {
  Model model = model_with(one_line());
  model.switches.features = false;
  EXPECT_FALSE(hit(model, kHere, {100, 100}));
}

TEST(Picking, TheMeshToolHitsVertices) {
  project::Project project = one_line();
  project.mesh = project::Mesh{5, 4, {{}, {}}, {}};
  Model model = model_with(project);
  model.tool = ToolId::kMesh;
  EXPECT_EQ(hit(model, kHere, {102, 101}), (Handle{kHere, -1, -1, 6}));
  EXPECT_EQ(position_of(model, {kHere, -1, -1, 6}), cv::Point2d(100, 100));
  EXPECT_EQ(position_of(model, {kThere, 0, 1, -1}), cv::Point2d(300, 200));
}

TEST(Picking, APlaceInTheMeshIsItsCellAndTheSharesInIt) {
  project::Project project = test::empty_project();
  project.mesh = project::Mesh{5, 4, {{}, {}}, {}};
  const Model model = model_with(project);
  const auto place = mesh_place_at(model, kHere, {125, 150});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->column, 1);
  EXPECT_EQ(place->row, 1);
  EXPECT_NEAR(place->across, 0.25, 1e-9);
  EXPECT_NEAR(place->down, 0.5, 1e-9);
  EXPECT_FALSE(mesh_place_at(model, kHere, {401, 20}));
}

TEST(Outline, RunsThroughThePointsOfACurve) {
  project::Curve curve;
  curve.closed = true;
  const project::Points points = {{0, 0}, {50, 0}, {50, 50}};
  const std::vector<cv::Point2d> outline = outline_of(curve, points);
  EXPECT_EQ(outline.front(), outline.back());
  for (const cv::Point2d point : points) EXPECT_NE(std::ranges::find(outline, point), outline.end()) << point;
  EXPECT_EQ(outline_of(project::Line{}, points), points);
}

}  // namespace
}  // namespace morphkit::edit
