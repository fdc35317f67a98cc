// xmorph and gtkmorph: one .mesh file per side. "M2", the numbers of columns and rows, then a line for every vertex, x
// fastest: x and y in tenths of a pixel, and an optional label. gtkmorph puts tags after them: the vertices then lie in
// a frame of <resulting image size>, which shows the part <rect> of a picture of the size <orig>.
//
// Their pixel 0 has its centre at 0 and a mesh reaches from the centre of the first pixel to that of the last, so 0 and
// W - 1 are 0.5 and W - 0.5 here; vertices at the border then move to the border of the picture, 0 and W.

#include "morph/exchange/import_xmorph.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/whole_file.h"
#include "morph/exchange/fit_mesh.h"
#include "morph/exchange/text_lines.h"
#include "morph/json/json.h"
#include "morph/project/limits.h"

namespace morphkit::exchange {
namespace {

constexpr double kTenths = 10;      // units of the file in a pixel
constexpr double kCentre = 0.5;     // of the first pixel here, 0 there
constexpr double kRounding = 0.05;  // px: half a unit of the file

/// The grid of the header, without vertices.
warp::Mesh read_head(TextLines& lines) {
  const auto magic = lines.next();
  if (!magic) lines.fail("the file is empty; expected a mesh of xmorph, which begins with \"M2\"");
  if (*magic != "M2") {
    lines.fail(fmt::format("expected \"M2\", the first line of a mesh of xmorph, found {}", json::shown(*magic)));
  }
  const auto line = lines.next();
  if (!line) lines.fail("the file ends here; expected the numbers of columns and rows");
  const auto words = words_of(*line, 3);
  const auto columns = words.size() == 2 ? number_in<long long>(words[0]) : std::nullopt;
  const auto rows = words.size() == 2 ? number_in<long long>(words[1]) : std::nullopt;
  if (!columns || !rows) {
    lines.fail(fmt::format("expected two whole numbers, those of columns and rows, found {}", json::shown(*line)));
  }
  const auto in_range = [](long long count) { return count >= 2 && count <= project::kMaxMeshSize; };
  if (!in_range(*columns) || !in_range(*rows) || *columns * *rows > project::kMaxMeshVertices) {
    lines.fail(fmt::format("a mesh of {} x {} vertices; expected 2 to {} each way, together at most {}", *columns,
                           *rows, project::kMaxMeshSize, project::kMaxMeshVertices));
  }
  return {static_cast<int>(*columns), static_cast<int>(*rows), {}};
}

cv::Point2d read_vertex(const TextLines& lines, std::string_view line) {
  const auto words = words_of(line, 4);
  const auto x = words.size() >= 2 ? number_in<double>(words[0]) : std::nullopt;
  const auto y = words.size() >= 2 ? number_in<double>(words[1]) : std::nullopt;
  const bool labelled = words.size() < 3 || number_in<double>(words[2]);
  if (!x || !y || !labelled || words.size() > 3) {
    lines.fail(
        fmt::format("expected a vertex, \"x y\" or \"x y label\" in tenths of a pixel, found {}", json::shown(line)));
  }
  for (const double value : {*x, *y}) {
    // Also refuses NaN.
    if (!(std::abs(value) <= project::kMaxCoordinate * kTenths)) {
      lines.fail(fmt::format("the vertex {} is out of range; expected {} to {}", json::shown(line),
                             json::number_text(-project::kMaxCoordinate * kTenths),
                             json::number_text(project::kMaxCoordinate * kTenths)));
    }
  }
  return {*x, *y};
}

/// What gtkmorph says after the vertices.
struct Tags {
  std::optional<cv::Size2d> frame;     ///< in which the vertices lie, px
  std::optional<cv::Size2d> original;  ///< the size of the picture that `rect` is a part of, px
  std::optional<cv::Rect2d> rect;      ///< the part of the picture that the frame shows, px
  std::vector<std::string> left_out;   ///< names of the tags that are not used, each once
};

/// A mesh as it stands in its file.
struct FileMesh {
  warp::Mesh mesh;          ///< tenths of a pixel
  std::string last_vertex;  ///< "file:line"
  Tags tags;
};

/// The part of <rect>. @throws Error kBadInput if it is empty.
cv::Rect2d read_rect(TextLines& lines, std::string_view tag) {
  const std::vector<double> numbers = read_numbers(lines, 4, tag);
  const cv::Rect2d rect(numbers[0], numbers[1], numbers[2], numbers[3]);
  if (rect.width < 1 || rect.height < 1) lines.fail(fmt::format("{} is empty; expected x y width height", tag));
  return rect;
}

Tags read_tags(TextLines& lines, std::optional<std::string_view> line) {
  constexpr std::string_view kNotTold[] = {"<SIS>", "<image file name>"};
  Tags tags;
  for (; line; line = lines.next()) {
    if (!line->starts_with('<') || line->starts_with("</")) continue;
    if (*line == "<resulting image size>") {
      tags.frame = read_size(lines, *line);
    } else if (*line == "<orig>") {
      tags.original = read_size(lines, *line);
    } else if (*line == "<rect>") {
      tags.rect = read_rect(lines, *line);
    } else if (const std::string name = json::shown(*line);
               std::ranges::find(kNotTold, *line) == std::end(kNotTold) &&
               std::ranges::find(tags.left_out, name) == tags.left_out.end()) {
      tags.left_out.push_back(name);
    }
  }
  return tags;
}

FileMesh read_mesh(std::string_view text, const std::string& name) {
  TextLines lines(text, name);
  FileMesh file{read_head(lines), {}, {}};
  warp::Mesh& mesh = file.mesh;
  const auto count = static_cast<std::size_t>(mesh.columns) * static_cast<std::size_t>(mesh.rows);
  const auto promised = [&] { return fmt::format("{} vertices ({} x {})", count, mesh.columns, mesh.rows); };
  while (mesh.vertices.size() < count) {
    const auto line = lines.next();
    if (!line || line->front() == '<') {
      lines.fail(fmt::format("{} after {} of {}", line ? "a tag" : "the file ends", mesh.vertices.size(), promised()));
    }
    mesh.vertices.push_back(read_vertex(lines, *line));
  }
  file.last_vertex = lines.place();
  const auto line = lines.next();
  if (line && line->front() != '<') {
    lines.fail(fmt::format("expected the end of the file after {}, found {}", promised(), json::shown(*line)));
  }
  file.tags = read_tags(lines, line);
  return file;
}

/// The frame of the vertices, px: as the tags say, else the last vertex is its last pixel.
cv::Size2d frame_of(const FileMesh& file, std::optional<cv::Size2d> frame) {
  if (frame) return *frame;
  if (file.tags.frame) return *file.tags.frame;
  const cv::Point2d last = file.mesh.vertices.back();
  // Less than a tenth of a pixel; this also refuses values that would scale to infinity.
  if (last.x < 1 || last.y < 1) {
    throw Error(ErrorKind::kBadInput, file.last_vertex,
                fmt::format("the last vertex, the lower right corner, is at ({}, {}); expected the size of a picture",
                            json::number_text(last.x), json::number_text(last.y)));
  }
  return {last.x / kTenths + 1, last.y / kTenths + 1};
}

/// The part of the picture that the frame shows, px.
cv::Rect2d part_of(const Tags& tags, cv::Size size) {
  if (!tags.rect) return {{0, 0}, cv::Size2d(size)};
  const cv::Size2d original = tags.original.value_or(cv::Size2d(size));
  const double x = size.width / original.width, y = size.height / original.height;
  return {tags.rect->x * x, tags.rect->y * y, tags.rect->width * x, tags.rect->height * y};
}

/// Converts from tenths of pixels of the frame to px of the picture.
warp::Mesh placed(const FileMesh& file, const MeshFile& asked, const std::string& name,
                  std::vector<std::string>& remarks) {
  const cv::Size2d frame = frame_of(file, asked.frame);
  const cv::Rect2d part = part_of(file.tags, asked.size);
  const cv::Size2d scale((part.width - 1) / (frame.width - 1) / kTenths,
                         (part.height - 1) / (frame.height - 1) / kTenths);
  warp::Mesh mesh = file.mesh;
  for (cv::Point2d& vertex : mesh.vertices) {
    vertex = {part.x + vertex.x * scale.width + kCentre, part.y + vertex.y * scale.height + kCentre};
    if (std::max(std::abs(vertex.x), std::abs(vertex.y)) > project::kMaxCoordinate) {
      throw Error(ErrorKind::kBadInput, file.last_vertex,
                  "a vertex is far outside the picture, whose lower right corner the last vertex is");
    }
  }
  if (file.tags.rect) {
    remarks.push_back(fmt::format("{}: lies on the part {:.6g} x {:.6g} at ({:.6g}, {:.6g}) of the picture", name,
                                  part.width, part.height, part.x, part.y));
  } else if (std::abs(frame.width - asked.size.width) > kRounding ||
             std::abs(frame.height - asked.size.height) > kRounding) {
    remarks.push_back(fmt::format("{}: drawn on {:.6g} x {:.6g} pixels, stretched to {} x {}", name, frame.width,
                                  frame.height, asked.size.width, asked.size.height));
  }
  if (!file.tags.left_out.empty())
    remarks.push_back(fmt::format("{}: left out: {}", name, fmt::join(file.tags.left_out, ", ")));
  return mesh;
}

/// The mesh of a side with a place for every vertex.
warp::Mesh side_mesh(const project::Mesh& mesh, const std::vector<cv::Point2d>& side, cv::Size size) {
  if (side.empty()) return warp::uniform_mesh(mesh.columns, mesh.rows, {{0, 0}, cv::Size2d(size)});
  return {mesh.columns, mesh.rows, side};
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

warp::Mesh parse_xmorph_mesh(const std::string& text, const std::string& name, cv::Size size,
                             std::vector<std::string>& remarks) {
  PictureMesh one{placed(read_mesh(text, name), {name, size, {}}, name, remarks), size, name};
  fit_to_pictures({&one, 1}, remarks);
  return std::move(one.mesh);
}

std::vector<PictureMesh> read_xmorph_meshes(std::span<const MeshFile> files, std::vector<std::string>& remarks) {
  std::vector<PictureMesh> meshes;
  for (const MeshFile& file : files) {
    const std::string name = file.file.string();
    const FileMesh read = read_mesh(read_file(file.file, "mesh", json::kMaxFileBytes), name);
    meshes.push_back({placed(read, file, name, remarks), file.size, name});
    const warp::Mesh& first = meshes.front().mesh;
    if (read.mesh.columns != first.columns || read.mesh.rows != first.rows) {
      throw Error(ErrorKind::kBadInput, name,
                  fmt::format("is a mesh of {} x {} vertices, but {} has {} x {}; both sides need the same",
                              read.mesh.columns, read.mesh.rows, meshes.front().name, first.columns, first.rows));
    }
  }
  fit_to_pictures(meshes, remarks);
  return meshes;
}

std::vector<std::string> import_meshes(project::Project& project, std::span<const MeshFile> files) {
  std::vector<std::string> remarks;
  std::vector<PictureMesh> meshes = read_xmorph_meshes(files, remarks);
  project.mesh = project::Mesh{meshes.front().mesh.columns, meshes.front().mesh.rows, {}, {}};
  project.mesh->vertices.clear();
  for (PictureMesh& one : meshes) {
    unfold(one, remarks);
    project.mesh->vertices.push_back(std::move(one.mesh.vertices));
  }
  project.warp.method = project::MethodName::kMesh;
  if (project.warp.border == warp::Border::kMirror) {
    project.warp.border.reset();
    remarks.emplace_back("the border \"mirror\" is gone: a mesh cannot mirror");
  }
  return remarks;
}

std::vector<std::string> import_xmorph(project::Project& project, const ImportInput& input) {
  const MeshFile files[] = {{input.files.at(0), input.source_size, {}},
                            {input.files.at(1), input.destination_size, {}}};
  return import_meshes(project, files);
}

std::string xmorph_mesh_text(const warp::Mesh& mesh, cv::Size size) {
  warp::Mesh placed = mesh;
  warp::snap_to_outline(placed, {kCentre, kCentre, size.width - 2 * kCentre, size.height - 2 * kCentre});
  std::string text = fmt::format("M2\n{} {}\n", mesh.columns, mesh.rows);
  for (int row = 0; row < mesh.rows; ++row) {
    for (int column = 0; column < mesh.columns; ++column) {
      const cv::Point2d& vertex = placed.at(column, row);
      text += fmt::format("{} {} 0\n", std::lround((vertex.x - kCentre) * kTenths),
                          std::lround((vertex.y - kCentre) * kTenths));
    }
  }
  return text;
}

std::vector<std::string> export_xmorph(const project::Project& project, const ExportOutput& output) {
  if (!project.mesh) {
    throw Error(ErrorKind::kBadInput, project.file.string(), "has no \"mesh\", the one thing that a .mesh file holds");
  }
  for (const cv::Size& size : {output.source_size, output.destination_size}) {
    if (size.width < 2 || size.height < 2) {
      throw Error(ErrorKind::kBadInput, project.file.string(),
                  fmt::format("a .mesh file cannot tell of a picture of {} x {} pixels; expected at least 2 x 2",
                              size.width, size.height));
    }
  }
  const project::Mesh& mesh = *project.mesh;
  const std::string source =
      xmorph_mesh_text(side_mesh(mesh, mesh.vertices[project::kSource], output.source_size), output.source_size);
  const std::string destination = xmorph_mesh_text(
      side_mesh(mesh, mesh.vertices[project::kDestination], output.destination_size), output.destination_size);
  // Both files are complete before one is put in place.
  AtomicFile source_file(output.files.at(0), output.overwrite);
  AtomicFile destination_file(output.files.at(1), output.overwrite);
  source_file.write(bytes_of(source));
  destination_file.write(bytes_of(destination));
  source_file.commit();
  destination_file.commit();

  std::vector<std::string> remarks;
  if (!project.features.empty()) {
    remarks.push_back(
        fmt::format("{} features are left out: a .mesh file has vertices alone", project.features.size()));
  }
  if (!mesh.groups.empty()) remarks.emplace_back("the groups of vertices, and with them their timing, are left out");
  return remarks;
}

}  // namespace morphkit::exchange
