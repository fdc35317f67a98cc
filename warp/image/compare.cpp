#include "warp/image/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "warp/image/color.h"

namespace morphkit::warp {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_finite(const Pixel& pixel) noexcept {
  return std::isfinite(pixel[0]) && std::isfinite(pixel[1]) && std::isfinite(pixel[2]) && std::isfinite(pixel[3]);
}

void require_equal_sizes(const Image& a, const Image& b) {
  if (a.size() == b.size()) return;
  const auto text = [](const Image& image) { return std::to_string(image.cols) + "x" + std::to_string(image.rows); };
  throw std::invalid_argument("compare: sizes differ: " + text(a) + " and " + text(b));
}

struct RowDifference {
  double squared_sum = 0;
  double max_abs = 0;
  int worst_x = -1;
  std::int64_t differing = 0;
  std::int64_t nonfinite = 0;
};

void add_pixel(RowDifference& row, int x, const Pixel& a, const Pixel& b) noexcept {
  double pixel_max = kInfinity;
  if (is_finite(a) && is_finite(b)) {
    if (a == b) return;
    const Pixel difference = comparison_value(a) - comparison_value(b);
    pixel_max = 0;
    for (int c = 0; c < 4; ++c) {
      const double value = std::abs(static_cast<double>(difference[c]));
      row.squared_sum += value * value;
      pixel_max = std::max(pixel_max, value);
    }
  } else {
    ++row.nonfinite;
  }
  ++row.differing;
  if (row.worst_x < 0 || pixel_max > row.max_abs) {
    row.max_abs = pixel_max;
    row.worst_x = x;
  }
}

double psnr(double squared_sum, std::int64_t channels, const Difference& result) {
  if (result.nonfinite > 0) return -kInfinity;
  if (squared_sum == 0) return kInfinity;
  return -10 * std::log10(squared_sum / static_cast<double>(channels));
}

}  // namespace

Pixel comparison_value(const Pixel& pixel) noexcept {
  return {srgb_from_linear(pixel[0]), srgb_from_linear(pixel[1]), srgb_from_linear(pixel[2]), pixel[3]};
}

Difference compare(const Image& a, const Image& b) {
  require_equal_sizes(a, b);
  std::vector<RowDifference> rows(static_cast<std::size_t>(a.rows));
  for_rows(a.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < a.cols; ++x) add_pixel(rows[static_cast<std::size_t>(y)], x, a(y, x), b(y, x));
    }
  });
  // Rows are summed in order, no matter which thread computed them: floating-point sums depend on the order.
  Difference result;
  double squared_sum = 0;
  for (int y = 0; y < a.rows; ++y) {
    const RowDifference& row = rows[static_cast<std::size_t>(y)];
    squared_sum += row.squared_sum;
    result.differing += row.differing;
    result.nonfinite += row.nonfinite;
    if (row.worst_x >= 0 && (result.worst.x < 0 || row.max_abs > result.max_abs)) {
      result.max_abs = row.max_abs;
      result.worst = {row.worst_x, y};
    }
  }
  result.psnr_db = psnr(squared_sum, static_cast<std::int64_t>(a.total()) * 4, result);
  return result;
}

Image difference_image(const Image& a, const Image& b, double gain) {
  require_equal_sizes(a, b);
  Image out(a.size());
  for_rows(a.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < a.cols; ++x) {
        if (!is_finite(a(y, x)) || !is_finite(b(y, x))) {
          out(y, x) = {1, 0, 1, 1};
          continue;
        }
        const Pixel difference = comparison_value(a(y, x)) - comparison_value(b(y, x));
        for (int c = 0; c < 3; ++c) {
          const double value = gain * std::max(std::abs(difference[c]), std::abs(difference[3]));
          out(y, x)[c] = linear_from_srgb(static_cast<float>(std::min(value, 1.0)));
        }
        out(y, x)[3] = 1;
      }
    }
  });
  return out;
}

}  // namespace morphkit::warp
