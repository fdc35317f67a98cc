#pragma once
// Reads whole files.

#include <cstddef>
#include <filesystem>
#include <string>

namespace morphkit {

/// The contents of the whole file; pipes work too.
/// @param what  the kind of file, for messages: "project".
/// @param most largest size, bytes.
/// @throws Error kIo; kBadInput if it is larger than `most`.
std::string read_file(const std::filesystem::path& file, const char* what, std::size_t most);

}  // namespace morphkit
