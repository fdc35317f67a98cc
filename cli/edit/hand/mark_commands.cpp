#include "cli/edit/hand/mark_commands.h"

#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/edit/hand/snap.h"
#include "cli/edit/view/picking.h"

namespace morphkit::edit {
namespace {

const cv::Point2d kCopyOffset(12, 12);  ///< px of the picture

void erase(const ToolContext& context) {
  Document& document = context.document();
  const std::vector<int> selected = document.selection().features;
  if (selected.empty()) return context.say("nothing is selected");
  const std::string first = document.project().features[static_cast<std::size_t>(selected.front())].id;
  context.model().held.reset();
  document.erase_selected();
  context.say(selected.size() == 1 ? fmt::format("{} deleted", first)
                                   : fmt::format("{} marks deleted", selected.size()));
}

void select_next(const ToolContext& context) {
  const Document& document = context.document();
  const int count = static_cast<int>(document.project().features.size());
  const std::vector<int>& selected = document.selection().features;
  if (count > 0) context.select({{selected.empty() ? 0 : (selected.back() + 1) % count}, {}});
}

}  // namespace

bool perform_on_marks(const ToolContext& context, Command command) {
  Document& document = context.document();
  std::optional<Handle>& held = context.model().held;
  switch (command) {
    case Command::kSelectAll:
      held.reset();
      document.select_all_features();
      return true;
    case Command::kSelectNext:
      select_next(context);
      return true;
    case Command::kSwapEnds:
      document.swap_ends_selected();
      held.reset();
      return true;
    case Command::kSwapEndsHere:
      document.swap_ends_on(context.active_side());
      held.reset();
      return true;
    case Command::kDuplicate:
      held.reset();
      document.duplicate_selected(kCopyOffset);
      return true;
    case Command::kErase:
      erase(context);
      return true;
    case Command::kUndo:
      held.reset();
      context.say(document.undo() ? "undone" : "nothing to undo");
      return true;
    case Command::kRedo:
      held.reset();
      context.say(document.redo() ? "redone" : "nothing to redo");
      return true;
    default:
      return false;
  }
}

void nudge(const ToolContext& context, Nudge by) {
  const SideIndex side = context.active_side();
  const double zoom = context.model().view(pane_of(side)).zoom;
  const cv::Point2d step = rounded({by.x / zoom, by.y / zoom}, zoom);
  Document& document = context.document();
  if (document.selection().empty()) return context.say("nothing is selected");
  const std::optional<Handle>& held = context.model().held;
  // The held mark may be gone: the project may have been replaced since.
  const bool alone = held && document.selection().features == std::vector{held->feature};
  if (alone && held->point >= 0 && held->side == side) {
    document.move_point(held->feature, side, held->point, position_of(context.model(), *held) + step);
  } else {
    document.move_selected(side, step);
  }
}

void use_next_easing(Document& document, TimingKind which) {
  const motion::Easing choices[] = {motion::LinearEase{}, motion::SineEase{}, motion::SinusoidalEase{},
                                    motion::ParabolicEase{}, motion::CubicBezierEase{}};
  const std::size_t now = document.timing(which).easing.index();
  document.set_easing(which, choices[(now + 1) % std::size(choices)]);
}

}  // namespace morphkit::edit
