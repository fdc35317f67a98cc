// What is typed: names, and answers to questions.

#include <fmt/format.h>

#include "cli/edit/hand/gestures.h"

namespace morphkit::edit {
namespace {

/// Whether a key's code is that of a letter or a sign beyond ASCII, as X counts them.
bool is_foreign(int key) {
  constexpr int kFirst = 0xa0, kFunctionKeys = 0xfd00, kUnicode = 0x1000000;
  return (key >= kFirst && key < kFunctionKeys) || key >= kUnicode;
}

/// Takes the last character off, all bytes of its UTF-8.
void shorten(std::string& text) {
  const auto continues = [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; };
  while (!text.empty() && continues(text.back())) text.pop_back();
  if (!text.empty()) text.pop_back();
}

}  // namespace

void Gestures::answer(int key) {
  const std::vector<Question::Answer>& answers = model_.question->answers;
  if (key == kKeyEnter) model_.answer = answers.front().key;
  if (key == kKeyEscape) model_.answer = answers.back().key;
  for (const Question::Answer& candidate : answers)
    if (key == candidate.key) model_.answer = candidate.key;
}

void Gestures::type(int key) {
  constexpr std::size_t kLongest = 64;
  std::string& text = model_.entry->text;
  if (key == kKeyShift) {
    capital_ = true;
    return;
  }
  if (key == kKeyEnter) return accept_entry();
  if (key == kKeyEscape) {
    model_.entry.reset();
  } else if (key == kKeyBackspace || key == kKeyDelete) {
    shorten(text);
  } else if (key >= ' ' && key < 127 && text.size() < kLongest) {
    const bool letter = key >= 'a' && key <= 'z';
    text += static_cast<char>(letter && capital_ ? key - 'a' + 'A' : key);
  } else if (is_foreign(key)) {
    say("that cannot be typed here; the project file takes any name");
  }
  capital_ = false;
}

void Gestures::begin_entry(Entry::What what) {
  const Selection& selection = model_.document.selection();
  if (selection.features.empty()) return say("select something first");
  if (what == Entry::What::kName && selection.features.size() > 1) return say("select one mark to name it");
  const project::Feature& first =
      model_.document.project().features[static_cast<std::size_t>(selection.features.front())];
  model_.entry = Entry{what, what == Entry::What::kName ? first.id : first.group};
  capital_ = false;
}

void Gestures::accept_entry() {
  const Entry entry = *std::exchange(model_.entry, std::nullopt);
  Document& document = model_.document;
  if (document.selection().features.empty()) return;
  const bool group = entry.what == Entry::What::kGroup;
  const auto problem =
      group ? document.group_selected(entry.text) : document.rename(document.selection().features.front(), entry.text);
  if (problem) return say(*problem);
  if (!group) return say(fmt::format("named {}", entry.text));
  say(entry.text.empty() ? "in no group" : fmt::format("in the group {}", entry.text));
}

}  // namespace morphkit::edit
