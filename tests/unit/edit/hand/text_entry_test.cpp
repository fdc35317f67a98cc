#include "cli/edit/hand/text_entry.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/unit/edit/hand/hand.h"

namespace morphkit::edit {
namespace {

using test::GestureSession;

TEST_F(GestureSession, AQuestionTakesItsAnswersAndNothingElse) {
  const auto ask = [&] {
    model.question = Question{"Well?", {"Say."}, {{'y', "Yes"}, {'n', "No"}}};
    model.answer.reset();
  };
  mark_three_lines();
  const View view = model.source_view;
  ask();
  for (const int code : {int{'a'}, int{'x'}, int{'z'}, int{'q'}, int{'s'}, int{kKeySpace}, int{kKeyShift}, int{'h'}})
    EXPECT_EQ(key(code), std::nullopt);
  drag(project::kSource, {20, 20}, {90, 90});
  wheel(at(project::kSource, {50, 50}), 2);
  EXPECT_EQ(features().size(), 3U);
  EXPECT_EQ(model.source_view, view);
  EXPECT_FALSE(model.help);
  EXPECT_FALSE(model.answer);
  const std::pair<int, char> answers[] = {{'y', 'y'}, {'n', 'n'}, {kKeyEnter, 'y'}, {kKeyEscape, 'n'}};
  for (const auto& [code, answer] : answers) {
    ask();
    key(code);
    EXPECT_EQ(model.answer, answer);
  }
  ask();
  click(Answer{'y'});
  EXPECT_EQ(model.answer, 'y');
}

TEST_F(GestureSession, NamesAreTyped) {
  drag(project::kSource, {100, 50}, {300, 50});
  key('n');
  ASSERT_TRUE(model.entry);
  EXPECT_EQ(model.entry->text, "line 1");
  for (int i = 0; i < 8; ++i) key(kKeyBackspace);
  key(kKeyShift);
  type("eyez");
  key(kKeyBackspace);
  type(" 2");
  key(kKeyShift);
  type("-q");
  EXPECT_EQ(model.entry->text, "Eye 2-q") << "Shift is for the next character alone";
  key(kKeyEnter);
  EXPECT_FALSE(model.entry);
  EXPECT_EQ(features()[0].id, "Eye 2-q");
  key('n');
  type("zzz");
  key(kKeyEscape);
  EXPECT_FALSE(model.entry);
  EXPECT_EQ(features()[0].id, "Eye 2-q");
  EXPECT_EQ(selected(), Indices{0}) << "Esc leaves one thing at a time";
  EXPECT_EQ(steps_back(), 2);
}

TEST_F(GestureSession, NamesAreShortenedByWholeCharacters) {
  drag(project::kSource, {100, 50}, {300, 50});
  ASSERT_FALSE(model.document.rename(0, "nez \u00e9\U0001f441"));
  key('n');
  key(kKeyBackspace);
  EXPECT_EQ(model.entry->text, "nez \u00e9");
  key(kKeyBackspace);
  EXPECT_EQ(model.entry->text, "nez ");
  constexpr int kUmlaut = 0xe4, kArrow = 0xff51;
  model.message.clear();
  key(kArrow);
  EXPECT_EQ(model.message, "");
  key(kUmlaut);
  EXPECT_NE(model.message.find("cannot be typed"), std::string::npos);
  EXPECT_EQ(model.entry->text, "nez ");
}

TEST_F(GestureSession, NamesThatAreTakenAreRefused) {
  mark_three_lines();
  key('n');
  key(kKeyBackspace);
  type("1");
  key(kKeyEnter);
  EXPECT_EQ(features()[2].id, "line 3");
  EXPECT_NE(model.message, "");
}

TEST_F(GestureSession, WhatIsTypedIsForWhatWasSelected) {
  mark_three_lines();
  key('n');
  type("x");
  click(Command::kUndo);
  EXPECT_FALSE(model.entry);
  ASSERT_EQ(features().size(), 3U);
  EXPECT_EQ(features()[2].id, "line 3") << "named, and undone";
  key('n');
  type("y");
  click(project::kSource, {200, 50});
  EXPECT_FALSE(model.entry);
  EXPECT_EQ(features()[2].id, "line 3y");
  EXPECT_EQ(features()[0].id, "line 1");
}

}  // namespace
}  // namespace morphkit::edit
