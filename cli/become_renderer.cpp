#include <cerrno>
#include <filesystem>
#include <system_error>

#include <unistd.h>

#include "base/error.h"
#include "cli/works.h"

namespace morphkit::cli {

void become_renderer(const char* const* argv) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path renderer = (self.parent_path() / MORPHKIT_RENDERER).lexically_normal();
  if (!error) {
    ::execv(renderer.c_str(), const_cast<char* const*>(argv));
    error = std::error_code(errno, std::generic_category());
  }
  throw Error(
      ErrorKind::kFailed, renderer.string(),
      "cannot be started: " + error.message() + "; this part of morphkit renders, and must be installed with it");
}

}  // namespace morphkit::cli
