// Tests cli/edit/hand/actions.cpp, cli/edit/hand/mark_commands.cpp, cli/edit/hand/playback.cpp and
// cli/edit/hand/slider_drag.cpp.
// Keys, widgets, questions and what is typed.

#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/unit/edit/hand/hand.h"

namespace morphkit::edit {
namespace {

using test::GestureSession;

TEST_F(GestureSession, ATuningSliderIsOneStepAndTheTimeSliderNone) {
  model.playing = true;
  drag(on_slider(TimeSlider{}, 0), on_slider(TimeSlider{}, 1) + cv::Point(400, 200));
  EXPECT_EQ(model.t, 1);
  EXPECT_FALSE(model.playing);
  EXPECT_FALSE(document().can_undo());

  const double before = document().tuning(Tuning::kB);
  drag(on_slider(Tuning::kB, 0.1), on_slider(Tuning::kB, 0.75));
  EXPECT_NEAR(document().tuning(Tuning::kB), tuning_from_slider(Tuning::kB, 0.75), 0.05);
  key('z');
  EXPECT_EQ(document().tuning(Tuning::kB), before);
  EXPECT_FALSE(document().can_undo());
}

TEST_F(GestureSession, WidgetsDoWhatTheySay) {
  for (const ToolRow& row : kTools) {
    click(row.tool);
    EXPECT_EQ(model.tool, row.tool) << row.label;
  }
  for (const ShowRow& row : kShows) {
    click(row.show);
    EXPECT_EQ(model.show, row.show) << row.label;
  }
  for (const SwitchRow& row : kSwitches) {
    const bool before = model.switches.*row.toggle.flag;
    click(row.toggle);
    EXPECT_NE(model.switches.*row.toggle.flag, before) << row.label;
  }
  click(Command::kPlay);
  EXPECT_TRUE(model.playing);
  for (const double speed : {2.0, 4.0, 0.25, 0.5, 1.0}) {
    click(Command::kNextSpeed);
    EXPECT_EQ(model.speed, speed);
  }
  EXPECT_EQ(click(Command::kSave), std::nullopt) << "nothing to save";
  click(Command::kNextMethod);
  EXPECT_TRUE(document().has_mesh());
  EXPECT_EQ(click(Command::kSave), EditorRequest::kSave);
  click(Command::kUndo);
  EXPECT_FALSE(document().has_mesh());
  click(Command::kRedo);
  EXPECT_TRUE(document().has_mesh());
  click(ToolId::kMesh);
  click(Command::kAddColumn);
  click(Command::kAddRow);
  EXPECT_EQ(document().project().mesh->columns, 6);
  EXPECT_EQ(document().project().mesh->rows, 6);
}

TEST_F(GestureSession, EasingsGoRoundAndKeepTheirTimes) {
  const motion::Timing slow{motion::LinearEase{}, 0.25, 0.5};
  project::Project project = document().project();
  project.pace.shape = slow;
  model.document.replace(project);
  std::set<std::size_t> seen;
  for (int i = 0; i < 5; ++i) {
    click(TimingKind::kShape);
    const motion::Timing timing = document().timing(TimingKind::kShape);
    seen.insert(timing.easing.index());
    EXPECT_EQ(timing.delay, slow.delay);
    EXPECT_EQ(timing.duration, slow.duration);
  }
  EXPECT_EQ(seen.size(), 5U);
  EXPECT_EQ(document().timing(TimingKind::kShape), slow);
  click(TimingKind::kDissolve);
  EXPECT_NE(document().timing(TimingKind::kDissolve).easing.index(), motion::Timing{}.easing.index());
}

TEST_F(GestureSession, HelpClosesByAnythingAndTheWelcomeGivesWay) {
  key('h');
  EXPECT_TRUE(model.help);
  key('a');
  EXPECT_FALSE(model.help);
  key(kKeyF1);
  drag(project::kSource, {20, 20}, {90, 90});
  EXPECT_FALSE(model.help);
  EXPECT_TRUE(features().empty());
  model.welcome = true;
  drag(project::kSource, {20, 20}, {90, 90});
  EXPECT_FALSE(model.welcome);
  EXPECT_EQ(features().size(), 1U);
  model.welcome = true;
  key('m');
  EXPECT_FALSE(model.welcome);
  EXPECT_FALSE(model.switches.features);
}

TEST_F(GestureSession, DeletesDuplicatesAndGoesRound) {
  mark_three_lines();
  key(kKeyTab);
  EXPECT_EQ(selected(), Indices{0});
  key('d');
  ASSERT_EQ(features().size(), 4U);
  EXPECT_EQ(selected(), Indices{3});
  EXPECT_NE(features()[3].places[project::kSource], features()[0].places[project::kSource]);
  key(kKeyDelete);
  EXPECT_EQ(features().size(), 3U);
  EXPECT_NE(model.message.find("deleted"), std::string::npos);
  key('x');
  EXPECT_EQ(features().size(), 3U);
  key('a');
  key('x');
  EXPECT_TRUE(features().empty());
  for (int i = 0; i < 6; ++i) {
    EXPECT_NE(model.message, "nothing to undo");
    key('z');
  }
  EXPECT_TRUE(features().empty());
  key('z');
  EXPECT_EQ(model.message, "nothing to undo");
}

TEST_F(GestureSession, WhatWasHeldMayHaveGone) {
  mark_three_lines();
  press(project::kSource, {300, 250});
  release();
  ASSERT_EQ(model.held, (Handle{project::kSource, 2, 1, -1}));
  project::Project one = document().project();
  one.features.resize(1);
  model.document.replace(one);
  key('a');
  move(project::kSource, {10, 10});
  key('l');
  EXPECT_EQ(features()[0].places[project::kSource], (std::vector<cv::Point2d>{{101, 50}, {301, 50}}));
}

TEST_F(GestureSession, TimeGoesForthAndBack) {
  project::Project project = document().project();
  project.output.frames = 51;
  project.output.fps = {25, 1};
  model.document.replace(project);  // 2 s
  model.t = 0.5;
  gestures.tick(1);
  EXPECT_EQ(model.t, 0.5) << "nothing plays";
  key(kKeySpace);
  gestures.tick(0.5);
  EXPECT_NEAR(model.t, 0.75, 1e-12);
  gestures.tick(1);
  EXPECT_NEAR(model.t, 0.75, 1e-12) << "to the end and back";
  gestures.tick(0.5);
  EXPECT_NEAR(model.t, 0.5, 1e-12);
  key('=');
  gestures.tick(1);
  EXPECT_NEAR(model.t, 0.5, 1e-12);
  key(kKeySpace);
  key(']');
  EXPECT_NEAR(model.t, 26.0 / 50, 1e-12);
  type("[[");
  EXPECT_NEAR(model.t, 24.0 / 50, 1e-12);
  key(kKeyEnd);
  EXPECT_EQ(model.t, 1);
  key(kKeyHome);
  EXPECT_EQ(model.t, 0);
  for (int i = 0; i < 9; ++i) key('-');
  EXPECT_EQ(model.speed, 0.25);
}

}  // namespace
}  // namespace morphkit::edit
