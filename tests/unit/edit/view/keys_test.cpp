#include "cli/edit/view/keys.h"

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/unit/edit/hand/hand.h"

namespace morphkit::edit {
namespace {

using test::Hand;

/// Everything that a key could change, in words.
std::string told(const Model& model, std::optional<EditorRequest> request) {
  const auto numbers = [](const auto&... values) { return ((std::to_string(values) + ' ') + ...); };
  const Switches& on = model.switches;
  std::string text =
      project::to_text(model.document.project()) + model.message +
      numbers(model.t, model.speed, model.playing, static_cast<int>(model.tool), static_cast<int>(model.show),
              model.help, on.locked, on.snap, on.onion, on.folds, on.loupe, on.features, model.source_view.zoom,
              model.entry.has_value(), model.sketch.has_value(), request ? static_cast<int>(*request) : -1);
  for (const int i : model.document.selection().features) text += numbers(i);
  for (const int i : model.document.selection().vertices) text += numbers(i);
  return text;
}

/// Key codes of a line of the help, and nothing for those of the mouse.
std::set<int> codes_of(std::string_view keys) {
  const std::pair<std::string_view, int> named[] = {
      {"Enter", kKeyEnter}, {"Tab", kKeyTab}, {"Esc", kKeyEscape},    {"Space", kKeySpace},        {"Home", kKeyHome},
      {"End", kKeyEnd},     {"F1", kKeyF1},   {"Delete", kKeyDelete}, {"Backspace", kKeyBackspace}};
  std::set<int> codes;
  for (std::size_t begin = 0; begin < keys.size();) {
    const std::size_t end = std::min(keys.find(' ', begin), keys.size());
    std::string_view word = keys.substr(begin, end - begin);
    begin = end + 1;
    if (word.size() > 1 && word.back() == ',') word.remove_suffix(1);
    if (word.size() == 1 && word != "+") codes.insert(word.front());
    for (const auto& [name, code] : named)
      if (word == name) codes.insert(code);
  }
  return codes;
}

/// Whether a key does something in one of the situations in which a hand may press it.
bool does_something(int code) {
  const std::function<void(Hand&)> situations[] = {[](Hand& hand) {
                                                     for (const double y : {50.0, 150.0, 250.0})
                                                       hand.drag(project::kSource, {100, y}, {300, y});
                                                     hand.key('z');
                                                     hand.model.t = 0.3;
                                                     hand.move(project::kSource, {37, 37});
                                                   },
                                                   [](Hand& hand) {
                                                     hand.key('5');
                                                     hand.click(project::kSource, {30, 30});
                                                     hand.click(project::kSource, {200, 150});
                                                     hand.move(project::kSource, {37, 37});
                                                   },
                                                   [](Hand& hand) {
                                                     hand.key('4');
                                                     for (const double x : {50.0, 150.0, 200.0})
                                                       hand.click(project::kSource, {x, 150});
                                                   }};
  return std::ranges::any_of(situations, [&](const auto& arrange) {
    Hand hand;
    arrange(hand);
    hand.model.message.clear();
    hand.wheel(hand.at(project::kSource, {200, 150}), 1);
    const std::string before = told(hand.model, {});
    return told(hand.model, hand.key(code)) != before;
  });
}

TEST(Keys, NameEveryKeyThatDoesSomethingAndNoOther) {
  std::set<int> named;
  for (const KeyRow& line : key_rows()) named.merge(codes_of(line.keys));
  EXPECT_GT(named.size(), 40U);
  std::set<int> candidates = named;
  for (int code = 0; code < 256; ++code) candidates.insert(code);
  for (int code = 65280; code < 65536; ++code) candidates.insert(code);
  for (const int code : candidates) EXPECT_EQ(does_something(code), named.contains(code)) << "key " << code;
}

TEST(Keys, AreAllInTheDocs) {
  const std::string page = test::read_text(MORPHKIT_EDIT_PAGE);
  ASSERT_FALSE(page.empty());
  for (const KeyRow& line : key_rows()) {
    const std::string row = std::string("| `").append(line.keys).append("` | ").append(line.text).append(" |");
    EXPECT_NE(page.find(row), std::string::npos) << row;
  }
}

TEST(Keys, FitTheOverlay) {
  const auto lines = key_rows();
  EXPECT_LE(lines.size(), 52U);
  std::set<std::string_view> sections;
  std::string_view before;
  for (const KeyRow& line : lines) {
    EXPECT_FALSE(line.keys.empty() || line.text.empty());
    if (line.section != before) {
      EXPECT_TRUE(sections.insert(line.section).second) << line.section << " is in two places";
    }
    before = line.section;
  }
}

}  // namespace
}  // namespace morphkit::edit
