#include "warp/mesh/mesh_warp.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "warp/image/image_pool.h"
#include "warp/mesh/area_resample.h"
#include "warp/mesh/mesh_curves.h"

namespace morphkit::warp {
namespace {

constexpr double kMaxCoordinate = 1e12;

/// Allowed distance of a border vertex from the outline, and of the outline from the image, px: rounding.
constexpr double kOffOutline = 1e-6;

/// Columns that are resampled together. Each is copied into its own line. 16 pixels are four cache lines of a row, and
/// 16 lines of 1080 pixels stay in the second-level cache.
constexpr int kBlock = 16;

/// Rows that are prefetched: the pixels of a column are too far apart for the hardware to predict.
constexpr int kAhead = 6;

void fetch(const Pixel* pixels, std::size_t count) {
  constexpr std::size_t kPerCacheLine = 64 / sizeof(Pixel);
  for (std::size_t i = 0; i < count; i += kPerCacheLine) __builtin_prefetch(pixels + i);
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

cv::Rect2d outline_of(const Mesh& mesh) {
  return {mesh.vertices.front(), mesh.vertices.back()};
}

/// x of one mesh, y of the other.
Mesh crossed(const Mesh& x, const Mesh& y) {
  Mesh result = x;
  for (std::size_t i = 0; i < result.vertices.size(); ++i) result.vertices[i].y = y.vertices[i].y;
  return result;
}

double signed_area(const Mesh& mesh, int column, int row) {
  const cv::Point2d rising = mesh.at(column + 1, row + 1) - mesh.at(column, row);
  const cv::Point2d falling = mesh.at(column, row + 1) - mesh.at(column + 1, row);
  return (rising.x * falling.y - rising.y * falling.x) / 2;
}

/// The vertical curves of the pass that moves pixels along rows: x as a function of y, y taken from `along`.
CurveFamily vertical_curves(MeshSpline spline, const Mesh& across, const Mesh& along) {
  std::vector<double> xs, ys;
  xs.reserve(across.vertices.size());
  ys.reserve(across.vertices.size());
  for (int column = 0; column < across.columns; ++column)
    for (int row = 0; row < across.rows; ++row) {
      xs.push_back(across.at(column, row).x);
      ys.push_back(along.at(column, row).y);
    }
  return {spline, static_cast<std::size_t>(across.rows), std::move(ys), std::move(xs)};
}

void validate(const Mesh& from, const Mesh& to) {
  for (const Mesh* mesh : {&from, &to}) {
    if (mesh->columns < 2 || mesh->rows < 2)
      throw std::invalid_argument("MeshWarp: a mesh has 2 x 2 vertices at least");
    if (mesh->vertices.size() != static_cast<std::size_t>(mesh->columns) * static_cast<std::size_t>(mesh->rows))
      throw std::invalid_argument("MeshWarp: " + std::to_string(mesh->vertices.size()) + " vertices for a mesh of " +
                                  std::to_string(mesh->columns) + " x " + std::to_string(mesh->rows));
    for (const cv::Point2d& vertex : mesh->vertices)
      if (!(std::abs(vertex.x) <= kMaxCoordinate && std::abs(vertex.y) <= kMaxCoordinate))
        throw std::invalid_argument("MeshWarp: a vertex is not finite or too far away");
    if (const auto off = off_outline(*mesh, outline_of(*mesh), kOffOutline))
      throw std::invalid_argument("MeshWarp: the border vertex in column " + std::to_string(off->column) + ", row " +
                                  std::to_string(off->row) + " is not on the outline");
  }
  if (from.columns != to.columns || from.rows != to.rows)
    throw std::invalid_argument("MeshWarp: the meshes differ in size");
}

PassOrder choose(const Mesh& from, const Mesh& to, PassOrder asked) {
  if (asked != PassOrder::kAuto) return asked;
  const auto cost = [&](PassOrder order) {
    return std::pair(!find_folds(intermediate_mesh(from, to, order)).empty(), area_lost(from, to, order));
  };
  return cost(PassOrder::kColumnsFirst) < cost(PassOrder::kRowsFirst) ? PassOrder::kColumnsFirst
                                                                      : PassOrder::kRowsFirst;
}

/// Resamples lines of one pass. Kept per thread: a scanline starts its searches where the last one ended.
class LineResampler {
 public:
  LineResampler(const MeshPass& pass, Border border, int length)
      : pass_(pass), border_(border), hints_(pass.hints()), edges_(static_cast<std::size_t>(length) + 1) {}

  /// Resamples the scanline with its centre at `index` + 0.5.
  void operator()(int index, std::span<const Pixel> source, std::span<Pixel> out) {
    pass_.knots(index + 0.5, static_cast<double>(source.size()), hints_, knots_);
    knots_.edges(edges_);
    const bool goes_on = border_ == Border::kClamp;
    resample_line(
        source, {edges_, goes_on ? 0 : knots_.to.front(), goes_on ? static_cast<double>(out.size()) : knots_.to.back()},
        out);
  }

 private:
  const MeshPass& pass_;
  Border border_;
  MeshPass::Hints hints_;
  LineKnots knots_;
  std::vector<double> edges_;
};

std::span<Pixel> row_of(Image& image, int y) {
  return {image[y], static_cast<std::size_t>(image.cols)};
}

Image resample_rows(const Image& source, const MeshPass& pass, Border border, int width) {
  Image out = pooled_image({width, source.rows});
  for_rows(source.rows, [&](int begin, int end) {
    LineResampler resample(pass, border, width);
    for (int y = begin; y < end; ++y) resample(y, {source[y], static_cast<std::size_t>(source.cols)}, row_of(out, y));
  });
  return out;
}

Image resample_columns(const Image& source, const MeshPass& pass, Border border, int height) {
  Image out = pooled_image({source.cols, height});
  const auto in_length = static_cast<std::size_t>(source.rows), out_length = static_cast<std::size_t>(height);
  // A few pixels more than a line: lines a power of two apart would compete for the same cache lines.
  const std::size_t in_stride = in_length + 5, out_stride = out_length + 5;
  const auto block = [&](int first, LineResampler& resample, std::vector<Pixel>& in, std::vector<Pixel>& bent) {
    const auto width = static_cast<std::size_t>(std::min(kBlock, source.cols - first));
    for (int y = 0; y < source.rows; ++y) {
      const Pixel* const row = source[y] + first;
      if (y + kAhead < source.rows) fetch(source[y + kAhead] + first, width);
      Pixel* const column = in.data() + y;
      for (std::size_t i = 0; i < width; ++i) column[i * in_stride] = row[i];
    }
    for (std::size_t i = 0; i < width; ++i)
      resample(first + static_cast<int>(i), {in.data() + i * in_stride, in_length},
               {bent.data() + i * out_stride, out_length});
    for (int y = 0; y < height; ++y) {
      Pixel* const row = out[y] + first;
      const Pixel* const column = bent.data() + y;
      for (std::size_t i = 0; i < width; ++i) row[i] = column[i * out_stride];
    }
  };
  const auto blocks_of = [&](int begin, int end) {
    LineResampler resample(pass, border, height);
    std::vector<Pixel> in(in_stride * kBlock), bent(out_stride * kBlock);
    for (int i = begin; i < end; ++i) block(i * kBlock, resample, in, bent);
  };
  for_rows((source.cols + kBlock - 1) / kBlock, blocks_of, 4);
  return out;
}

}  // namespace

namespace detail {

/// Both passes, in a frame where the first pass moves pixels along rows. For kColumnsFirst, the meshes
/// are transposed.
class MeshTables {
 public:
  MeshTables(Mesh from, Mesh to, const MeshWarpOptions& options)
      : from_(std::move(from)), to_(std::move(to)), order_(choose(from_, to_, options.order)) {
    const Mesh first = turned() ? transposed(from_) : from_, second = turned() ? transposed(to_) : to_;
    const MeshSpline spline = options.spline;
    first_ = std::make_unique<const MeshPass>(
        MeshPass{spline, vertical_curves(spline, second, first), vertical_curves(spline, first, first)});
    // The horizontal curves are the vertical ones of the transposed mesh.
    const Mesh from_t = transposed(first), to_t = transposed(second);
    second_ = std::make_unique<const MeshPass>(
        MeshPass{spline, vertical_curves(spline, to_t, to_t), vertical_curves(spline, from_t, to_t)});
    source_size_ = outline_of(first).size();
  }

  const Mesh& from() const { return from_; }
  const Mesh& to() const { return to_; }
  cv::Size2d source_size() const { return source_size_; }  ///< in the frame of the passes
  PassOrder order() const { return order_; }
  bool turned() const { return order_ == PassOrder::kColumnsFirst; }
  const MeshPass& first() const { return *first_; }
  const MeshPass& second() const { return *second_; }

 private:
  Mesh from_, to_;
  PassOrder order_;
  cv::Size2d source_size_;
  std::unique_ptr<const MeshPass> first_, second_;
};

}  // namespace detail

Mesh intermediate_mesh(const Mesh& from, const Mesh& to, PassOrder order) {
  return order == PassOrder::kRowsFirst ? crossed(to, from) : crossed(from, to);
}

double area_lost(const Mesh& from, const Mesh& to, PassOrder order) {
  const Mesh between = intermediate_mesh(from, to, order);
  double need = 0, lacking = 0;
  for (int row = 0; row + 1 < from.rows; ++row)
    for (int column = 0; column + 1 < from.columns; ++column) {
      const double ends = std::max(0.0, std::min(signed_area(from, column, row), signed_area(to, column, row)));
      need += ends;
      lacking += std::max(0.0, ends - std::max(0.0, signed_area(between, column, row)));
    }
  return need > 0 ? lacking / need : 0;
}

MeshWarp::MeshWarp(Mesh from, Mesh to, const MeshWarpOptions& options) {
  validate(from, to);
  tables_ = std::make_shared<const detail::MeshTables>(std::move(from), std::move(to), options);
}

const Mesh& MeshWarp::from() const noexcept {
  return tables_->from();
}

const Mesh& MeshWarp::to() const noexcept {
  return tables_->to();
}

PassOrder MeshWarp::order() const noexcept {
  return tables_->order();
}

Image MeshWarp::first_pass(const Image& source, cv::Size size, Border border) const {
  const cv::Size2d outline = outline_of(from()).size();
  if (source.empty() || size.empty()) throw std::invalid_argument("MeshWarp: an empty image");
  if (std::abs(outline.width - source.cols) > kOffOutline || std::abs(outline.height - source.rows) > kOffOutline)
    throw std::invalid_argument("MeshWarp: the image has not the size of the outline of its mesh");
  if (border == Border::kMirror) throw std::invalid_argument("MeshWarp: a mesh has no mirrored border");
  return tables_->turned() ? resample_columns(source, tables_->first(), border, size.height)
                           : resample_rows(source, tables_->first(), border, size.width);
}

Image MeshWarp::apply(const Image& source, cv::Size size, Border border) const {
  return second_pass(first_pass(source, size, border), size, border);
}

Image MeshWarp::second_pass(const Image& between, cv::Size size, Border border) const {
  if (between.empty() || size.empty()) throw std::invalid_argument("MeshWarp: an empty image");
  return tables_->turned() ? resample_rows(between, tables_->second(), border, size.width)
                           : resample_columns(between, tables_->second(), border, size.height);
}

cv::Point2d MeshWarp::source_of(cv::Point2d output) const {
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  const cv::Rect2d outline = outline_of(to());
  const bool inside = output.x >= outline.x && output.y >= outline.y && output.x <= outline.x + outline.width &&
                      output.y <= outline.y + outline.height;
  if (!inside) return {kNowhere, kNowhere};
  if (tables_->turned()) std::swap(output.x, output.y);
  MeshPass::Hints first_hints = tables_->first().hints(), second_hints = tables_->second().hints();
  std::size_t column = kUnknown, row = kUnknown;
  const double y = tables_->second().at(output.x, output.y, tables_->source_size().height, second_hints, row);
  const double x = tables_->first().at(y, output.x, tables_->source_size().width, first_hints, column);
  return tables_->turned() ? cv::Point2d(y, x) : cv::Point2d(x, y);
}

Map MeshWarp::map(cv::Size size) const {
  const bool turned = tables_->turned();
  const int width = turned ? size.height : size.width, height = turned ? size.width : size.height;
  const cv::Rect2d outline = outline_of(turned ? transposed(to()) : to());
  const auto columns = static_cast<std::size_t>(width);

  // The source interval of every pixel of a column in the intermediate image, once per column.
  std::vector<LineKnots> knots(columns);
  for_rows(width, [&](int begin, int end) {
    MeshPass::Hints hints = tables_->second().hints();
    for (int x = begin; x < end; ++x)
      tables_->second().knots(x + 0.5, tables_->source_size().height, hints, knots[static_cast<std::size_t>(x)]);
  });

  Map map(height, width, MapPoint(kNan, kNan));
  for_rows(height, [&](int begin, int end) {
    MeshPass::Hints hints = tables_->first().hints();
    std::vector<std::size_t> rows(columns, kUnknown);
    for (int j = begin; j < end; ++j) {
      const double y = j + 0.5;
      if (y < outline.y || y > outline.y + outline.height) continue;
      std::size_t segment = kUnknown;
      for (std::size_t i = 0; i < columns; ++i) {
        const double x = static_cast<double>(i) + 0.5;
        if (x < outline.x || x > outline.x + outline.width) continue;
        const double between = knots[i].at(y, rows[i]);
        const double from = tables_->first().at(between, x, tables_->source_size().width, hints, segment);
        map(j, static_cast<int>(i)) = {static_cast<float>(from), static_cast<float>(between)};
      }
    }
  });
  if (!turned) return map;
  Map upright(size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) upright(y, x) = {map(x, y)[1], map(x, y)[0]};
  return upright;
}

MeshValues::MeshValues(const Mesh& mesh, std::span<const double> values)
    : mesh_(mesh), values_(values.begin(), values.end()) {
  if (values.size() != mesh.vertices.size()) throw std::invalid_argument("MeshValues: one value per vertex");
}

void MeshValues::row(int y, std::span<float> out) const {
  const double at = y + 0.5;
  // Place and value of every column at this height.
  thread_local std::vector<std::pair<double, double>> knots;
  knots.clear();
  for (int column = 0; column < mesh_.columns; ++column) {
    int row = 0;
    for (int end = mesh_.rows - 1; end - row > 1;) {
      const int middle = (row + end) / 2;
      (mesh_.at(column, middle).y <= at ? row : end) = middle;
    }
    const cv::Point2d a = mesh_.at(column, row), b = mesh_.at(column, row + 1);
    const double u = b.y > a.y ? std::clamp((at - a.y) / (b.y - a.y), 0.0, 1.0) : 0;
    const double x = std::lerp(a.x, b.x, u);
    knots.emplace_back(knots.empty() ? x : std::max(x, knots.back().first),
                       std::lerp(values_[mesh_.index(column, row)], values_[mesh_.index(column, row + 1)], u));
  }
  std::size_t segment = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double x = static_cast<double>(i) + 0.5;
    while (segment + 2 < knots.size() && knots[segment + 1].first <= x) ++segment;
    const auto& [x0, v0] = knots[segment];
    const auto& [x1, v1] = knots[segment + 1];
    const double u = x1 > x0 ? std::clamp((x - x0) / (x1 - x0), 0.0, 1.0) : 0;
    out[i] = static_cast<float>(std::lerp(v0, v1, u));
  }
}

}  // namespace morphkit::warp
