// A mountain lake at noon.

#include <algorithm>
#include <cmath>

#include "samples/pictures.h"

namespace morphkit::samples {
namespace {

constexpr float kShore = 430;  // where the water begins
const Point kSun{960, 140};

const Path kFarRidge{{-20, 330}, {90, 270},  {170, 300}, {300, 190},  {380, 250},  {450, 205}, {560, 300},
                     {690, 240}, {800, 320}, {930, 270}, {1050, 330}, {1180, 290}, {1300, 340}};
const Path kNearRidge{{-20, 400}, {120, 372}, {260, 392},  {420, 350},  {560, 388},
                      {720, 402}, {880, 366}, {1040, 352}, {1180, 384}, {1300, 360}};

/// A ridge down to the shore, as an outline.
Path below(Path ridge) {
  ridge.push_back({1300, kShore});
  ridge.push_back({-20, kShore});
  return ridge;
}

/// Breaks the straight pieces of a ridge into rock.
Path rough(const Path& ridge, float height_px, std::uint32_t seed) {
  Path result;
  for (std::size_t i = 0; i + 1 < ridge.size(); ++i)
    for (int k = 0; k < 24; ++k) {
      const Point p = ridge[i] + (ridge[i + 1] - ridge[i]) * (static_cast<float>(k) / 24);
      result.push_back(p + Point(0, (fractal_noise(Point(p.x * 0.05F, 7), 4, seed) - 0.5F) * height_px));
    }
  result.push_back(ridge.back());
  return result;
}

void paint_sky(Canvas& canvas) {
  canvas.wash([](Point p) {
    const float high = std::clamp(p.y / kShore, 0.0F, 1.0F);
    Color c = ramp(high, rgb(0x2f74b8), rgb(0x7fb4de), rgb(0xe4eef0));
    const float glare = std::exp(-std::hypot(p.x - kSun.x, p.y - kSun.y) / 190);
    c = mix(c, rgb(0xfff6d8), 0.75F * glare);
    const float cloud = fractal_noise(Point(p.x * 0.0042F, p.y * 0.011F), 5, 12);
    c = mix(c, rgb(0xfdfdfb), smooth_step(0.52F, 0.74F, cloud) * smooth_step(400, 90, p.y) * 0.9F);
    return cv::Vec4f(c[0], c[1], c[2], 1);
  });
  canvas.glow(kSun, 34, 34, rgb(0xfff3c4), {.opacity = 0.9F});
  canvas.fill(ellipse(kSun, 46, 46), rgb(0xfffbe6), {.soften_px = 1});
}

void paint_mountains(Canvas& canvas) {
  const Mask far = canvas.mask(below(rough(kFarRidge, 26, 31)), 0.6F);
  canvas.shade(far, [](Point p) {
    const float facet = fractal_noise(Point(p.x * 0.022F - p.y * 0.016F, p.y * 0.009F), 5, 41);
    const Color rock = ramp(facet * 1.5F - 0.25F, rgb(0x4a5f7d), rgb(0x7488a2), rgb(0xa9b6c4));
    const float snow_line = 262 + 90 * (fractal_noise(Point(p.x * 0.03F, p.y * 0.03F), 4, 51) - 0.5F);
    const Color snow = ramp(facet * 1.6F - 0.2F, rgb(0xa5bbd6), rgb(0xe6edf4), rgb(0xffffff));
    const Color c = mix(rock, snow, smooth_step(snow_line + 14, snow_line - 14, p.y));
    return mix(c, rgb(0xc4d6e4), 0.45F * smooth_step(260, kShore, p.y));
  });
  const Mask near = canvas.mask(below(rough(kNearRidge, 15, 61)), 0.6F);
  canvas.shade(near, [](Point p) {
    const float wood = fractal_noise(Point(p.x * 0.11F, p.y * 0.07F), 4, 71);
    const Color c = ramp(wood * 1.5F - 0.3F, rgb(0x1f3d36), rgb(0x35614c), rgb(0x648c5c));
    return mix(c, rgb(0x9fbcc0), 0.35F * smooth_step(430, 350, p.y));
  });
}

/// The lake mirrors the scene above it, broken by ripples.
void paint_water(Canvas& canvas) {
  const cv::Mat4b above = canvas.to_8bit();
  const Mask water = canvas.mask({{-5, kShore}, {1285, kShore}, {1285, 725}, {-5, 725}}, 0.5F);
  canvas.shade(water, [&](Point p) {
    const float depth = p.y - kShore;
    const float ripple = fractal_noise(Point(p.x * 0.012F, p.y * 0.16F - depth * depth * 0.0002F), 3, 81) - 0.5F;
    const float y = kShore - depth * 1.15F + ripple * (6 + depth * 0.12F);
    const float x = p.x + ripple * (4 + depth * 0.06F);
    const cv::Vec4b& seen =
        above(std::clamp(static_cast<int>(y), 0, above.rows - 1), std::clamp(static_cast<int>(x), 0, above.cols - 1));
    const Color mirror = Color(seen[0], seen[1], seen[2]) / 255.0F;
    const Color deep = ramp(depth / 300, rgb(0x5f95ac), rgb(0x2f6f8f), rgb(0x174c66));
    return mix(mirror, deep, 0.30F + 0.0011F * depth + 0.25F * ripple);
  });
  canvas.stroke({{-10, kShore}, {640, kShore}, {1290, kShore}}, {2, 2.5F, 2}, rgb(0xd9e6e2),
                {.opacity = 0.5F, .soften_px = 1});
}

void paint_meadow(Canvas& canvas, Dice& dice) {
  const Path bank =
      smooth({{-20, 560}, {120, 590}, {300, 606}, {480, 640}, {700, 662}, {930, 668}, {1120, 650}, {1300, 612}});
  const Mask meadow = canvas.mask(joined(bank, {{1300, 740}, {-20, 740}}), 1);
  canvas.shade(meadow, [](Point p) {
    const float patch = fractal_noise(Point(p.x * 0.02F, p.y * 0.05F), 4, 91);
    return ramp(patch * 1.3F - 0.1F, rgb(0x27441f), rgb(0x557a2d), rgb(0x9aac4c));
  });
  for (int blade = 0; blade < 2600; ++blade) {
    const Point root(dice.between(-10, 1290), dice.between(596, 730));
    if (meadow.at(static_cast<int>(root.x), static_cast<int>(root.y)) < 0.5F) continue;
    const float height = dice.between(8, 12) + (root.y - 590) * 0.12F;
    const float lean = dice.between(-6, 6);
    canvas.stroke({root, root + Point(lean * 0.4F, -height * 0.6F), root + Point(lean, -height)}, {1.6F, 1.4F, 0.3F},
                  mix(rgb(0x2c4c1f), rgb(0xb4c468), dice.between(0, 1)), {.opacity = 0.7F});
  }
  const Color petals[] = {rgb(0xf3ead2), rgb(0xe7b23c), rgb(0xc45a6a)};
  for (int flower = 0; flower < 170; ++flower) {
    const Point c(dice.between(0, 1280), dice.between(580, 716));
    if (meadow.at(static_cast<int>(c.x), static_cast<int>(c.y) - 6) < 0.5F) continue;
    const float size = 1.5F + (c.y - 600) * 0.022F;
    canvas.fill(ellipse(c, size, size * 0.8F), petals[flower % 3], {.opacity = 0.95F, .soften_px = 0.4F});
  }
}

/// A spruce from its foot at (250, 632) to its tip at (250, 190).
void paint_spruce(Canvas& canvas, Dice& dice) {
  canvas.glow({262, 634}, 66, 11, rgb(0x16240f), {.opacity = 0.6F});
  canvas.stroke({{250, 200}, {250, 420}, {250, 636}}, {2, 9, 19}, rgb(0x3d2a1c), {.soften_px = 0.5F});
  for (int layer = 0; layer < 30; ++layer) {
    const float t = static_cast<float>(layer) / 29;
    const float y = 196 + 390 * t;
    const float reach = 8 + 64 * std::pow(t, 0.85F);
    const int twigs = 10 + static_cast<int>(26 * t);
    for (int twig = 0; twig < twigs; ++twig) {
      const float side = dice.between(-1, 1);
      const Point root(250 + side * reach * 0.1F, y + dice.between(-8, 8));
      const Point tip(250 + side * reach * dice.between(0.82F, 1.0F),
                      root.y + 16 + 18 * t * std::abs(side) + dice.between(-5, 5));
      const Point middle = (root + tip) / 2.0F + Point(0, 3 - 9 * t);
      const float lit = std::clamp(0.42F + 0.38F * side + dice.between(-0.25F, 0.25F), 0.0F, 1.0F);
      canvas.stroke(smooth({root, middle, tip}), {3 + 4 * t, 6 + 7 * t, 1},
                    ramp(lit, rgb(0x0f2418), rgb(0x234a2c), rgb(0x5d8444)), {.opacity = 0.92F, .soften_px = 0.6F});
    }
  }
}

}  // namespace

Canvas paint_lake() {
  Canvas canvas(1280, 720);
  Dice dice(2024);
  paint_sky(canvas);
  paint_mountains(canvas);
  paint_water(canvas);
  paint_meadow(canvas, dice);
  paint_spruce(canvas, dice);
  return canvas;
}

}  // namespace morphkit::samples
