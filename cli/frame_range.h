#pragma once
// "1-240x2", "1,5,9-12", "10-": which frames.

#include <string>
#include <vector>

namespace morphkit::cli {

/// Frame numbers of a range, rising, each once: a list, separated by commas, of "n", "first-last", "first-" (to the
/// last frame there is), each range with "xSTEP" if not every frame is wanted (counted from its first).
/// @param first, last  the frames that exist; numbers outside are an error, so no frame is lost silently.
/// @throws ArgumentError, naming the part that is wrong and what would be right.
std::vector<int> parse_frame_range(const std::string& text, int first, int last);

}  // namespace morphkit::cli
