#include "morph/render/compose.h"

#include <algorithm>
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

/// The weights of each picture but the first along a row: one value if all pixels are alike.
using WeightRows = std::vector<std::span<const float>>;

/// The weights of the picture `side` in a mix with those before it. @pre side > 0. @param scratch  may hold it.
std::span<const float> shares(SideIndex side, const WeightRows& weights, std::vector<float>& scratch) {
  if (side == weights.size()) return weights.back();
  scratch.resize(weights.front().size());
  for (std::size_t i = 0; i < scratch.size(); ++i) {
    float rest = 1;
    for (SideIndex later = side; later < weights.size(); ++later) rest -= weights[later][i];
    scratch[i] = rest > 0 ? std::min(1.0F, weights[side - 1][i] / rest) : 0;
  }
  return scratch;
}

bool is_local(const Warper& warper) {
  return std::ranges::any_of(warper.weights(), &WeightRange::is_local);
}

/// The weights of each picture but the first, if they are alike everywhere.
std::vector<float> uniform_weights(const Warper& warper) {
  std::vector<float> weights;
  for (SideIndex side = 1; side < warper.weights().size(); ++side)
    weights.push_back(static_cast<float>(warper.weights()[side].least));
  return weights;
}

WeightRows rows_of(const std::vector<float>& uniform) {
  WeightRows rows;
  for (const float& weight : uniform) rows.emplace_back(&weight, 1);
  return rows;
}

/// The first picture that shows, which the others are mixed onto.
SideIndex bottom_of(const Warper& warper) {
  return static_cast<SideIndex>(std::ranges::find_if(warper.weights(), &WeightRange::shows) - warper.weights().begin());
}

/// Draws bands of a frame for methods that sample at positions.
class BandComposer {
 public:
  BandComposer(const Stage& stage, const Warper& warper, warp::Filter filter, project::Blend blend)
      : stage_(stage),
        warper_(warper),
        local_(is_local(warper)),
        uniform_(uniform_weights(warper)),
        filter_(filter),
        blend_(blend) {}

  void mixed(int top, warp::Image& out) const {
    Scratch& scratch = positions(top, out.size(), local_);
    const SideIndex bottom = bottom_of(warper_);
    sample(bottom, scratch, out);
    WeightRows rows = rows_of(uniform_);
    for (SideIndex side = bottom + 1; side < stage_.sides.size(); ++side) {
      if (!warper_.weights()[side].shows()) continue;
      scratch.pixels.create(out.size());
      sample(side, scratch, scratch.pixels);
      for (int y = 0; y < out.rows; ++y) {
        for (std::size_t i = 0; i < scratch.weights.size(); ++i)
          rows[i] = {scratch.weights[i][y], static_cast<std::size_t>(out.cols)};
        dissolve_row(row_of(out, y), row_of(scratch.pixels, y), shares(side, rows, scratch.shares), blend_);
      }
    }
  }

  void alone(SideIndex side, int top, warp::Image& out) const { sample(side, positions(top, out.size(), false), out); }

 private:
  /// Kept from band to band; only their sizes matter between uses.
  struct Scratch {
    std::vector<warp::Map> maps;
    warp::Image pixels;
    std::vector<cv::Mat1f> weights;  ///< none if they are uniform
    std::vector<float> shares;
  };

  Scratch& positions(int top, cv::Size band, bool with_weights) const {
    thread_local Scratch scratch;
    scratch.maps.resize(stage_.sides.size());
    for (warp::Map& map : scratch.maps) map.create(band);
    scratch.weights.resize(with_weights ? stage_.sides.size() - 1 : 0);
    for (cv::Mat1f& weights : scratch.weights) weights.create(band);
    warper_.positions(top, scratch.maps, Pixels::kHeld, scratch.weights);
    return scratch;
  }

  void sample(SideIndex side, const Scratch& scratch, warp::Image& out) const {
    const StageSide& picture = stage_.sides[side];
    warp::sample_band(picture.image, scratch.maps[side], {filter_, picture.border}, out);
  }

  const Stage& stage_;
  const Warper& warper_;
  bool local_;
  std::vector<float> uniform_;
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

/// Mixes a whole picture onto those before it.
void mix(warp::Image& image, warp::Image& picture, SideIndex side, const Warper& warper, project::Blend blend) {
  const bool local = is_local(warper);
  const std::vector<float> uniform = uniform_weights(warper);
  for_rows(image.rows, [&](int begin, int end) {
    WeightRows rows = rows_of(uniform);
    std::vector<std::vector<float>> weights(local ? rows.size() : 0,
                                            std::vector<float>(static_cast<std::size_t>(image.cols)));
    std::vector<float> scratch;
    for (int y = begin; y < end; ++y) {
      for (std::size_t i = 0; i < weights.size(); ++i) {
        warper.weight_row(i + 1, y, weights[i]);
        rows[i] = weights[i];
      }
      dissolve_row(row_of(image, y), row_of(picture, y), shares(side, rows, scratch), blend);
    }
  });
}

}  // namespace

warp::Image compose(const Stage& stage, const Warper& warper, warp::Filter filter, project::Blend blend) {
  const SideIndex bottom = bottom_of(warper);
  std::optional<warp::Image> drawn = warper.drawn(bottom);
  if (!drawn) {
    const BandComposer bands(stage, warper, filter, blend);
    return in_bands(stage, [&](int top, warp::Image& band) { bands.mixed(top, band); });
  }
  for (SideIndex side = bottom + 1; side < stage.sides.size(); ++side) {
    if (!warper.weights()[side].shows()) continue;
    warp::Image other = *warper.drawn(side);
    mix(*drawn, other, side, warper, blend);
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

void composite_over(warp::Image& image, const warp::Image& behind) {
  if (behind.empty()) return;
  for_rows(image.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const int row = behind.rows == 1 ? 0 : y;
      over_row(row_of(image, y), {behind[row], static_cast<std::size_t>(behind.cols)});
    }
  });
}

}  // namespace morphkit::render
