#include "base/whole_file.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "base/error.h"

namespace morphkit {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void fail_reading(const std::filesystem::path& file, int error) {
  throw Error(ErrorKind::kIo, file.string(), fmt::format("cannot be read: {}", std::generic_category().message(error)));
}

}  // namespace

std::string read_file(const std::filesystem::path& file, const char* what, std::size_t most) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw Error(ErrorKind::kIo, file.string(), fmt::format("is a directory; expected a {} file", what));
  }
  const std::unique_ptr<std::FILE, CloseFile> stream(std::fopen(file.c_str(), "rb"));
  if (!stream) fail_reading(file, errno);
  // Reads in pieces: pipes and devices have no size to ask for.
  std::string text;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error && size <= most) text.reserve(static_cast<std::size_t>(size));
  char buffer[1 << 16];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, stream.get())) {
    text.append(buffer, count);
    if (text.size() > most) {
      throw Error(ErrorKind::kBadInput, file.string(),
                  fmt::format("larger than {} MB; this is no {}", most >> 20, what));
    }
  }
  if (std::ferror(stream.get())) fail_reading(file, errno);
  return text;
}

std::string read_file(const std::filesystem::path& file, const char* what) {
  return read_file(file, what, std::numeric_limits<std::size_t>::max());
}

}  // namespace morphkit
