#pragma once

#include "cli/edit/hand/tool.h"

namespace morphkit::edit {

/// Selects and drags features. Draws nothing. No state.
class SelectTool : public Tool {
 public:
  using Tool::Tool;
  std::unique_ptr<Drag> press(const Press& press) override;
};

}  // namespace morphkit::edit
