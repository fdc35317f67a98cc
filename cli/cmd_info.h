#pragma once
// morphkit info FILE...: what is in pictures and project files.

#include <filesystem>
#include <functional>
#include <vector>

#include "cli/file_info.h"
#include "cli/project_argument.h"

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

struct InfoOptions {
  std::vector<std::filesystem::path> files;  ///< pictures and projects (*.json)
  ProjectChanges changes;                    ///< of every project
  bool pixels = false;                       ///< decode pictures for minimum, maximum, mean of each channel
  bool json = false;
};

void add_info(CommandLine& line, Session& session);

/// Describes a file. @throws Error.
using InfoReader = std::function<FileInfo(const std::filesystem::path& file)>;

/// Describes every file. One that cannot be read is reported, and the others are still described.
/// @return 0, or the code of the first error.
int tell(const InfoOptions& options, const InfoReader& info_of, Output& output);

/// Likewise, by the picture libraries.
int run_info(const InfoOptions& options, Output& output);

}  // namespace morphkit::cli
