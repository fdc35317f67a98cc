#include "cli/edit/view/layout.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "cli/edit/view/model.h"
#include "tests/unit/edit/document/make_document.h"

namespace morphkit::edit {
namespace {

Model model_on(cv::Size canvas) {
  return {test::empty_project(), {400, 300}, {400, 300}, canvas};
}

TEST(Layout, WidgetsLieOnTheCanvasAndNeverOverEachOther) {
  for (const cv::Size canvas : {kMinCanvas, cv::Size(1280, 720), cv::Size(1600, 900), cv::Size(3840, 2160)}) {
    SCOPED_TRACE(testing::Message() << canvas);
    const Model model = model_on(canvas);
    const Layout layout = layout_of(model);
    EXPECT_GT(layout.widgets.size(), 20U);
    for (const Widget& widget : layout.widgets) {
      EXPECT_EQ(widget.rect & cv::Rect({0, 0}, canvas), widget.rect) << widget.label;
      for (const Pane pane : kPanes) EXPECT_TRUE((widget.rect & layout.pane(pane)).empty()) << widget.label;
      for (const Widget& other : layout.widgets) {
        if (&other == &widget) continue;
        EXPECT_TRUE((widget.rect & other.rect).empty()) << widget.label << " " << other.label;
      }
      EXPECT_EQ(layout.widget_at((widget.rect.tl() + widget.rect.br()) / 2), &widget) << widget.label;
    }
  }
}

TEST(Layout, AQuestionLiesOnTopAndHasAllItsAnswers) {
  Model model = model_on({1280, 720});
  EXPECT_TRUE(layout_of(model).card.empty());
  model.question = Question{"Well?", {"Say."}, {{'y', "Yes"}, {'n', "No"}}};
  const Layout layout = layout_of(model);
  EXPECT_FALSE(layout.card.empty());
  std::set<char> answers;
  for (const Widget& widget : layout.widgets) {
    const auto* answer = std::get_if<Answer>(&widget.action);
    if (answer == nullptr) continue;
    EXPECT_EQ(widget.rect & layout.card, widget.rect);
    answers.insert(answer->key);
  }
  EXPECT_EQ(answers, (std::set<char>{'n', 'y'}));
}

TEST(Layout, ATuningComesBackFromItsSlider) {
  for (const Tuning which : {Tuning::kA, Tuning::kB, Tuning::kP}) {
    EXPECT_EQ(slider_from_tuning(which, tuning_from_slider(which, 0)), 0);
    EXPECT_NEAR(slider_from_tuning(which, tuning_from_slider(which, 1)), 1, 1e-9);
    double before = tuning_from_slider(which, 0);
    for (int i = 1; i <= 20; ++i) {
      const double value = tuning_from_slider(which, i / 20.0);
      EXPECT_GT(value, before);
      EXPECT_NEAR(tuning_from_slider(which, slider_from_tuning(which, value)), value, 1e-9);
      before = value;
    }
  }
}

TEST(Layout, TheTrackOfASliderLiesInItsGripAndInItsWidget) {
  const Model model = model_on({1600, 900});
  int sliders = 0;
  for (const Widget& widget : layout_of(model).widgets) {
    if (!widget.slider) continue;
    ++sliders;
    const cv::Rect track = slider_track(widget, 1), grip = slider_grip(widget, 1);
    EXPECT_GT(track.width, 20) << widget.label;
    EXPECT_GE(track.x, widget.rect.x) << widget.label;
    EXPECT_LE(track.br().x, widget.rect.br().x) << widget.label;
    EXPECT_LE(grip.x, track.x) << widget.label;
    EXPECT_GE(grip.br().x, track.br().x) << widget.label;
  }
  EXPECT_GE(sliders, 4);
}

}  // namespace
}  // namespace morphkit::edit
