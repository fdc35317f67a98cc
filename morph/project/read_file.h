#pragma once
// Bytes of a file. Internal to morph/project.

#include <filesystem>
#include <string>

namespace morphkit::project {

/// The whole file, pipes included. @param what  names what is expected, for messages: "project".
/// @throws Error kIo; kBadInput if it is larger than kMaxFileBytes.
std::string read_file(const std::filesystem::path& file, const char* what);

}  // namespace morphkit::project
