#include "morph/exchange/import.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/words.h"
#include "morph/exchange/import_session.h"
#include "morph/exchange/import_xmorph.h"

namespace morphkit::exchange {
namespace {

constexpr std::string_view kXmorphExtensions[] = {".mesh"};

constexpr std::string_view kSessionExtensions[] = {".session"};

constexpr Format kFormats[] = {
    {"xmorph", kXmorphExtensions, 2, "two .mesh files, the source's first", import_xmorph, export_xmorph, nullptr},
    {"gtkmorph", kSessionExtensions, 1, "one .session file", import_session, nullptr, session_pictures}};

const Format* find_format(const std::filesystem::path& file) {
  const std::string extension = lower(file.extension().string());
  const auto found = std::ranges::find_if(kFormats, [&](const Format& format) {
    return std::ranges::find(format.extensions, extension) != format.extensions.end();
  });
  return found == std::end(kFormats) ? nullptr : found;
}

std::string known_extensions() {
  std::vector<std::string> names;
  for (const Format& format : kFormats) {
    names.push_back(fmt::format("{} ({})", fmt::join(format.extensions, ", "), format.name));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

const Format& format_of(const std::vector<std::filesystem::path>& files) {
  if (files.empty()) throw Error(ErrorKind::kUnsupported, "", "no file is named; known are " + known_extensions());
  const Format* format = find_format(files.front());
  for (const std::filesystem::path& file : files) {
    const Format* other = find_format(file);
    if (!other) {
      throw Error(
          ErrorKind::kUnsupported, file.string(),
          fmt::format("no format has the extension '{}'; known are {}", file.extension().string(), known_extensions()));
    }
    if (other != format) {
      throw Error(ErrorKind::kUnsupported, file.string(),
                  fmt::format("is of {}, {} of {}; name files of one format", other->name, files.front().string(),
                              format->name));
    }
  }
  if (files.size() != format->files) {
    throw Error(ErrorKind::kUnsupported, files.front().string(),
                fmt::format("{} files are named; {} wants {}", files.size(), format->name, format->wants));
  }
  return *format;
}

}  // namespace

std::span<const Format> formats() {
  return kFormats;
}

std::vector<std::filesystem::path> pictures_in(const std::vector<std::filesystem::path>& files) {
  const Format& format = format_of(files);
  if (!format.pictures) return {};
  return format.pictures(files.front());
}

ImportReport import_into(project::Project& project, const ImportInput& input) {
  const Format& format = format_of(input.files);
  project::Project result = project;
  ImportReport report{std::string(format.name), format.import_files(result, input)};
  project = std::move(result);
  return report;
}

std::vector<std::string> export_to(const project::Project& project, const ExportOutput& output) {
  const Format& format = format_of(output.files);
  if (!format.export_files) {
    throw Error(ErrorKind::kUnsupported, output.files.front().string(),
                fmt::format("files of {} are only read, not written", format.name));
  }
  std::set<std::filesystem::path> names;
  for (const std::filesystem::path& file : output.files) {
    if (!names.insert(std::filesystem::weakly_canonical(std::filesystem::absolute(file))).second)
      throw Error(ErrorKind::kUnsupported, file.string(), "is named twice; each side needs a file of its own");
  }
  return format.export_files(project, output);
}

}  // namespace morphkit::exchange
