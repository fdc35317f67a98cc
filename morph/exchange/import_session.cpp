// gtkmorph's sessions: tags on lines of their own, values on the lines between. Each <image> names a picture and its
// mesh; <resulting_size> is the frame in which the meshes of all of them lie.

#include "morph/exchange/import_session.h"

#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "base/error.h"
#include "base/whole_file.h"
#include "morph/exchange/import_xmorph.h"
#include "morph/exchange/text_lines.h"
#include "morph/json/json.h"

namespace morphkit::exchange {
namespace {

namespace fs = std::filesystem;

struct SessionImage {
  fs::path picture, mesh;
};

struct GtkmorphSession {
  std::vector<SessionImage> images;
  std::optional<cv::Size2d> frame;  ///< px
};

/// The name after a tag, as seen from the current folder.
fs::path read_name(TextLines& lines, std::string_view tag, const fs::path& folder) {
  const auto line = lines.next();
  if (!line || line->front() == '<') lines.fail(fmt::format("expected the name of a file after {}", tag));
  return folder / *line;
}

GtkmorphSession read_session(const fs::path& file) {
  const std::string text = read_file(file, "session", json::kMaxFileBytes);
  TextLines lines(text, file.string());
  const auto first = lines.next();
  if (first != "<gtkmorph session>") {
    lines.fail(fmt::format("expected \"<gtkmorph session>\", the first line of a session of gtkmorph, found {}",
                           first ? json::shown(*first) : "an empty file"));
  }
  GtkmorphSession session;
  const auto image = [&]() -> SessionImage& {
    if (session.images.empty()) lines.fail("a file is named before the first <image>");
    return session.images.back();
  };
  while (const auto line = lines.next()) {
    if (*line == "<image>") session.images.emplace_back();
    if (*line == "<resulting_size>") session.frame = read_size(lines, *line);
    if (*line == "<image file in>") image().picture = read_name(lines, *line, file.parent_path());
    if (*line == "<mesh file>") image().mesh = read_name(lines, *line, file.parent_path());
  }
  if (session.images.size() < 2) {
    throw Error(ErrorKind::kBadInput, file.string(),
                fmt::format("names {} pictures; a morph needs two", session.images.size()));
  }
  for (const SessionImage& one : session.images) {
    if (one.picture.empty() || one.mesh.empty())
      throw Error(ErrorKind::kBadInput, file.string(), "an <image> names no picture or no mesh");
  }
  return session;
}

}  // namespace

std::vector<fs::path> session_pictures(const fs::path& file) {
  const GtkmorphSession session = read_session(file);
  return {session.images[0].picture, session.images[1].picture};
}

std::vector<std::string> import_session(project::Project& project, const ImportInput& input) {
  const fs::path& file = input.files.at(0);
  const GtkmorphSession session = read_session(file);
  const MeshFile meshes[] = {{session.images[0].mesh, input.source_size, session.frame},
                             {session.images[1].mesh, input.destination_size, session.frame}};
  std::vector<std::string> remarks = import_meshes(project, meshes);
  if (session.images.size() > 2)
    remarks.push_back(
        fmt::format("{}: only the first two of {} pictures are used", file.string(), session.images.size()));
  return remarks;
}

}  // namespace morphkit::exchange
