#include "cli/edit/hand/toolbox.h"

#include <algorithm>
#include <cstddef>

#include "cli/edit/hand/curve_tool.h"
#include "cli/edit/hand/line_tool.h"
#include "cli/edit/hand/mesh_tool.h"
#include "cli/edit/hand/point_tool.h"
#include "cli/edit/hand/select_tool.h"

namespace morphkit::edit {
namespace {

std::unique_ptr<Tool> make_tool(ToolId tool, ToolContext& context) {
  switch (tool) {
    case ToolId::kSelect:
      return std::make_unique<SelectTool>(context);
    case ToolId::kLine:
      return std::make_unique<LineTool>(context);
    case ToolId::kPoint:
      return std::make_unique<PointTool>(context);
    case ToolId::kCurve:
      return std::make_unique<CurveTool>(context);
    case ToolId::kMesh:
      return std::make_unique<MeshTool>(context);
  }
  return nullptr;
}

}  // namespace

Toolbox::Toolbox(ToolContext& context) : context_(context) {
  for (std::size_t i = 0; i < tools_.size(); ++i) tools_[i] = make_tool(kTools[i].tool, context);
}

Tool& Toolbox::current() const {
  return *tools_[static_cast<std::size_t>(&row_of(context_.model().tool) - kTools)];
}

void Toolbox::choose(ToolId tool) {
  const ToolId before = context_.model().tool;
  if (tool != before) current().leave();
  if (row_of(tool).edits != row_of(before).edits) context_.select({});
  context_.model().tool = tool;
  const bool no_mesh = !context_.document().has_mesh();
  if (no_mesh && !row_of(tool).hint_without_mesh.empty()) context_.say(std::string(row_of(tool).hint_without_mesh));
}

bool Toolbox::perform(Command command) const {
  Tool& first = current();
  return first.perform(command) || std::ranges::any_of(tools_, [&](const std::unique_ptr<Tool>& tool) {
           return tool.get() != &first && tool->perform(command);
         });
}

}  // namespace morphkit::edit
