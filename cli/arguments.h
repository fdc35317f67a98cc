#pragma once
// Arguments of several commands that are no keys of a project.

#include <string>

#include <opencv2/core/types.hpp>

namespace morphkit::cli {

/// "1280x720". @param option  that says it, for the message.
/// @throws ArgumentError if it is no size, or a larger one than a project may ask for.
cv::Size parse_size(const std::string& text, const std::string& option);

/// @throws ArgumentError unless t lies in [0, 1]; NaN, which the parser lets pass, does not.
void require_moment(double t);

}  // namespace morphkit::cli
