#include "cli/edit/document/document.h"

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/edit/document/history.h"
#include "morph/project/limits.h"

namespace morphkit::edit {
namespace {

constexpr SideIndex kHere = project::kSource, kThere = project::kDestination;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

using Points = std::vector<cv::Point2d>;

project::Project empty_project() {
  project::Project project;
  project.pictures[project::kSource].image = "a.png";
  project.pictures[project::kDestination].image = "b.png";
  return project;
}

Document document_of(cv::Size source = {400, 300}, cv::Size destination = {400, 300}) {
  return Document(empty_project(), source, destination);
}

void expect_near(cv::Point2d a, cv::Point2d b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

void expect_reads_back(const Document& document) {
  const std::string text = project::to_text(document.project());
  EXPECT_TRUE(project::same_document(project::parse(text, "x.json"), document.project())) << text;
}

project::Feature line(const std::string& id, Points source, Points destination) {
  project::Feature feature;
  feature.id = id;
  feature.places[project::kSource] = std::move(source);
  feature.places[project::kDestination] = std::move(destination);
  return feature;
}

const project::Feature& feature(const Document& document, int index) {
  return document.project().features.at(static_cast<std::size_t>(index));
}

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
  document.untune();
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

// New features

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

// Counterparts

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

// Changing features

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
  project.features.push_back(line("dot", {{5, 5}, {5, 5}}, {{9, 9}, {9, 9}}));
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

TEST(Swap, OnBothSidesLeavesTheWarpAndOnOneTurnsIt) {
  Document document = document_of();
  document.add_line(kHere, {100, 100}, {200, 140});
  document.move_point(0, kThere, 0, {130, 80});
  const cv::Point2d before = document.counterpart(kHere, {50, 60});
  document.swap_ends_selected();
  EXPECT_EQ(feature(document, 0).places[project::kSource][0], cv::Point2d(200, 140));
  EXPECT_EQ(feature(document, 0).places[project::kDestination][1], cv::Point2d(130, 80));
  expect_near(document.counterpart(kHere, {50, 60}), before, 1e-3);
  document.swap_end_on(kThere);
  EXPECT_EQ(feature(document, 0).places[project::kSource][0], cv::Point2d(200, 140));
  EXPECT_EQ(feature(document, 0).places[project::kDestination][0], cv::Point2d(130, 80));
}

TEST(Swap, AClosedCurveKeepsItsFirstPoint) {
  Document document = document_of();
  document.add_curve(kHere, {{0, 0}, {50, 0}, {50, 50}}, true);
  const Points before = feature(document, 0).places[project::kSource];
  document.swap_ends_selected();
  EXPECT_EQ(feature(document, 0).places[project::kSource], before);
  document.swap_end_on(kHere);
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

TEST(Groups, ComeAndGoWithWhatBelongsToThem) {
  project::Project project = empty_project();
  project.groups = {{"tuned", {}, {}}, {"idle", {}, {}}};
  project.groups[0].pull.a = 3;
  Document document(project, {400, 300}, {400, 300});
  document.add_point(kHere, {1, 2});
  document.group_selected("tuned");
  EXPECT_EQ(document.tuning(Tuning::kA), 3);
  EXPECT_FALSE(document.tuning_is_own(Tuning::kA));
  document.group_selected("eye");
  EXPECT_EQ(document.project().groups.size(), 3U) << "tuned says something, idle was never left";
  EXPECT_TRUE(document.group_selected(std::string(1, '\t'))) << "no name";
  EXPECT_EQ(feature(document, 0).group, "eye");
  document.group_selected("");
  ASSERT_EQ(document.project().groups.size(), 2U);
  EXPECT_EQ(document.project().groups[1].id, "idle");
  document.group_selected("eye");
  document.erase_selected();
  EXPECT_EQ(document.project().groups.size(), 2U);
}

// Tuning

TEST(Tuning, OfTheSelectionOrOfTheProject) {
  Document document = document_of();
  document.tune(Tuning::kB, 3);
  document.add_point(kHere, {1, 2});
  EXPECT_EQ(document.tuning(Tuning::kB), 3);
  EXPECT_FALSE(document.tuning_is_own(Tuning::kB));
  document.tune(Tuning::kB, 99);
  EXPECT_EQ(document.tuning(Tuning::kB), project::kMaxFalloff);
  EXPECT_TRUE(document.tuning_is_own(Tuning::kB));
  document.tune(Tuning::kP, kNaN);
  EXPECT_FALSE(document.tuning_is_own(Tuning::kP));
  document.untune();
  EXPECT_EQ(document.tuning(Tuning::kB), 3);
  document.select_none();
  EXPECT_TRUE(document.tuning_is_own(Tuning::kB));
}

TEST(Tuning, InheritingLeavesTheRestOfAFeatureAlone) {
  project::Project project = empty_project();
  Document first(project, {400, 300}, {400, 300});
  first.add_line(kHere, {10, 20}, {60, 40});
  project = first.project();
  project.features[0].pull.between = project::Between::kCentre;
  project.features[0].pull.turns = 1;
  project.features[0].pace.shape = motion::Timing{motion::SineEase{}, 0.25, 0.5};
  project.features[0].pull.p = 1;
  Document document(project, {400, 300}, {400, 300});
  document.select({{0}, {}});
  document.untune();
  project::Pull left;
  left.between = project::Between::kCentre;
  left.turns = 1;
  EXPECT_EQ(feature(document, 0).pull, left);
  EXPECT_EQ(feature(document, 0).pace, project::Pace{});
}

TEST(Easings, LeaveDelaysAndDurationsOfEveryFeature) {
  project::Project project = empty_project();
  project.pace.shape = motion::Timing{motion::LinearEase{}, 0.25, 0.5};
  Document document(project, {400, 300}, {400, 300});
  document.set_easing(TimingKind::kShape, motion::SineEase{});
  EXPECT_EQ(document.timing(TimingKind::kShape), (motion::Timing{motion::SineEase{}, 0.25, 0.5}));
  EXPECT_EQ(document.timing(TimingKind::kDissolve), motion::Timing{});
  document.add_line(kHere, {10, 20}, {60, 40});
  document.add_point(kHere, {5, 6});
  project = document.project();
  project.features[1].pace.shape = motion::Timing{motion::LinearEase{}, 0.5, 0.25};
  document.replace(project);
  document.select({{0, 1}, {}});
  document.set_easing(TimingKind::kShape, motion::ParabolicEase{});
  EXPECT_EQ(feature(document, 0).pace.shape, (motion::Timing{motion::ParabolicEase{}, 0.25, 0.5}));
  EXPECT_EQ(feature(document, 1).pace.shape, (motion::Timing{motion::ParabolicEase{}, 0.5, 0.25}));
}

TEST(Easings, ThatTheFileWouldRefuseAreNotSet) {
  Document document = document_of();
  document.set_easing(TimingKind::kShape, motion::SineEase{});
  const std::vector<motion::Easing> refused = {motion::StepEase{2}, motion::CubicBezierEase{0, 1e9, 1, 0},
                                               motion::SinusoidalEase{kNaN, 1}, motion::KeysEase{}};
  for (const motion::Easing& easing : refused) document.set_easing(TimingKind::kShape, easing);
  EXPECT_EQ(document.timing(TimingKind::kShape), (motion::Timing{motion::SineEase{}, 0, 1}));
  expect_reads_back(document);
}

// Mesh

TEST(Mesh, IsMadeByTheMethodThatNeedsOne) {
  Document document = document_of();
  document.add_point(kHere, {1, 2});
  document.set_method(project::MethodName::kMesh);
  ASSERT_TRUE(document.has_mesh());
  EXPECT_EQ(document.mesh_vertices(kHere).size(), 25U);
  EXPECT_EQ(document.method(), project::MethodName::kMesh);
  expect_reads_back(document);
  EXPECT_TRUE(document.undo());
  EXPECT_FALSE(document.has_mesh());
}

TEST(Mesh, CannotMirror) {
  project::Project project = empty_project();
  project.warp.border = warp::Border::kMirror;
  Document document(project, {400, 300}, {400, 300});
  document.add_point(kHere, {1, 2});
  document.make_mesh(3, 3);
  EXPECT_EQ(document.project().warp.border, warp::Border::kMirror) << "the features still warp";
  document.erase_selected();
  EXPECT_EQ(document.method(), project::MethodName::kMesh);
  expect_reads_back(document);
}

TEST(Mesh, BorderVerticesSlideAndCornersStay) {
  Document document = document_of({400, 300}, {800, 600});
  document.make_mesh(3, 3);
  document.undo();
  document.redo();
  document.move_vertices(std::vector{0, 2, 6, 8}, kHere, {9, 9});
  EXPECT_TRUE(document.project().mesh->vertices[project::kSource].empty()) << "corners only: nothing has happened";
  document.move_vertices(std::vector{0, 1, 3, 4, -1, 99}, kHere, {30, 40});
  const Points vertices = document.mesh_vertices(kHere);
  EXPECT_EQ(vertices[0], cv::Point2d(0, 0));
  EXPECT_EQ(vertices[1], cv::Point2d(230, 0));
  EXPECT_EQ(vertices[3], cv::Point2d(0, 190));
  EXPECT_EQ(vertices[4], cv::Point2d(230, 190));
  document.move_vertices(std::vector{4}, kHere, {1e7, -1e7});
  EXPECT_EQ(document.mesh_vertices(kHere)[4], cv::Point2d(400, 0));
  EXPECT_TRUE(document.project().mesh->vertices[project::kDestination].empty());
  EXPECT_EQ(document.mesh_vertices(kThere)[4], cv::Point2d(400, 300));
  expect_reads_back(document);
}

project::Project grouped_mesh() {
  project::Project project = empty_project();
  project.groups = {{"a", {}, {}}, {"b", {}, {}}};
  project.mesh = project::Mesh{
      .columns = 3, .rows = 3, .vertices = {{}, {}}, .groups = {{"a", {{0, 1}, {1, 1}, {2, 2}}}, {"b", {{2, 1}}}}};
  return project;
}

TEST(Mesh, ColumnsComeAndGoWithTheirGroupsAndSelection) {
  Document document(grouped_mesh(), {400, 300}, {800, 600});
  document.select({{}, {1, 4, 8}});
  document.insert_column(0, 0.25);
  EXPECT_EQ(document.project().mesh->columns, 4);
  EXPECT_EQ(document.mesh_vertices(kHere)[1], cv::Point2d(50, 0));
  EXPECT_EQ(document.mesh_vertices(kThere)[5], cv::Point2d(100, 300));
  EXPECT_EQ(document.project().mesh->groups[0].vertices, (std::vector<cv::Point>{{0, 1}, {2, 1}, {3, 2}, {1, 1}}));
  EXPECT_EQ(document.selection().vertices, (std::vector{2, 6, 11}));
  expect_reads_back(document);
  EXPECT_FALSE(document.remove_column(0));
  EXPECT_FALSE(document.remove_column(3));
  EXPECT_TRUE(document.remove_column(2));
  EXPECT_EQ(document.project().mesh->groups[0].vertices, (std::vector<cv::Point>{{0, 1}, {2, 2}, {1, 1}}));
  EXPECT_EQ(document.selection().vertices, (std::vector{8}));
  EXPECT_EQ(document.mesh_vertices(kHere)[2], cv::Point2d(400, 0));
  expect_reads_back(document);
}

TEST(Mesh, RowsLikewiseAndAnEmptiedGroupGoes) {
  Document document(grouped_mesh(), {400, 300}, {800, 600});
  document.select({{}, {1, 4, 8}});
  document.insert_row(1, 0.5);
  EXPECT_EQ(document.project().mesh->rows, 4);
  EXPECT_EQ(document.mesh_vertices(kHere)[7], cv::Point2d(200, 225));
  EXPECT_EQ(document.project().mesh->groups[0].vertices, (std::vector<cv::Point>{{0, 1}, {1, 1}, {2, 3}}));
  EXPECT_EQ(document.selection().vertices, (std::vector{1, 4, 11}));
  EXPECT_TRUE(document.remove_row(1));
  ASSERT_EQ(document.project().mesh->groups.size(), 1U);
  ASSERT_EQ(document.project().groups.size(), 1U);
  EXPECT_EQ(document.project().groups[0].id, "a");
  EXPECT_EQ(document.selection().vertices, (std::vector{1, 8}));
  expect_reads_back(document);
}

TEST(Mesh, InsertingAndRemovingReturnsTheVertices) {
  Document document = document_of({400, 300}, {800, 600});
  document.make_mesh(5, 4);
  document.move_vertices(std::vector{6}, kHere, {7, 3});
  const Points before = document.mesh_vertices(kHere);
  document.insert_row(2, 0.3);
  document.insert_column(3, 0.7);
  EXPECT_TRUE(document.remove_column(4));
  EXPECT_TRUE(document.remove_row(3));
  EXPECT_EQ(document.mesh_vertices(kHere), before);
}

TEST(Mesh, StaysWithinTheLimits) {
  Document document = document_of();
  document.make_mesh(1, -4);
  EXPECT_EQ(document.mesh_vertices(kHere).size(), 4U);
  EXPECT_FALSE(document.remove_column(0));
  EXPECT_FALSE(document.remove_row(1));
  document.insert_column(1, 0.5);
  document.insert_column(-1, 0.5);
  document.insert_column(0, kNaN);
  EXPECT_EQ(document.project().mesh->columns, 2);
  document.make_mesh(5000, 2);
  EXPECT_EQ(document.project().mesh->columns, project::kMaxMeshSize);
  document.insert_column(3, 0.5);
  EXPECT_EQ(document.project().mesh->columns, project::kMaxMeshSize);
}

// History

TEST(History, AStepCostsWhatItChanged) {
  State state{empty_project(), {}};
  constexpr int kFeatures = 50, kSteps = 2000;
  for (int i = 0; i < kFeatures; ++i)
    state.project.features.push_back(line(std::to_string(i), {{0, 0}, {1.0 * i, 9}}, {{0, 0}, {9, 9}}));
  History history;
  history.push(state);
  const std::size_t first = history.size().parts;
  EXPECT_EQ(first, kFeatures + 3U) << "the rest, the list of features, the groups";
  for (int i = 0; i < kSteps; ++i) {
    state.project.features[static_cast<std::size_t>(i % kFeatures)].places[project::kSource][0].x += 1;
    history.push(state);
  }
  const HistorySize size = history.size();
  EXPECT_EQ(size.states, kSteps + 1U);
  EXPECT_EQ(size.parts, first + 2 * kSteps) << "each step: one feature, and the list";
}

TEST(History, SharesAlsoWhereFeaturesHaveMovedUp) {
  State state{empty_project(), {}};
  for (int i = 0; i < 10; ++i)
    state.project.features.push_back(line(std::to_string(i), {{0, 0}, {1, 9}}, {{0, 0}, {9, 9}}));
  History history;
  history.push(state);
  const std::size_t first = history.size().parts;
  state.project.features.erase(state.project.features.begin() + 2);
  history.push(state);
  EXPECT_EQ(history.size().parts, first + 1) << "a list of features";
  state.project.output.frames = 3;
  for (int i = 0; i < 3; ++i) {
    SCOPED_TRACE(i);
    state = history.undo(history.undo(state));
    EXPECT_EQ(state.project.features.size(), 10U);
    state = history.redo(history.redo(state));
    EXPECT_EQ(state.project.output.frames, 3);
    EXPECT_LE(history.size().parts, first + 2) << "the rest, once; going back and forth makes nothing new";
  }
}

}  // namespace
}  // namespace morphkit::edit
