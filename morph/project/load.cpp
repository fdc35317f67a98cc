// Files in: bytes, then text, then the document.

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "morph/error.h"
#include "morph/project/json.h"
#include "morph/project/limits.h"
#include "morph/project/project.h"
#include "morph/project/read_project.h"

namespace morphkit::project {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void fail_reading(const std::filesystem::path& file, int error) {
  throw Error(ErrorCode::kIo, file.string(), fmt::format("cannot be read: {}", std::generic_category().message(error)));
}

/// The whole file. Reads in pieces instead of asking for the size: pipes and devices have none.
std::string read_file(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw Error(ErrorCode::kIo, file.string(), "is a directory; expected a project file");
  }
  const std::unique_ptr<std::FILE, CloseFile> stream(std::fopen(file.c_str(), "rb"));
  if (!stream) fail_reading(file, errno);
  std::string text;
  char buffer[1 << 16];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, stream.get())) {
    text.append(buffer, count);
    if (text.size() > kMaxFileBytes) {
      throw Error(ErrorCode::kBadInput, file.string(),
                  fmt::format("larger than {} MB; this is no project", kMaxFileBytes >> 20));
    }
  }
  if (std::ferror(stream.get())) fail_reading(file, errno);
  return text;
}

}  // namespace

Project parse(const std::string& text, const std::filesystem::path& name) {
  auto original = std::make_shared<const std::string>(json::strip_bom(text, name.string()));
  const Document document{name.string(), json::parse(*original, name.string())};
  Project project = read_project(document);
  project.file = name;
  project.original = std::move(original);
  return project;
}

Project load(const std::filesystem::path& file) {
  return parse(read_file(file), file);
}

void load_features(Project& project, const std::filesystem::path& file) {
  const std::string text = json::strip_bom(read_file(file), file.string());
  read_features_over(project, {file.string(), json::parse(text, file.string())});
}

}  // namespace morphkit::project
