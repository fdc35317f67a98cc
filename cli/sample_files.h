#pragma once
// A painted sample as files: its pictures and its project.

#include <filesystem>

#include "samples/samples.h"

namespace morphkit::cli {

/// Writes the pictures and <name>.json into `folder`, which is made if missing. A file that already holds the same
/// is left alone.
/// @return  the project file.
/// @throws Error kIo, also if a file with other contents exists and `overwrite` is off: it may be somebody's work.
std::filesystem::path write_sample(const samples::Sample& sample, const std::filesystem::path& folder, bool overwrite);

}  // namespace morphkit::cli
