#pragma once
// A file read whole.

#include <cstddef>
#include <filesystem>
#include <string>

namespace morphkit {

/// The whole file, pipes included.
/// @param what  names what is expected, for messages: "project".
/// @param most  bytes.
/// @throws Error kIo; kBadInput if it is larger than `most`.
std::string read_file(const std::filesystem::path& file, const char* what, std::size_t most);

}  // namespace morphkit
