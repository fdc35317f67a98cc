#pragma once

#include "cli/edit/hand/tool.h"

namespace morphkit::edit {

/// Lays a mesh and edits it: drags vertices, adds and removes columns and rows. No state.
class MeshTool : public Tool {
 public:
  using Tool::Tool;
  std::unique_ptr<Drag> press(const Press& press) override;
  /// Selects vertices instead of features. Takes the commands for columns and rows also while another tool is chosen.
  bool perform(Command command) override;

 private:
  bool chosen() const { return model().tool == ToolId::kMesh; }
  void add_at_mouse(bool column);
  void add_to_widest_gap(bool column);
  void insert(bool column, int after, double share);
  void remove(bool column);
  void select_next();
};

}  // namespace morphkit::edit
