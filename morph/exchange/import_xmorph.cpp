// xmorph and gtkmorph: one .mesh file per side. "M2", the numbers of columns and rows, then a line for every vertex, x
// fastest: x and y in tenths of a pixel, and an optional label. gtkmorph puts tags after them.
//
// Their pixel 0 has its centre at 0 and a mesh reaches from the centre of the first pixel to that of the last, so 0 and
// W - 1 are 0.5 and W - 0.5 here; vertices at the border then move to the border of the picture, 0 and W.

#include "morph/exchange/import_xmorph.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/whole_file.h"
#include "morph/json/json.h"
#include "morph/project/limits.h"

namespace morphkit::exchange {
namespace {

constexpr double kTenths = 10;      // units of the file in a pixel
constexpr double kCentre = 0.5;     // of the first pixel here, 0 there
constexpr double kRounding = 0.05;  // px: half a unit of the file

/// The lines of a file and their words.
class Lines {
 public:
  Lines(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {}

  /// The next line that is not blank, without its end and surrounding space; nullopt at the end of the file.
  std::optional<std::string_view> next() {
    while (!rest_.empty()) {
      const std::size_t end = rest_.find('\n');
      const std::string_view line = trimmed(rest_.substr(0, end));
      rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
      ++number_;
      if (!line.empty()) return line;
    }
    return std::nullopt;
  }

  /// @throws Error kBadInput at the last line read.
  [[noreturn]] void fail(const std::string& message) const { throw Error(ErrorKind::kBadInput, place(), message); }

  /// "file:line" of the last line read.
  std::string place() const { return fmt::format("{}:{}", name_, std::max(number_, 1)); }

  int number() const noexcept { return number_; }

 private:
  static std::string_view trimmed(std::string_view line) {
    constexpr std::string_view kSpace = " \t\r\f\v";
    const std::size_t begin = line.find_first_not_of(kSpace);
    if (begin == std::string_view::npos) return {};
    return line.substr(begin, line.find_last_not_of(kSpace) - begin + 1);
  }

  std::string_view rest_;
  std::string name_;
  int number_ = 0;
};

/// The words of a line; everything after the first `most` words is one word.
std::vector<std::string_view> words_of(std::string_view line, std::size_t most) {
  std::vector<std::string_view> words;
  while (!line.empty()) {
    const std::size_t end = words.size() + 1 < most ? line.find_first_of(" \t") : std::string_view::npos;
    words.push_back(line.substr(0, end));
    line.remove_prefix(words.back().size());
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  }
  return words;
}

template <typename T>
std::optional<T> number_in(std::string_view word) {
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// The grid of the header, without vertices.
warp::Mesh read_head(Lines& lines) {
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

cv::Point2d read_vertex(const Lines& lines, std::string_view line) {
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

/// Places in a file.
struct Places {
  std::string last_vertex;  ///< "file:line"
  int tags = 0;             ///< line of gtkmorph's first tag; 0: there is none
};

Places read_vertices(Lines& lines, warp::Mesh& mesh) {
  const auto count = static_cast<std::size_t>(mesh.columns) * static_cast<std::size_t>(mesh.rows);
  const auto promised = [&] { return fmt::format("{} vertices ({} x {})", count, mesh.columns, mesh.rows); };
  while (mesh.vertices.size() < count) {
    const auto line = lines.next();
    if (!line || line->front() == '<') {
      lines.fail(fmt::format("{} after {} of {}", line ? "a tag" : "the file ends", mesh.vertices.size(), promised()));
    }
    mesh.vertices.push_back(read_vertex(lines, *line));
  }
  Places places{lines.place(), 0};
  const auto line = lines.next();
  if (line && line->front() != '<') {
    lines.fail(fmt::format("expected the end of the file after {}, found {}", promised(), json::shown(*line)));
  }
  if (line) places.tags = lines.number();
  return places;
}

/// The largest distance of a border vertex of a scaled mesh, in xmorph's convention, from its right place, px.
double border_distance(const warp::Mesh& mesh, cv::Size size) {
  double distance = 0;
  const auto look = [&](double found, double wanted) { distance = std::max(distance, std::abs(found - wanted)); };
  for (int row = 0; row < mesh.rows; ++row) {
    look(mesh.at(0, row).x, kCentre);
    look(mesh.at(mesh.columns - 1, row).x, size.width - kCentre);
  }
  for (int column = 0; column < mesh.columns; ++column) {
    look(mesh.at(column, 0).y, kCentre);
    look(mesh.at(column, mesh.rows - 1).y, size.height - kCentre);
  }
  return distance;
}

/// Converts from tenths of pixels of the mesh's own picture; the last vertex is its last pixel.
void bring_to(warp::Mesh& mesh, cv::Size size, const std::string& name, const Places& places,
              std::vector<std::string>& remarks) {
  const cv::Point2d last = mesh.vertices.back();
  // Less than a tenth of a pixel; this also refuses values that would scale to infinity.
  if (last.x < 1 || last.y < 1) {
    throw Error(ErrorKind::kBadInput, places.last_vertex,
                fmt::format("the last vertex, the lower right corner, is at ({}, {}); expected the size of a picture",
                            json::number_text(last.x), json::number_text(last.y)));
  }
  const cv::Size2d scale((size.width - 1) / last.x, (size.height - 1) / last.y);
  for (cv::Point2d& vertex : mesh.vertices) {
    vertex = {vertex.x * scale.width + kCentre, vertex.y * scale.height + kCentre};
    if (std::max(std::abs(vertex.x), std::abs(vertex.y)) > project::kMaxCoordinate) {
      throw Error(ErrorKind::kBadInput, places.last_vertex,
                  "a vertex is far outside the picture, whose lower right corner the last vertex is");
    }
  }
  const cv::Size2d drawn_on(last.x / kTenths + 1, last.y / kTenths + 1);
  if (std::abs(drawn_on.width - size.width) > kRounding || std::abs(drawn_on.height - size.height) > kRounding) {
    remarks.push_back(fmt::format("{}: drawn on {:.6g} x {:.6g} pixels, stretched to {} x {}", name, drawn_on.width,
                                  drawn_on.height, size.width, size.height));
  }
  if (const double distance = border_distance(mesh, size); distance > kRounding) {
    remarks.push_back(
        fmt::format("{}: vertices of the border were up to {:.1f} pixels off and moved onto it", name, distance));
  }
  warp::snap_to_outline(mesh, {{0, 0}, cv::Size2d(size)});
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
  Lines lines(text, name);
  warp::Mesh mesh = read_head(lines);
  const Places places = read_vertices(lines, mesh);
  if (places.tags > 0) remarks.push_back(fmt::format("{}: the tags from line {} on are left out", name, places.tags));
  bring_to(mesh, size, name, places, remarks);
  return mesh;
}

warp::Mesh read_xmorph_mesh(const std::filesystem::path& file, cv::Size size, std::vector<std::string>& remarks) {
  return parse_xmorph_mesh(read_file(file, "mesh", json::kMaxFileBytes), file.string(), size, remarks);
}

std::vector<std::string> import_xmorph(project::Project& project, const ImportInput& input) {
  std::vector<std::string> remarks;
  warp::Mesh source = read_xmorph_mesh(input.files.at(0), input.source_size, remarks);
  warp::Mesh destination = read_xmorph_mesh(input.files.at(1), input.destination_size, remarks);
  if (source.columns != destination.columns || source.rows != destination.rows) {
    throw Error(
        ErrorKind::kBadInput, input.files[1].string(),
        fmt::format("a mesh of {} x {} vertices, but {} has {} x {}; both sides need the same", destination.columns,
                    destination.rows, input.files[0].string(), source.columns, source.rows));
  }
  project.mesh =
      project::Mesh{source.columns, source.rows, {std::move(source.vertices), std::move(destination.vertices)}, {}};
  project.warp.method = project::MethodName::kMesh;
  if (project.warp.border == warp::Border::kMirror) {
    project.warp.border.reset();
    remarks.emplace_back("the border \"mirror\" is gone: a mesh cannot mirror");
  }
  return remarks;
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
