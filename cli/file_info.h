#pragma once
// What `info` tells about a picture and a project, as data.

#include <filesystem>

#include "cli/report.h"

namespace morphkit::cli {

/// Facts of a file, for people (lines) and for machines (JSON).
struct FileInfo {
  std::string text;  ///< lines, each ended by a newline
  Report report;
};

/// @param pixels  also decode, for the statistics of each channel. @throws Error as media::read_info, read_picture.
FileInfo picture_info(const std::filesystem::path& file, bool pixels);

/// @throws Error as project::load. A picture of the project that cannot be read is told, not thrown.
FileInfo project_info(const std::filesystem::path& file);

}  // namespace morphkit::cli
