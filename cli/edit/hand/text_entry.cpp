#include "cli/edit/hand/text_entry.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/edit/view/keys.h"

namespace morphkit::edit {
namespace {

/// Whether a key code of X is a character beyond ASCII.
bool is_foreign(int key) {
  constexpr int kFirst = 0xa0, kFunctionKeys = 0xfd00, kUnicode = 0x1000000;
  return (key >= kFirst && key < kFunctionKeys) || key >= kUnicode;
}

/// Removes the last character, all bytes of its UTF-8.
void shorten(std::string& text) {
  const auto continues = [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; };
  while (!text.empty() && continues(text.back())) text.pop_back();
  if (!text.empty()) text.pop_back();
}

}  // namespace

void answer_question(Model& model, int key) {
  const std::vector<Question::Answer>& answers = model.question->answers;
  if (key == kKeyEnter) model.answer = answers.front().key;
  if (key == kKeyEscape) model.answer = answers.back().key;
  for (const Question::Answer& candidate : answers)
    if (key == candidate.key) model.answer = candidate.key;
}

void TextEntry::begin(Entry::What what) {
  const Document& document = context_.document();
  const std::vector<int>& selected = document.selection().features;
  if (selected.empty()) return context_.say("select something first");
  if (what == Entry::What::kName && selected.size() > 1) return context_.say("select one mark to name it");
  const project::Feature& first = document.project().features[static_cast<std::size_t>(selected.front())];
  context_.model().entry = Entry{what, what == Entry::What::kName ? first.id : first.group};
  capital_ = false;
}

void TextEntry::key(int key) {
  constexpr std::size_t kLongest = 64;
  std::string& text = context_.model().entry->text;
  if (key == kKeyShift) {
    capital_ = true;
    return;
  }
  if (key == kKeyEnter) return accept();
  if (key == kKeyEscape) {
    context_.model().entry.reset();
  } else if (key == kKeyBackspace || key == kKeyDelete) {
    shorten(text);
  } else if (key >= ' ' && key < 127 && text.size() < kLongest) {
    const bool letter = key >= 'a' && key <= 'z';
    text += static_cast<char>(letter && capital_ ? key - 'a' + 'A' : key);
  } else if (is_foreign(key)) {
    context_.say("that cannot be typed here; the project file takes any name");
  }
  capital_ = false;
}

void TextEntry::accept() {
  const Entry entry = *std::exchange(context_.model().entry, std::nullopt);
  Document& document = context_.document();
  if (document.selection().features.empty()) return;
  const bool group = entry.what == Entry::What::kGroup;
  const auto problem =
      group ? document.group_selected(entry.text) : document.rename(document.selection().features.front(), entry.text);
  if (problem) return context_.say(*problem);
  if (!group) return context_.say(fmt::format("named {}", entry.text));
  context_.say(entry.text.empty() ? "in no group" : fmt::format("in the group {}", entry.text));
}

}  // namespace morphkit::edit
