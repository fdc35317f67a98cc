// Thousands of random events.

#include <iterator>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/edit/hand/hand.h"

namespace morphkit::edit {
namespace {

using test::empty_project;
using test::Hand;
using test::kWindow;

/// A hand that does anything, anywhere.
class Storm : public Hand {
 public:
  explicit Storm(unsigned seed) : random_(seed) {}

  void event() {
    keys.shift = chance(8);
    keys.ctrl = chance(20);
    keys.alt = chance(8);
    switch (integer(0, 9)) {
      case 0:
      case 1:
        key(any_key());
        break;
      case 2:
        wheel(any_place(), integer(-3, 3) * 0.7);
        break;
      case 3:
        gestures.tick(integer(0, 100) * 0.02);
        break;
      default:
        mouse(any_what(), any_place(), chance(6) ? static_cast<Button>(integer(0, 3)) : Button::kLeft);
    }
    surroundings();
  }

 private:
  /// What the editor does: asks, takes answers; and the features stay few, so that the storm stays quick.
  void surroundings() {
    if (chance(300) && !model.question) model.question = Question{"Well?", {}, {{'y', "Yes"}, {'n', "No"}}};
    if (model.answer) {
      model.question.reset();
      model.answer.reset();
    }
    if (document().in_step()) return;
    if (features().size() > 30 || document().mesh_vertices(project::kSource).size() > 120)
      model.document.replace(empty_project());
  }

  What any_what() {
    constexpr What kOften[] = {What::kMove, What::kPress, What::kRelease};
    return chance(20) ? What::kDoubleClick : kOften[integer(0, 2)];
  }

  int any_key() {
    constexpr int kSpecial[] = {kKeyBackspace, kKeyTab, kKeyEnter, kKeyEscape, kKeySpace,
                                kKeyHome,      kKeyEnd, kKeyF1,    kKeyShift,  kKeyDelete};
    if (chance(4)) return kSpecial[integer(0, static_cast<int>(std::size(kSpecial)) - 1)];
    if (chance(30)) return integer(-5, 70000);
    return integer(32, 126);
  }

  cv::Point any_place() {
    if (chance(10)) return {integer(-5000, 5000), integer(-5000, 5000)};
    if (chance(3) && !features().empty()) {
      const int feature = integer(0, static_cast<int>(features().size()) - 1);
      const SideIndex side = chance(2) ? project::kSource : project::kDestination;
      return at(side, position_of(model, {side, feature, 0, -1})) + cv::Point(integer(-9, 9), integer(-9, 9));
    }
    return {integer(-20, kWindow.width + 20), integer(-20, kWindow.height + 20)};
  }

  bool chance(int one_in) { return integer(1, one_in) == 1; }
  int integer(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }

  std::mt19937 random_;
};

void expect_sound(const Storm& storm) {
  const Document& document = storm.document();
  for (const int i : document.selection().features) ASSERT_LT(static_cast<std::size_t>(i), storm.features().size());
  for (const int i : document.selection().vertices)
    ASSERT_LT(static_cast<std::size_t>(i), document.mesh_vertices(project::kSource).size());
  ASSERT_GE(storm.model.t, 0);
  ASSERT_LE(storm.model.t, 1);
  const std::string text = project::to_text(document.project());
  ASSERT_TRUE(project::same_document(project::parse(text, "storm.json"), document.project())) << text;
}

TEST(GestureStorm, LeavesAProjectThatCanBeSavedAndNothingOpen) {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Storm storm(seed);
    int marked = 0;
    for (int i = 0; i < 5000; ++i) {
      SCOPED_TRACE(i);
      const std::size_t before = storm.features().size();
      ASSERT_NO_THROW(storm.event());
      marked += storm.features().size() > before ? 1 : 0;
      if (i % 20 == 0) {
        ASSERT_NO_FATAL_FAILURE(expect_sound(storm));
      }
    }
    EXPECT_GT(marked, 20) << "else too little has happened";
    storm.release();
    storm.key(kKeyEscape);
    EXPECT_FALSE(storm.document().in_step());
    ASSERT_NO_FATAL_FAILURE(expect_sound(storm));
  }
}

}  // namespace
}  // namespace morphkit::edit
