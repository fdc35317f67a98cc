#include "warp/sample/sample.h"

#include <cassert>
#include <stdexcept>

#include "base/parallel.h"
#include "warp/sample/antialias.h"
#include "warp/sample/filters.h"
#include "warp/sample/reconstruct.h"

namespace morphkit::warp {
namespace {

detail::Kernel kernel_of(Filter filter) {
  if (filter == Filter::kNearest) return detail::Kernel::kNearest;
  return filter == Filter::kBilinear ? detail::Kernel::kBilinear : detail::Kernel::kBicubic;
}

}  // namespace

void sample_band(const Image& source, const Map& positions, const SampleOptions& options, Image& out) noexcept {
  assert(!source.empty());
  assert(positions.size() == out.size());
  if (detail::AntialiasingFilters::contains(options.filter)) {
    return detail::antialias_band(source, positions, options.filter, options.border, out);
  }
  const auto width = static_cast<std::size_t>(positions.cols);
  for (int y = 0; y < positions.rows; ++y)
    detail::reconstruct_row(source, {positions[y], width}, kernel_of(options.filter), options.border, {out[y], width});
}

Image sample(const Image& source, const Map& map, const SampleOptions& options) {
  if (source.empty()) throw std::invalid_argument("sample: the source is empty");
  if (map.empty()) throw std::invalid_argument("sample: the map is empty");
  Image result(map.size());
  for_rows(
      map.rows,
      [&](int begin, int end) {
        Image band = result.rowRange(begin, end);
        sample_band(source, map.rowRange(begin, end), options, band);
      },
      kSampleBand);
  return result;
}

}  // namespace morphkit::warp
