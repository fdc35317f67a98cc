#include "cli/edit/hand/actions.h"

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <variant>

#include "cli/edit/hand/mark_commands.h"
#include "cli/edit/hand/views.h"
#include "morph/project/words.h"

namespace morphkit::edit {
namespace {

Show next(Show show) {
  std::size_t at = 0;
  while (kShows[at].show != show) ++at;
  return kShows[(at + 1) % std::size(kShows)].show;
}

void escape(const ToolContext& context) {
  if (context.model().playing) {
    context.model().playing = false;
  } else if (!context.document().selection().empty()) {
    context.select({});
  }
}

void use_next_method(Document& document) {
  const auto& methods = project::Words<project::MethodName>::kTable;
  const std::size_t next = (static_cast<std::size_t>(document.method()) + 1) % methods.size();
  document.set_method(methods[next].second);
}

}  // namespace

std::optional<EditorRequest> Actions::perform(const Action& action) {
  return std::visit(
      [&](auto what) -> std::optional<EditorRequest> {
        if constexpr (std::is_same_v<decltype(what), Command>) {
          return perform_command(what);
        } else {
          perform_value(what);
          return std::nullopt;
        }
      },
      action);
}

std::optional<EditorRequest> Actions::perform_command(Command command) {
  if (command == Command::kSave) return EditorRequest::kSave;
  if (command == Command::kClose) return EditorRequest::kClose;
  if (!tools_.perform(command) && !perform_on_marks(context_, command)) perform_other(command);
  return std::nullopt;
}

void Actions::perform_other(Command command) {
  Model& model = context_.model();
  switch (command) {
    case Command::kName:
      return entry_.begin(Entry::What::kName);
    case Command::kGroup:
      return entry_.begin(Entry::What::kGroup);
    case Command::kEscape:
      return escape(context_);
    case Command::kFit:
      return model.fit_views();
    case Command::kPlay:
      return playback_.toggle();
    case Command::kNextSpeed:
      return playback_.next_speed();
    case Command::kSlower:
      return playback_.multiply_speed(0.5);
    case Command::kFaster:
      return playback_.multiply_speed(2);
    case Command::kNextShow:
      return perform_value(next(model.show));
    case Command::kInherit:
      return model.document.reset_tuning();
    case Command::kNextMethod:
      return use_next_method(model.document);
    case Command::kHelp:
      model.help = true;
      return;
    default:
      return;  // for a tool that is not chosen
  }
}

void Actions::perform_value(Toggle toggle) {
  bool& flag = context_.model().switches.*toggle.flag;
  flag = !flag;
  if (toggle.flag == &Switches::locked) follow_view(context_.model(), Pane::kSource);
}

void Actions::perform_value(Nudge by) {
  nudge(context_, by);
}

void Actions::perform_value(TimingKind which) {
  use_next_easing(context_.document(), which);
}

}  // namespace morphkit::edit
