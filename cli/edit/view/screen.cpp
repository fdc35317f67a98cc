#include "cli/edit/view/screen.h"

#include <cstdint>
#include <span>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "base/parallel.h"
#include "warp/image/color_rows.h"

namespace morphkit::edit {
namespace {

constexpr int kCheckPx = 8;
constexpr float kChecks[] = {0.09F, 0.15F};  // linear light

/// @return the row as it is if it is opaque, else over the checkerboard, in `scratch`.
std::span<const warp::Pixel> over_checks(std::span<const warp::Pixel> row, int y, std::vector<warp::Pixel>& scratch) {
  bool opaque = true;
  for (const warp::Pixel& pixel : row) opaque &= pixel[3] >= 1;
  if (opaque) return row;
  scratch.assign(row.begin(), row.end());
  for (std::size_t x = 0; x < scratch.size(); ++x) {
    const bool light = ((x / kCheckPx) + static_cast<std::size_t>(y / kCheckPx)) % 2 == 1;
    const float behind = kChecks[light ? 1 : 0] * (1 - scratch[x][3]);
    scratch[x] += warp::Pixel(behind, behind, behind, 1 - scratch[x][3]);
  }
  return scratch;
}

}  // namespace

cv::Mat3b to_screen(const warp::Image& image) {
  cv::Mat3b screen(image.size());
  for_rows(image.rows, [&](int begin, int end) {
    std::vector<warp::Pixel> scratch;
    for (int y = begin; y < end; ++y) {
      const auto row = over_checks({image[y], static_cast<std::size_t>(image.cols)}, y, scratch);
      warp::srgb_codes<std::uint8_t>(row, 3, screen[y]->val);
    }
    cv::Mat3b band = screen.rowRange(begin, end);
    cv::cvtColor(band, band, cv::COLOR_RGB2BGR);
  });
  return screen;
}

}  // namespace morphkit::edit
