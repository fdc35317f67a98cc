#pragma once
// The .session files of gtkmorph. Internal to morph/exchange.

#include <filesystem>
#include <string>
#include <vector>

#include "morph/exchange/import.h"

namespace morphkit::exchange {

std::vector<std::string> import_session(project::Project& project, const ImportInput& input);

/// The pictures that it names, the source's first, as seen from the current folder.
/// @throws Error kIo, kBadInput if it names fewer than two pictures.
std::vector<std::filesystem::path> session_pictures(const std::filesystem::path& file);

}  // namespace morphkit::exchange
