#include "warp/field/line_field.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "warp/field/line_field_tables.h"

namespace morphkit::warp {
namespace detail {

void reference_point(const FieldTables& tables, double x, double y, std::span<const int> channels,
                     std::span<double> means) noexcept {
  std::fill(means.begin(), means.end(), 0.0);
  double total = 0;
  bool on_line = false;
  for (const LineGroup& group : tables.groups()) {
    for (int line = group.begin; line < group.begin + group.count; ++line) {
      const auto i = static_cast<size_t>(line);
      const double dx = x - tables.origin_x[i];
      const double dy = y - tables.origin_y[i];
      const double along = dx * tables.along_x[i] + dy * tables.along_y[i];   // u |Q - P|
      const double across = dy * tables.along_x[i] - dx * tables.along_y[i];  // v
      const double beyond = std::max(std::max(-along, along - tables.length[i]), 0.0);
      const double reach = tables.a[i] + std::sqrt(across * across + beyond * beyond);
      const bool hit = reach < kOnLinePx;
      if (on_line && !hit) continue;
      if (hit && !on_line) {
        on_line = true;
        total = 0;
        std::fill(means.begin(), means.end(), 0.0);
      }
      const double weight = hit ? tables.factor[i] : tables.factor[i] * std::pow(reach, -tables.b[i]);
      total += weight;
      for (size_t c = 0; c < channels.size(); ++c) {
        const int channel = channels[c];
        means[c] +=
            weight * (tables.at(channel)[i] + tables.slope_x(channel)[i] * dx + tables.slope_y(channel)[i] * dy);
      }
    }
  }
  if (total == 0) return;
  for (double& mean : means) mean /= total;
}

}  // namespace detail

namespace {

void check_maps(const detail::FieldTables& tables, cv::Rect area, std::span<const Map> positions,
                const cv::Mat1f* values) {
  if (positions.size() != static_cast<size_t>(tables.targets()))
    throw std::invalid_argument("LineField: one map of positions per target");
  const auto fits = [&](const cv::Mat& map) { return area.empty() ? map.empty() : map.size() == area.size(); };
  if (!std::all_of(positions.begin(), positions.end(), fits) || (values != nullptr && !fits(*values)))
    throw std::invalid_argument("LineField: maps must have the size of the area");
}

}  // namespace

LineField::LineField(std::span<const FieldLine> lines, int targets)
    : tables_(std::make_shared<const detail::FieldTables>(lines, targets)) {}

int LineField::targets() const noexcept {
  return tables_->targets();
}

bool LineField::empty() const noexcept {
  return tables_->lines() == 0;
}

void LineField::evaluate(cv::Rect area, FieldAccuracy accuracy, std::span<Map> positions, cv::Mat1f* values) const {
  check_maps(*tables_, area, positions, values);
  detail::simd_evaluate(*tables_, area, accuracy, positions, values);
}

void LineField::reference(cv::Rect area, std::span<Map> positions, cv::Mat1f* values) const {
  check_maps(*tables_, area, positions, values);
  const auto channels = static_cast<size_t>(tables_->channels());
  std::vector<int> all(channels);
  for (size_t c = 0; c < channels; ++c) all[c] = static_cast<int>(c);
  std::vector<double> means(channels);
  for (int row = 0; row < area.height; ++row) {
    for (int column = 0; column < area.width; ++column) {
      const double x = static_cast<double>(area.x) + column + 0.5;
      const double y = static_cast<double>(area.y) + row + 0.5;
      detail::reference_point(*tables_, x, y, all, means);
      for (size_t t = 0; t < positions.size(); ++t)
        positions[t](row, column) = {static_cast<float>(x + means[2 * t]), static_cast<float>(y + means[2 * t + 1])};
      if (values != nullptr) (*values)(row, column) = static_cast<float>(tables_->value_from_channel(means.back()));
    }
  }
}

}  // namespace morphkit::warp
