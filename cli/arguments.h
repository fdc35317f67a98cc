#pragma once
// Arguments shared by several commands that are not keys of a project.

#include <string>

#include <opencv2/core/types.hpp>

namespace morphkit::cli {

/// Parses "1280x720". @param option  its name, for the message.
/// @throws ArgumentError if it is not a size or exceeds the limit of a project.
cv::Size parse_size(const std::string& text, const std::string& option);

/// @throws ArgumentError unless t is in [0, 1]; also for NaN, which the parser accepts.
void require_moment(double t);

}  // namespace morphkit::cli
