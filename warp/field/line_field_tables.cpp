#include "warp/field/line_field_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace morphkit::warp::detail {
namespace {

/// A shorter line counts as a point: double coordinates do not hold its direction.
constexpr double kPointLengthPx = 1e-9;
/// Squares of coordinates and of their ratios must stay far from overflow.
constexpr double kCoordinateLimitPx = 1e9;

[[noreturn]] void reject(size_t index, const std::string& what) {
  throw std::invalid_argument("LineField: line " + std::to_string(index) + ": " + what);
}

bool coordinates_ok(const Line& line) {
  // In this form NaN fails.
  return std::abs(line.p.x) <= kCoordinateLimitPx && std::abs(line.p.y) <= kCoordinateLimitPx &&
         std::abs(line.q.x) <= kCoordinateLimitPx && std::abs(line.q.y) <= kCoordinateLimitPx;
}

void validate(const FieldLine& line, size_t index, int targets) {
  const auto& [a, b, p, unit] = line.weight;
  if (line.targets.size() != static_cast<size_t>(targets)) {
    reject(index, "has " + std::to_string(line.targets.size()) + " targets, expected " + std::to_string(targets));
  }
  if (!coordinates_ok(line.output) || !std::all_of(line.targets.begin(), line.targets.end(), coordinates_ok)) {
    reject(index, "coordinates must be finite and within 1e9 px");
  }
  if (!(a >= 0 && a <= kCoordinateLimitPx)) reject(index, "a = " + std::to_string(a) + " must lie in [0, 1e9]");
  if (!(b >= 0 && b <= 8)) reject(index, "b = " + std::to_string(b) + " must lie in [0, 8]");
  if (!(p >= 0 && p <= 1)) reject(index, "p = " + std::to_string(p) + " must lie in [0, 1]");
  if (!(unit >= 1e-6 && unit <= 1e6)) reject(index, "unit = " + std::to_string(unit) + " must lie in [1e-6, 1e6]");
  if (!(std::abs(line.value) <= std::numeric_limits<float>::max())) reject(index, "value must be finite as a float");
}

double length_of(const Line& line) {
  const cv::Point2d d = line.q - line.p;
  return std::hypot(d.x, d.y);
}

bool is_point(const Line& line) {
  return length_of(line) < kPointLengthPx;
}

WeightKind kind_of(double b) {
  if (b == 1) return WeightKind::kOne;
  if (b == 1.5) return WeightKind::kOneAndHalf;
  if (b == 2) return WeightKind::kTwo;
  return WeightKind::kAny;
}

int round_up(int count) {
  return (count + kLineChunk - 1) / kLineChunk * kLineChunk;
}

}  // namespace

FieldTables::FieldTables(std::span<const FieldLine> lines, int targets)
    : targets_(targets), lines_(static_cast<int>(lines.size())) {
  if (targets < 1) {
    throw std::invalid_argument("LineField: " + std::to_string(targets) + " targets, expected at least 1");
  }
  for (size_t i = 0; i < lines.size(); ++i) validate(lines[i], i, targets);
  std::vector<int> place(lines.size());
  reserve_places(lines, place);
  for (size_t i = 0; i < lines.size(); ++i) fill(lines[i], place[i]);
  fill_values(lines, place);
  normalise_factors(place);
  fill_singles();
}

/// Sorts the lines by kind and fills every entry with a line of weight 0.
void FieldTables::reserve_places(std::span<const FieldLine> lines, std::vector<int>& place) {
  wide_range_ = std::any_of(lines.begin(), lines.end(), [](const FieldLine& line) { return line.weight.b > 2; });
  for (const WeightKind kind : {WeightKind::kOne, WeightKind::kOneAndHalf, WeightKind::kTwo, WeightKind::kAny}) {
    LineGroup group{kind, padded_, 0};
    for (size_t i = 0; i < lines.size(); ++i) {
      const WeightKind own = wide_range_ ? WeightKind::kAny : kind_of(lines[i].weight.b);
      if (own == kind) place[i] = group.begin + group.count++;
    }
    if (group.count > 0) groups_.push_back(group);
    padded_ += round_up(group.count);
  }
  const auto padded = static_cast<size_t>(padded_);
  for (auto* array : {&origin_x, &origin_y, &along_y, &length, &b, &factor, &root}) array->assign(padded, 0.0);
  along_x.assign(padded, 1.0);
  a.assign(padded, 1.0);
  log2_factor.assign(padded, -std::numeric_limits<double>::infinity());
  for (auto* array : {&at_, &slope_x_, &slope_y_}) array->assign(padded * static_cast<size_t>(channels()), 0.0);
}

void FieldTables::fill(const FieldLine& line, int place) {
  const auto i = static_cast<size_t>(place);
  const cv::Point2d d = line.output.q - line.output.p;
  const bool point = is_point(line.output);
  const double size = point ? 0.0 : length_of(line.output);
  origin_x[i] = line.output.p.x;
  origin_y[i] = line.output.p.y;
  along_x[i] = point ? 1.0 : d.x / size;
  along_y[i] = point ? 0.0 : d.y / size;
  length[i] = size;
  // ((unit length)^p / (a + unit dist))^b, with the factors that do not depend on the pixel taken out.
  const auto& [weight_a, weight_b, weight_p, unit] = line.weight;
  a[i] = weight_a / unit;
  b[i] = weight_b;
  log2_factor[i] = weight_b * ((point ? 0.0 : weight_p * std::log2(size * unit)) - std::log2(unit));
  for (int t = 0; t < targets_; ++t) {
    fill_target(line.output, line.targets[static_cast<size_t>(t)], line.scale, 2 * t, place);
  }
}

/// The displacement X' - X = (P' - P) + (M - I)(X - P), Beier and Neely 1992, sec. 3.1, with
///     M = (d' d^T + s perp(d') perp(d)^T) / |d|^2, s = |d| / |d'| along (the paper), 1 uniform (Parent 3.8.2). M - I
/// is formed from differences of d' and d, never from M, so equal lines displace by exactly 0:
///     M - I = ((d' - d) d^T + perp(t) perp(d)^T),   t = s d' - d, both over |d|^2.
void FieldTables::fill_target(const Line& output, const Line& target, LineScale scale, int channel, int place) {
  const size_t x = static_cast<size_t>(channel) * padded_ + static_cast<size_t>(place);
  const size_t y = x + static_cast<size_t>(padded_);
  if (is_point(output) || is_point(target)) {
    // A point pair, or a line that turns through length 0 and has no direction: the displacement of its midpoint.
    const cv::Point2d shift = 0.5 * ((target.p - output.p) + (target.q - output.q));
    at_[x] = shift.x;
    at_[y] = shift.y;
    return;
  }
  const cv::Point2d d = output.q - output.p;
  const cv::Point2d d_target = target.q - target.p;
  const cv::Point2d stretch = d_target - d;
  const double squared = d.dot(d);
  const double across = scale == LineScale::kUniform ? squared : std::sqrt(squared * d_target.dot(d_target));
  const cv::Point2d along{d.x / squared, d.y / squared};
  const cv::Point2d t{d_target.x / across - along.x, d_target.y / across - along.y};
  at_[x] = target.p.x - output.p.x;
  at_[y] = target.p.y - output.p.y;
  slope_x_[x] = stretch.x * along.x + t.y * d.y;
  slope_y_[x] = stretch.x * along.y - t.y * d.x;
  slope_x_[y] = stretch.y * along.x - t.x * d.y;
  slope_y_[y] = stretch.y * along.y + t.x * d.x;
}

void FieldTables::fill_values(std::span<const FieldLine> lines, std::span<const int> place) {
  if (lines.empty()) return;
  const auto [least, most] = std::minmax_element(
      lines.begin(), lines.end(), [](const FieldLine& l, const FieldLine& r) { return l.value < r.value; });
  value_min_ = least->value;
  value_range_ = most->value - least->value;
  if (value_range_ == 0) return;
  const size_t base = static_cast<size_t>(value_channel()) * padded_;
  for (size_t i = 0; i < lines.size(); ++i) {
    at_[base + static_cast<size_t>(place[i])] = kValueChannelRange * ((lines[i].value - value_min_) / value_range_);
  }
}

/// Only ratios of weights matter, so the largest length factor becomes 1.
void FieldTables::normalise_factors(std::span<const int> place) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const int i : place) largest = std::max(largest, log2_factor[static_cast<size_t>(i)]);
  for (const int p : place) {
    const auto i = static_cast<size_t>(p);
    log2_factor[i] -= largest;
    factor[i] = std::exp2(log2_factor[i]);
    root[i] = b[i] > 0 ? std::exp2(log2_factor[i] / b[i]) : 1.0;
  }
}

void FieldTables::fill_singles() {
  const auto single = [](double value) { return static_cast<float>(value); };
  for (size_t i = 0; i < static_cast<size_t>(padded_); ++i) {
    along_x_single.push_back(single(along_x[i]));
    along_y_single.push_back(single(along_y[i]));
    a_single.push_back(single(a[i]));
    root_single.push_back(single(root[i]));
    power_single.push_back(single(-b[i]));
    scale_single.push_back(single(std::max(log2_factor[i], kLeastLog2)));
    double smooth = 1;
    for (int j = 0; j < kFieldNodes; ++j) smooth *= (b[i] + j) / (j + 1);
    smooth_single.push_back(single(smooth));
  }
}

const NodeTable& node_table() {
  static const NodeTable table = [] {
    NodeTable nodes{};
    constexpr int kMiddlePixel = kFieldTile / 2;
    constexpr double kMiddle = -0.5, kHalfWidth = (kFieldTile - 1) / 2.0;
    double offset[kFieldNodes];
    for (int j = 0; j < kFieldNodes; ++j) {
      // The polynomials belong to the nodes as rounded to float.
      nodes.offset[j] =
          static_cast<float>(kMiddle + kHalfWidth * std::cos((2 * j + 1) * std::numbers::pi / (2 * kFieldNodes)));
      offset[j] = static_cast<double>(nodes.offset[j]);
    }
    for (int j = 0; j < kFieldNodes; ++j) {
      for (int k = 0; k < kFieldTile; ++k) {
        double product = 1;
        for (int other = 0; other < kFieldNodes; ++other) {
          if (other != j) product *= (k - kMiddlePixel - offset[other]) / (offset[j] - offset[other]);
        }
        nodes.basis[j][k] = static_cast<float>(product);
      }
    }
    return nodes;
  }();
  return table;
}

}  // namespace morphkit::warp::detail
