// Whole sessions without a window: the hand, the clock and the files are played by the test.

#include "cli/edit/hand/editor.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include <gtest/gtest.h>

#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::edit {
namespace {

namespace fs = std::filesystem;

const cv::Size kPicture(160, 120);
const cv::Size kCanvas(1280, 720);

class EditorSession : public testing::Test {
 protected:
  void open(const std::string& source = "a.png") {
    project::Project project;
    if (fs::exists(file())) {
      project = project::load(file());
    } else {
      project.pictures[project::kSource].image = source;
      project.pictures[project::kDestination].image = "b.png";
      project.file = file();
    }
    open(std::move(project));
  }

  void open(project::Project project) {
    editor_.reset();
    editor_ = std::make_unique<Editor>(
        std::move(project), test::pictures(test::random_image(kPicture, 1), test::random_image(kPicture, 2)), kCanvas);
    editor_->turn(now_);
  }

  fs::path file() const { return folder_ / "pair.json"; }
  fs::path autosave() const { return folder_ / "pair.json.autosave"; }
  const project::Project& project() const { return editor_->model().document.project(); }
  std::string question() const { return editor_->model().question ? editor_->model().question->title : ""; }

  void wait(double seconds) {
    now_ += seconds;
    editor_->turn(now_);
  }

  /// Lets the background finish its work. @return whether the status line then says this.
  bool hears(const std::string& message) {
    for (int i = 0; i < 1'000'000 && !editor_->model().message.starts_with(message); ++i) wait(1e-6);
    return editor_->model().message.starts_with(message);
  }

  void press(int key) {
    editor_->key(key);
    wait(0.01);
  }

  void drag(cv::Point2d from, cv::Point2d to) {
    const Model& model = editor_->model();
    const cv::Rect rect = layout_of(model).pane(Pane::kSource);
    const auto canvas = [&](cv::Point2d at) {
      return rect.tl() + cv::Point(model.source_view.to_pane(at, rect.size()));
    };
    const auto mouse = [&](Mouse::What what, cv::Point2d at) {
      Mouse event;
      event.what = what;
      event.button = what == Mouse::What::kMove ? Mouse::Button::kNone : Mouse::Button::kLeft;
      event.position = canvas(at);
      event.alt = true;  // no snapping
      editor_->mouse(event);
      wait(0.01);
    };
    mouse(Mouse::What::kMove, from);
    mouse(Mouse::What::kPress, from);
    mouse(Mouse::What::kMove, (from + to) / 2);
    mouse(Mouse::What::kMove, to);
    mouse(Mouse::What::kRelease, to);
  }

  void edit_by_hand(const std::string& from, const std::string& to) {
    std::string text = test::read_text(file());
    text.replace(text.find(from), from.size(), to);
    const fs::file_time_type before = fs::last_write_time(file());
    test::write_text(file(), text);
    fs::last_write_time(file(), before + std::chrono::seconds(2));
  }

  test::TemporaryFolder folder_;
  double now_ = 1000;
  std::unique_ptr<Editor> editor_;
};

TEST_F(EditorSession, MarksSavesAndGoesOn) {
  open();
  EXPECT_TRUE(editor_->model().welcome);
  drag({20, 30}, {120, 40});
  drag({30, 90}, {110, 100});
  EXPECT_EQ(editor_->title().front(), '*');
  press('s');
  EXPECT_NE(editor_->title().front(), '*');
  EXPECT_EQ(project::load(file()).features.size(), 2U);
  open();
  EXPECT_FALSE(editor_->model().welcome);
  EXPECT_EQ(project().features.size(), 2U);
  press('q');
  EXPECT_TRUE(editor_->done());
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"pair.json"});
}

TEST_F(EditorSession, WhatAHandPlacesIsShortInTheFile) {
  open();
  drag({20.123, 30.456}, {120.789, 40.987});
  drag({70, 35}, {75.4, 41.7});  // the whole line
  for (const cv::Point2d& point : project().features.front().places[project::kSource])
    for (const double value : {point.x, point.y}) EXPECT_EQ(value, std::round(value * 1000) / 1000);
}

TEST_F(EditorSession, AutosavesAfterSecondsOfChangeAndRestoresAfterADeath) {
  open();
  drag({20, 30}, {120, 40});
  EXPECT_FALSE(fs::exists(autosave()));
  wait(kAutosaveAfter + 0.1);
  editor_.reset();  // waits for the writer; nobody has closed or saved
  ASSERT_TRUE(fs::exists(autosave()));

  open();
  EXPECT_EQ(question(), "Unsaved work was found");
  EXPECT_EQ(editor_->title(), "Unsaved work was found - morphkit");
  wait(10);
  EXPECT_TRUE(fs::exists(autosave())) << "as long as nobody has answered";
  press('r');
  ASSERT_EQ(project().features.size(), 1U);
  EXPECT_EQ(editor_->title().front(), '*');
  press('z');
  EXPECT_EQ(project().features.size(), 0U) << "restoring can be undone";
  press('y');
  press('s');
  EXPECT_FALSE(fs::exists(autosave()));
}

TEST_F(EditorSession, AnAutosaveThatIsNotAnsweredForIsKept) {
  constexpr int kEscape = 27;
  open();
  drag({20, 30}, {120, 40});
  wait(kAutosaveAfter + 0.1);
  open();
  press(kEscape);
  EXPECT_EQ(question(), "");
  EXPECT_FALSE(fs::exists(autosave()));
  drag({20, 30}, {120, 40});
  drag({30, 90}, {110, 100});
  wait(kAutosaveAfter + 0.1);
  editor_.reset();
  EXPECT_EQ(project::load(autosave()).features.size(), 2U);
  EXPECT_EQ(project::load(folder_ / "pair.json.autosave.1").features.size(), 1U);
}

TEST_F(EditorSession, KnowsItsPicturesByAnyName) {
  test::write_text(folder_ / "a.png", "");
  open();
  drag({20, 30}, {120, 40});
  wait(kAutosaveAfter + 0.1);
  open((folder_ / "a.png").string());
  EXPECT_EQ(question(), "Unsaved work was found");
  press('r');
  EXPECT_EQ(project().features.size(), 1U);
}

TEST_F(EditorSession, PutsAsideWhatBelongsToOtherPictures) {
  open();
  drag({20, 30}, {120, 40});
  wait(kAutosaveAfter + 0.1);
  open("c.png");
  EXPECT_EQ(question(), "");
  EXPECT_NE(editor_->model().message.find("pair.json.autosave.1"), std::string::npos);
  EXPECT_EQ(project::load(folder_ / "pair.json.autosave.1").features.size(), 1U);
}

TEST_F(EditorSession, FeaturesToBeginWithAreNotSavedYet) {
  open();
  drag({20, 30}, {120, 40});
  project::Project begun = project();
  begun.original.reset();
  open(begun);
  EXPECT_EQ(project().features.size(), 1U);
  EXPECT_EQ(editor_->title().front(), '*');
  wait(kAutosaveAfter + 0.1);
  press('z');
  EXPECT_TRUE(project().features.empty());
  EXPECT_NE(editor_->title().front(), '*');
}

TEST_F(EditorSession, WhatAProjectHasBeyondItsFileIsAChange) {
  const std::string text = R"({"morphkit": 1, "source": {"image": "a.png"}, "destination": {"image": "b.png"}})";
  test::write_text(file(), text);
  project::Project changed = project::load(file());
  changed.output.frames = 9;
  open(changed);
  EXPECT_EQ(editor_->title().front(), '*');
  EXPECT_EQ(project().output.frames, 9);
  EXPECT_EQ(test::read_text(file()), text);
  press('z');
  EXPECT_NE(editor_->title().front(), '*');
  EXPECT_EQ(project().output.frames, 48);
}

TEST_F(EditorSession, TriesAgainWhenAnAutosaveFails) {
  open();
  fs::create_directory(autosave());
  drag({20, 30}, {120, 40});
  wait(kAutosaveAfter + 0.1);
  ASSERT_TRUE(hears("autosave failed"));
  fs::remove(autosave());
  wait(kAutosaveAfter + 0.1);
  editor_.reset();
  EXPECT_EQ(project::load(autosave()).features.size(), 1U);
}

TEST_F(EditorSession, AMessageStandsUntilTheHandGoesOn) {
  open();
  drag({20, 30}, {120, 40});
  press('s');
  EXPECT_EQ(editor_->model().message, "saved pair.json");
  wait(5);
  EXPECT_EQ(editor_->model().message, "saved pair.json");
  press('3');
  EXPECT_NE(editor_->model().message, "saved pair.json");
}

TEST_F(EditorSession, ADiscardedAutosaveIsGone) {
  open();
  drag({20, 30}, {120, 40});
  wait(kAutosaveAfter + 0.1);
  open();
  press('d');
  EXPECT_FALSE(fs::exists(autosave()));
  EXPECT_TRUE(project().features.empty());
  press('q');
  EXPECT_TRUE(editor_->done());
}

TEST_F(EditorSession, AnAutosaveOfWhatHasBeenUndoneIsTakenAway) {
  open();
  drag({20, 30}, {120, 40});
  wait(kAutosaveAfter + 0.1);
  press('z');
  wait(kAutosaveAfter + 0.1);
  wait(kAutosaveAfter + 0.1);
  EXPECT_FALSE(fs::exists(autosave()));
}

TEST_F(EditorSession, RescuesWhatAnInterruptWouldLose) {
  open();
  drag({20, 30}, {120, 40});
  EXPECT_EQ(editor_->rescue(), "what was not saved is in " + autosave().string());
  EXPECT_EQ(project::load(autosave()).features.size(), 1U);
  press('s');
  EXPECT_EQ(editor_->rescue(), "nothing was unsaved");
}

TEST_F(EditorSession, RescuesToAnotherFolderIfNeedBe) {
  const test::TemporaryFolder elsewhere;
  setenv("TMPDIR", (elsewhere / "").c_str(), 1);
  open();
  drag({20, 30}, {120, 40});
  fs::create_directory(autosave());
  const std::string said = editor_->rescue();
  unsetenv("TMPDIR");
  ASSERT_EQ(elsewhere.names().size(), 1U);
  const fs::path rescued = elsewhere / elsewhere.names().front();
  EXPECT_EQ(said, "what was not saved is in " + rescued.string());
  EXPECT_EQ(project::load(rescued).features.size(), 1U);
}

TEST_F(EditorSession, AsksBeforeClosing) {
  open();
  drag({20, 30}, {120, 40});
  press('q');
  EXPECT_NE(question(), "");
  press('c');
  EXPECT_EQ(question(), "");
  EXPECT_FALSE(editor_->done());
  press('q');
  press('d');
  EXPECT_TRUE(editor_->done());
  EXPECT_TRUE(folder_.names().empty());
}

TEST_F(EditorSession, SavesAndClosesWhenAskedTo) {
  open();
  drag({20, 30}, {120, 40});
  press('q');
  press('s');
  EXPECT_TRUE(editor_->done());
  EXPECT_EQ(project::load(file()).features.size(), 1U);
}

TEST_F(EditorSession, TakesOverWhatAHandWroteWhileNothingWasChanged) {
  open();
  drag({20, 30}, {120, 40});
  press('s');
  edit_by_hand("line 1", "brow");
  wait(kFileCheckEvery + 0.1);
  EXPECT_EQ(project().features.front().id, "brow");
  EXPECT_NE(editor_->title().front(), '*');
}

TEST_F(EditorSession, DoesNotOverwriteWhatAHandWrote) {
  open();
  drag({20, 30}, {120, 40});
  press('s');
  drag({30, 90}, {110, 100});
  edit_by_hand("line 1", "brow");
  wait(kFileCheckEvery + 0.1);
  EXPECT_EQ(project().features.front().id, "line 1");
  EXPECT_NE(editor_->model().message.find("another program"), std::string::npos);
  press('s');
  EXPECT_NE(question(), "");
  press('c');
  EXPECT_EQ(project::load(file()).features.front().id, "brow");
  press('s');
  press('t');
  EXPECT_EQ(project().features.front().id, "brow");
  EXPECT_EQ(project().features.size(), 1U);
  press('z');
  EXPECT_EQ(project().features.size(), 2U) << "one's own state is one step away";
  press('s');
  EXPECT_EQ(project::load(file()).features.size(), 2U);
}

TEST_F(EditorSession, TakesOverWhatAHandWroteOnceItCanBeRead) {
  open();
  drag({20, 30}, {120, 40});
  press('s');
  edit_by_hand("line 1", "brow\"");
  wait(kFileCheckEvery + 0.1);
  EXPECT_TRUE(editor_->model().message.starts_with("not taken"));
  edit_by_hand("brow\"", "brow");
  wait(kFileCheckEvery + 0.1);
  EXPECT_EQ(project().features.front().id, "brow");
}

TEST_F(EditorSession, DoesNotOverwriteAProjectOfOtherPictures) {
  open();
  drag({20, 30}, {120, 40});
  press('s');
  edit_by_hand("a.png", "c.png");
  wait(kFileCheckEvery + 0.1);
  EXPECT_NE(editor_->model().message.find("other pictures"), std::string::npos);
  drag({30, 90}, {110, 100});
  press('s');
  EXPECT_NE(question(), "");
  press('c');
  EXPECT_EQ(project::load(file()).pictures[project::kSource].image, "c.png");
}

TEST_F(EditorSession, OverwritesWhenToldTo) {
  open();
  drag({20, 30}, {120, 40});
  press('s');
  edit_by_hand("line 1", "brow");
  drag({30, 90}, {110, 100});
  press('q');
  press('s');
  press('o');
  EXPECT_TRUE(editor_->done());
  EXPECT_EQ(project::load(file()).features.front().id, "line 1");
}

TEST_F(EditorSession, SaysWhyItCouldNotSave) {
  open();
  drag({20, 30}, {120, 40});
  fs::create_directory(file());
  press('s');
  EXPECT_EQ(editor_->model().message.substr(0, 9), "not saved");
  EXPECT_EQ(editor_->title().front(), '*');
}

TEST_F(EditorSession, ThePictureFollowsTheHand) {
  open();
  editor_->finish_preview();
  const cv::Mat3b before = editor_->draw().clone();
  EXPECT_FALSE(editor_->dirty());
  wait(0.01);
  EXPECT_FALSE(editor_->dirty()) << "nothing has happened";
  drag({20, 30}, {120, 40});
  editor_->finish_preview();
  EXPECT_TRUE(editor_->dirty());
  EXPECT_EQ(before.size(), kCanvas);
  EXPECT_GT(cv::norm(before, editor_->draw(), cv::NORM_L1), 0);
}

}  // namespace
}  // namespace morphkit::edit
