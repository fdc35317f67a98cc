#pragma once
// Typing: names of marks and groups in the status line, and answers to questions.

#include "cli/edit/hand/tool_context.h"

namespace morphkit::edit {

/// The typed line is Model::entry. Owns whether Shift came before the next letter.
class TextEntry {
 public:
  explicit TextEntry(ToolContext& context) : context_(context) {}

  /// Begins with the name or group of the selected feature. Explains if that is not possible.
  void begin(Entry::What what);
  /// @pre Model::entry is there.
  void key(int key);
  /// Gives the selected features the name or the group. @pre Model::entry is there.
  void accept();

 private:
  ToolContext& context_;
  bool capital_ = false;
};

/// Answers the question of the model by a key: one of its own, Enter for the first answer, Esc for the last one.
void answer_question(Model& model, int key);

}  // namespace morphkit::edit
