// Tests cli/edit/window.cpp.
// The preview tool in a real window: what a hand marks is in the file, and can be rendered.

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "cli/edit/view/layout.h"
#include "cli/edit/view/model.h"
#include "morph/media/image_file.h"
#include "morph/media/process.h"
#include "morph/project/project.h"
#include "tests/cli/run_program.h"
#include "tests/gui/desktop.h"
#include "tests/support/pictures.h"
#include "tests/support/temporary_folder.h"

namespace morphkit {
namespace {

namespace fs = std::filesystem;

const cv::Size kPicture(320, 240);
const cv::Size kWindow(1280, 800);

/// A folder with two pictures, and a window on them.
class EditWindow : public testing::Test {
 protected:
  EditWindow() {
    media::write_image(folder_ / "a.png", test::random_image(kPicture, 1));
    media::write_image(folder_ / "b.png", test::random_image(kPicture, 2));
  }

  /// @param title  how the name of its window begins.
  void open(const std::string& title = "pair.json") {
    program_ = std::make_unique<media::Process>(std::vector<std::string>{
        MORPHKIT_PROGRAM, "edit", (folder_ / "a.png").string(), (folder_ / "b.png").string(), "-o", file().string(),
        "--window", std::to_string(kWindow.width) + "x" + std::to_string(kWindow.height)});
    desktop_.use_window("^" + title);
  }

  /// Presses a key that has to lead to a name of the window that begins with this. Two keys in a row may be one to
  /// highgui when the machine is slow.
  bool press_until(const std::string& key, const std::string& title) {
    desktop_.press(key);
    return sees(title);
  }
  bool sees(const std::string& title) {
    return test::holds_at_last([&] { return desktop_.has_window("^" + title); });
  }

  fs::path file() const { return folder_ / "pair.json"; }

  /// Where a position of a picture is in the window, as long as the views are as at the start.
  static cv::Point at(edit::Pane pane, cv::Point2d position) {
    edit::Model model({}, kPicture, kPicture, kWindow);
    model.fit_views();
    const cv::Rect rect = edit::layout_of(model).pane(pane);
    return rect.tl() + cv::Point(model.view(pane).to_pane(position, rect.size()));
  }

  static cv::Point button(const edit::Action& action) {
    edit::Model model({}, kPicture, kPicture, kWindow);
    const edit::Layout layout = edit::layout_of(model);
    const auto found = std::ranges::find(layout.widgets, action, &edit::Widget::action);
    return (found->rect.tl() + found->rect.br()) / 2;
  }

  std::size_t features_in_file() const { return fs::exists(file()) ? project::load(file()).features.size() : 0; }

  bool saved_with(std::size_t features) {
    return sees("\\*pair.json") && press_until("s", "pair.json") && features_in_file() == features;
  }

  void mark_three_lines() {
    for (const double y : {40.0, 120.0, 200.0})
      desktop_.drag(at(edit::Pane::kSource, {60, y}), at(edit::Pane::kSource, {250, y + 10}));
  }

  void screenshot(const std::string& name) const {
    desktop_.screenshot(fs::path(MORPHKIT_SCREENSHOTS) / (name + ".png"));
  }

  test::TemporaryFolder folder_;
  test::Desktop desktop_;
  std::unique_ptr<media::Process> program_;
};

TEST_F(EditWindow, MarksDragsZoomsUndoesScrubsAndSaves) {
  open();
  desktop_.press("b");  // no snapping: the lines lie where the hand puts them
  mark_three_lines();
  ASSERT_TRUE(saved_with(3));
  const project::Project marked = project::load(file());
  EXPECT_NEAR(marked.features[1].places[project::kSource][0].x, 60, 1.5);
  EXPECT_NEAR(marked.features[1].places[project::kSource][0].y, 120, 1.5);

  // An end is put right on the other picture.
  const cv::Point2d end = marked.features[1].places[project::kDestination][1];
  desktop_.drag(at(edit::Pane::kDestination, end), at(edit::Pane::kDestination, end + cv::Point2d(20, -30)));
  ASSERT_TRUE(saved_with(3));
  const auto end_now = [&] { return project::load(file()).features[1].places[project::kDestination][1]; };
  EXPECT_NEAR(end_now().x, end.x + 20, 1.5);
  EXPECT_NEAR(end_now().y, end.y - 30, 1.5);
  screenshot("edit-marked");

  desktop_.press("z");
  ASSERT_TRUE(saved_with(3));
  EXPECT_EQ(end_now(), end);

  // Zoomed four times at a point, a hand that moves by as much moves the picture by less.
  const cv::Point anchor = at(edit::Pane::kSource, {60, 40});
  desktop_.wheel(anchor, 4);
  desktop_.drag(anchor, anchor + cv::Point(40, 0));
  // The window itself must not have zoomed: its buttons are where they were.
  ASSERT_TRUE(sees("\\*pair.json"));
  desktop_.drag(button(edit::Command::kSave), button(edit::Command::kSave));
  ASSERT_TRUE(sees("pair.json"));
  const cv::Point2d start = marked.features[0].places[project::kSource][0];
  const cv::Point2d start_now = project::load(file()).features[0].places[project::kSource][0];
  EXPECT_GT(start_now.x, start.x);
  EXPECT_LT(start_now.x, start.x + (cv::Point2d(40, 0) * (kPicture.width / 400.0)).x);
  desktop_.press("Home");
  desktop_.press("space");
  screenshot("edit-zoomed");

  desktop_.press("q");
  ASSERT_TRUE(test::holds_at_last([&] { return !desktop_.has_window("pair.json"); }));
  EXPECT_TRUE(program_->finish().ok());
  const test::RunResult morph =
      test::run_morphkit({"morph", file().string(), "--time", "0.5", "-o", (folder_ / "half.png").string()});
  EXPECT_EQ(morph.exit_code, 0) << morph.err;
  EXPECT_EQ(media::read_info(folder_ / "half.png").width, kPicture.width);
}

TEST_F(EditWindow, GivesBackWhatWasNotSavedAfterBeingKilled) {
  open();
  mark_three_lines();
  const fs::path autosave = file().string() + ".autosave";
  ASSERT_TRUE(test::holds_at_last([&] {
    try {
      return fs::exists(autosave) && project::load(autosave).features.size() == 3;
    } catch (const Error&) {
      return false;
    }
  }));
  program_->kill();
  ASSERT_TRUE(test::holds_at_last([&] { return !desktop_.has_window("pair.json"); }));
  ASSERT_FALSE(fs::exists(file()));

  open("Unsaved work was found");
  screenshot("edit-restore");
  desktop_.press("r");
  EXPECT_TRUE(saved_with(3));
  EXPECT_FALSE(fs::exists(autosave));
}

TEST_F(EditWindow, AsksBeforeWorkIsLost) {
  open();
  mark_three_lines();
  ASSERT_TRUE(press_until("q", "Save pair.json"));
  desktop_.press("s");
  EXPECT_TRUE(test::holds_at_last([&] { return features_in_file() == 3; }));
  EXPECT_TRUE(program_->finish().ok());
}

}  // namespace
}  // namespace morphkit
