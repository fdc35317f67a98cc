#pragma once
// The tools, and which of them is chosen.

#include <array>
#include <iterator>
#include <memory>

#include "cli/edit/hand/tool.h"

namespace morphkit::edit {

/// Owns one object per row of kTools. The choice itself is Model::tool.
class Toolbox {
 public:
  explicit Toolbox(ToolContext& context);

  Tool& current() const;
  /// The tool before it finishes what it draws. Vertices and features are never selected together.
  void choose(ToolId tool);
  /// Offers a command to the chosen tool, then to the others. @return whether one has handled it.
  bool perform(Command command) const;

 private:
  ToolContext& context_;
  std::array<std::unique_ptr<Tool>, std::size(kTools)> tools_;  ///< in the order of kTools
};

}  // namespace morphkit::edit
