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

/// The same without a limit: of a file whose contents decide how large it may be.
std::string read_file(const std::filesystem::path& file, const char* what);

}  // namespace morphkit
