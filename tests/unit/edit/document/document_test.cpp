#include "cli/edit/document/document.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/edit/document/make_document.h"

namespace morphkit::edit {
namespace {

using test::document_of;
using test::empty_project;
using test::expect_reads_back;
using test::feature;
using test::kHere;
using test::kNaN;
using test::kThere;

TEST(Document, ASessionOfMarkingAndUndoing) {
  Document document = document_of();
  EXPECT_FALSE(document.can_undo());
  EXPECT_FALSE(document.undo());
  EXPECT_EQ(document.add_line(kHere, {10, 20}, {60, 20}), 0);
  EXPECT_EQ(document.add_point(kThere, {200, 100}), 1);
  EXPECT_EQ(document.add_curve(kHere, {{0, 0}, {50, 50}, {100, 0}}, false), 2);
  EXPECT_EQ(feature(document, 0).id, "line 1");
  EXPECT_EQ(feature(document, 1).id, "point 1");
  EXPECT_EQ(feature(document, 2).id, "curve 1");
  EXPECT_EQ(document.selection(), (Selection{{2}, {}}));
  expect_reads_back(document);

  EXPECT_TRUE(document.move_point(0, kThere, 1, {70, 30}));
  EXPECT_EQ(feature(document, 0).places[project::kDestination][1], cv::Point2d(70, 30));
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(feature(document, 0).places[project::kDestination][1], cv::Point2d(60, 20));
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(document.project().features.size(), 2U);
  EXPECT_TRUE(document.redo());
  EXPECT_EQ(document.selection(), (Selection{{2}, {}}));
  EXPECT_EQ(document.project().features.size(), 3U);
  document.add_point(kHere, {5, 5});
  EXPECT_FALSE(document.can_redo()) << "what was undone is forgotten once something else is done";
}

TEST(Document, AStepHoldsAllThatHappensInIt) {
  Document document = document_of();
  document.begin();
  document.add_line(kHere, {10, 20}, {60, 20});
  for (int i = 0; i < 20; ++i) document.move_selected(kThere, {1, 2});
  EXPECT_FALSE(document.undo()) << "not amid a step";
  document.end();
  EXPECT_TRUE(document.undo());
  EXPECT_TRUE(document.project().features.empty());
  EXPECT_FALSE(document.can_undo());
}

TEST(Document, ADragThatReturnsIsNoStep) {
  Document document = document_of();
  document.add_point(kHere, {10, 20});
  document.undo();
  document.redo();
  document.begin();
  document.move_selected(kHere, {8, 0});
  document.move_selected(kHere, {-8, 0});
  document.end();
  EXPECT_TRUE(document.undo());
  EXPECT_FALSE(document.can_undo());
}

TEST(Document, CancelGoesBackAndLeavesWhatCanBeRedone) {
  Document document = document_of();
  document.add_point(kHere, {10, 20});
  document.add_point(kHere, {20, 20});
  document.undo();
  const std::uint64_t revision = document.revision();
  document.begin();
  document.move_selected(kHere, {8, 0});
  document.cancel();
  EXPECT_FALSE(document.in_step());
  EXPECT_NE(document.revision(), revision);
  EXPECT_EQ(feature(document, 0).places[project::kSource][0], cv::Point2d(10, 20));
  EXPECT_TRUE(document.redo());
}

TEST(Document, WhatChangesNothingIsNoStep) {
  Document document = document_of();
  document.add_line(kHere, {10, 20}, {60, 20});
  document.undo();
  document.redo();
  const std::uint64_t revision = document.revision();
  document.move_point(0, kHere, 0, {10, 20});
  document.move_selected(kHere, {0, 0});
  document.reset_tuning();
  document.group_selected("");
  document.rename(0, "line 1");
  document.set_method(project::MethodName::kLines);
  document.replace(document.project());
  document.select_none();
  document.erase_selected();
  document.duplicate_selected({1, 1});
  EXPECT_EQ(document.revision(), revision);
  EXPECT_TRUE(document.undo());
  EXPECT_FALSE(document.can_undo());
}

TEST(Document, KnowsWhetherItDiffersFromTheFile) {
  Document document = document_of();
  EXPECT_FALSE(document.changed());
  document.add_point(kHere, {10, 20});
  EXPECT_TRUE(document.changed());
  project::Project saved = document.project();
  saved.file = "pair.json";
  saved.original = std::make_shared<const std::string>("{}");
  document.mark_saved(saved);
  EXPECT_FALSE(document.changed());
  document.undo();
  EXPECT_TRUE(document.changed());
  EXPECT_EQ(document.project().file, "pair.json") << "undoing does not move the file";
  EXPECT_EQ(document.project().original, saved.original);
  document.redo();
  EXPECT_FALSE(document.changed());
}

TEST(Document, TakesAnotherProjectAsOneStep) {
  Document document = document_of();
  document.add_point(kHere, {10, 20});
  project::Project theirs = empty_project();
  theirs.output.frames = 7;
  theirs.file = "elsewhere.json";
  document.replace(theirs);
  EXPECT_TRUE(document.selection().empty());
  EXPECT_EQ(document.project().output.frames, 7);
  EXPECT_EQ(document.project().file, "");
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(document.project().features.size(), 1U);
}

TEST(NewFeatures, TakeTheSmallestFreeNumber) {
  Document document = document_of();
  for (int i = 0; i < 3; ++i) document.add_point(kHere, {10.0 * i, 20});
  document.select({{1}, {}});
  document.erase_selected();
  const int index = document.add_point(kHere, {50, 50});
  EXPECT_EQ(feature(document, index).id, "point 2");
}

TEST(NewFeatures, ThatWouldBeNoneAreNotMade) {
  Document document = document_of();
  EXPECT_EQ(document.add_line(kHere, {3, 4}, {3, 4}), -1);
  EXPECT_EQ(document.add_line(kHere, {kNaN, 4}, {3, 4}), -1);
  EXPECT_EQ(document.add_line(kHere, {2e6, 0}, {3e6, 0}), -1) << "one place once kept within the limits";
  EXPECT_EQ(document.add_point(kThere, {3, kNaN}), -1);
  EXPECT_EQ(document.add_curve(kHere, {{1, 1}}, false), -1);
  EXPECT_EQ(document.add_curve(kHere, {{1, 1}, {1, 1}}, false), -1);
  EXPECT_EQ(document.add_curve(kHere, {}, true), -1);
  EXPECT_FALSE(document.can_undo());
}

TEST(NewFeatures, FarOutsideHavePartnersAllTheSame) {
  Document document = document_of();
  EXPECT_EQ(document.add_line(kHere, {-300, -300}, {-200, -250}), 0);
  EXPECT_EQ(document.add_curve(kThere, {{900, 900}, {950, 900}, {950, 950}}, true), 1);
  EXPECT_NE(feature(document, 0).places[project::kDestination][0],
            feature(document, 0).places[project::kDestination][1]);
  expect_reads_back(document);
}

TEST(Duplicate, MovesBothSidesAndSelectsTheCopies) {
  Document document = document_of();
  document.add_line(kHere, {10, 20}, {60, 40});
  document.add_point(kHere, {5, 6});
  document.select_all_features();
  document.duplicate_selected({3, 4});
  EXPECT_EQ(document.selection(), (Selection{{2, 3}, {}}));
  EXPECT_EQ(feature(document, 2).id, "line 2");
  EXPECT_EQ(feature(document, 2).places[project::kSource][0], cv::Point2d(13, 24));
  EXPECT_EQ(feature(document, 3).places[project::kDestination][0],
            feature(document, 1).places[project::kDestination][0] + cv::Point2d(3, 4));
}

}  // namespace
}  // namespace morphkit::edit
