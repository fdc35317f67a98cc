#pragma once
// Keys of the document, changed by their addresses.

#include <span>
#include <string>
#include <string_view>

#include "morph/project/project.h"

namespace morphkit::project {

/// A key and its new value.
struct Setting {
  /// The address: `warp.b`, `output.size`, `features/nose.point.source`, `groups/hair.transition.shape`. Dots walk
  /// keys, "/" enters a list by id.
  std::string path;
  std::string value;  ///< JSON; anything else is taken as a string: `lanczos`
};

/// Sets keys, in order. Only the result must be consistent: a setting may depend on a later one.
/// @throws Error kBadInput with the place `path` and the message that a file would get: an unknown key with the nearest
///         one, a value out of range with the range. `project` is then unchanged.
/// Cost: writing and reading the document once; once per setting if one continues another (or is wrong).
void set_values(Project& project, std::span<const Setting> settings);

/// Sets one key.
void set_value(Project& project, std::string_view path, std::string_view value);

}  // namespace morphkit::project
