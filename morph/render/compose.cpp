#include "morph/render/compose.h"

#include <span>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "morph/render/dissolve.h"
#include "warp/image/image_pool.h"

namespace morphkit::render {
namespace {

std::span<warp::Pixel> row_of(warp::Image& image, int y) {
  return {image[y], static_cast<std::size_t>(image.cols)};
}

/// Draws bands of a frame for methods that sample at positions.
class BandComposer {
 public:
  BandComposer(const Stage& stage, const Warper& warper, warp::Filter filter, project::Blend blend)
      : stage_(stage), warper_(warper), dissolve_(warper.dissolve()), filter_(filter), blend_(blend) {}

  void mixed(int top, warp::Image& out) const {
    Scratch& scratch = positions(top, out.size(), dissolve_.is_local());
    if (!dissolve_.shows(kSource)) return sample(kDestination, scratch, out);
    sample(kSource, scratch, out);
    if (!dissolve_.shows(kDestination)) return;
    scratch.pixels.create(out.size());
    sample(kDestination, scratch, scratch.pixels);
    const auto whole = static_cast<float>(dissolve_.least);
    const auto width = static_cast<std::size_t>(out.cols);
    for (int y = 0; y < out.rows; ++y) {
      const std::span<const float> alpha =
          dissolve_.is_local() ? std::span<const float>(scratch.dissolve[y], width) : std::span(&whole, 1);
      dissolve_row(row_of(out, y), row_of(scratch.pixels, y), alpha, blend_);
    }
  }

  void alone(SideIndex side, int top, warp::Image& out) const { sample(side, positions(top, out.size(), false), out); }

 private:
  /// Kept from band to band; only their sizes matter between uses.
  struct Scratch {
    std::vector<warp::Map> maps;
    warp::Image pixels;
    cv::Mat1f dissolve;
  };

  Scratch& positions(int top, cv::Size band, bool with_dissolve) const {
    thread_local Scratch scratch;
    scratch.maps.resize(stage_.sides.size());
    for (warp::Map& map : scratch.maps) map.create(band);
    if (with_dissolve) scratch.dissolve.create(band);
    warper_.positions(top, scratch.maps, Pixels::kHeld, with_dissolve ? &scratch.dissolve : nullptr);
    return scratch;
  }

  void sample(SideIndex side, const Scratch& scratch, warp::Image& out) const {
    const StageSide& picture = stage_.sides[side];
    warp::sample_band(picture.image, scratch.maps[side], {filter_, picture.border}, out);
  }

  const Stage& stage_;
  const Warper& warper_;
  DissolveRange dissolve_;
  warp::Filter filter_;
  project::Blend blend_;
};

/// An image of the stage's size, drawn in bands by draw(top, band).
template <typename Draw>
warp::Image in_bands(const Stage& stage, const Draw& draw) {
  warp::Image out = warp::pooled_image(stage.size);
  for_rows(
      out.rows,
      [&](int begin, int end) {
        warp::Image band = out.rowRange(begin, end);
        draw(begin, band);
      },
      warp::kSampleBand);
  return out;
}

/// Mixes whole pictures, in place of `source`.
void mix(warp::Image& source, warp::Image& destination, const Warper& warper, project::Blend blend) {
  const DissolveRange dissolve = warper.dissolve();
  const auto whole = static_cast<float>(dissolve.least);
  const auto columns = static_cast<std::size_t>(source.cols);
  for_rows(source.rows, [&](int begin, int end) {
    std::vector<float> alpha(dissolve.is_local() ? columns : 1, whole);
    for (int y = begin; y < end; ++y) {
      if (dissolve.is_local()) warper.dissolve_row(y, alpha);
      dissolve_row(row_of(source, y), row_of(destination, y), alpha, blend);
    }
  });
}

}  // namespace

warp::Image compose(const Stage& stage, const Warper& warper, warp::Filter filter, project::Blend blend) {
  const DissolveRange dissolve = warper.dissolve();
  std::optional<warp::Image> drawn = warper.drawn(dissolve.shows(kSource) ? kSource : kDestination);
  if (!drawn) {
    const BandComposer bands(stage, warper, filter, blend);
    return in_bands(stage, [&](int top, warp::Image& band) { bands.mixed(top, band); });
  }
  if (dissolve.shows(kSource) && dissolve.shows(kDestination)) {
    warp::Image other = *warper.drawn(kDestination);
    mix(*drawn, other, warper, blend);
  }
  return *std::move(drawn);
}

warp::Image draw_side(const Stage& stage, const Warper& warper, SideIndex side, warp::Filter filter) {
  if (std::optional<warp::Image> drawn = warper.drawn(side)) return *std::move(drawn);
  const BandComposer bands(stage, warper, filter, project::Blend::kLinear);
  return in_bands(stage, [&](int top, warp::Image& band) { bands.alone(side, top, band); });
}

void sample_side(const StageSide& side, const warp::Map& map, warp::Filter filter, warp::Image& out) {
  for_rows(
      out.rows,
      [&](int begin, int end) {
        warp::Image band = out.rowRange(begin, end);
        warp::sample_band(side.image, map.rowRange(begin, end), {filter, side.border}, band);
      },
      warp::kSampleBand);
}

void lay_over(warp::Image& image, const warp::Image& behind) {
  if (behind.empty()) return;
  for_rows(image.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const int row = behind.rows == 1 ? 0 : y;
      over_row(row_of(image, y), {behind[row], static_cast<std::size_t>(behind.cols)});
    }
  });
}

}  // namespace morphkit::render
