#pragma once
// What `info` tells about a picture and a project, as data.

#include <filesystem>
#include <functional>

#include <opencv2/core/types.hpp>

#include "cli/report.h"

namespace morphkit::cli {

struct ProjectChanges;

/// Facts of a file, for people (lines) and for machines (JSON).
struct FileInfo {
  std::string text;  ///< lines, each ended by a newline
  Report report;
};

/// @param pixels  also decode, for the statistics of each channel. @throws Error as media::read_info, read_picture.
FileInfo picture_info(const std::filesystem::path& file, bool pixels);

/// Tells the size of a picture file, px, as it stands upright.
using SizeReader = std::function<cv::Size(const std::filesystem::path& file)>;

/// @throws Error as load_project. A picture of the project that cannot be read is reported, not thrown.
FileInfo project_info(const std::filesystem::path& file, const ProjectChanges& changes, const SizeReader& size_of);

}  // namespace morphkit::cli
