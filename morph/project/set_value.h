#pragma once
// One key of the document, changed by its address.

#include <string_view>

#include "morph/project/project.h"

namespace morphkit::project {

/// Sets one key by its address, as `--set` does: `warp.b`, `output.size`, `features/nose.point.source`,
/// `groups/hair.transition.shape`. Dots walk keys, "/" enters a list by id.
/// @param value  JSON; a value that is not JSON is taken as a string: `lanczos`.
/// @throws Error kBadInput with the place `path` and the message that a file would get: an unknown key with the nearest
///         one, a value out of range with the range. `project` is then unchanged.
/// Cost: writing and reading the document once.
void set_value(Project& project, std::string_view path, std::string_view value);

}  // namespace morphkit::project
