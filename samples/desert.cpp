// A desert after sunset, with the moon up.

#include <algorithm>
#include <cmath>

#include "samples/pictures.h"

namespace morphkit::samples {
namespace {

constexpr float kHorizon = 450;
const Point kMoon{720, 236};

void paint_sky(Canvas& canvas, Dice& dice) {
  canvas.wash([](Point p) {
    const float high = std::clamp(p.y / kHorizon, 0.0F, 1.0F);
    Color c = ramp(std::pow(high, 1.5F), rgb(0x10163a), rgb(0x53387a), rgb(0xf08a54));
    const float streak = fractal_noise(Point(p.x * 0.004F, p.y * 0.022F), 4, 5);
    c = mix(c, rgb(0xf7a98a), smooth_step(0.55F, 0.75F, streak) * smooth_step(250, 420, p.y) * 0.7F);
    c = mix(c, rgb(0xcfd2f2), 0.5F * std::exp(-std::hypot(p.x - kMoon.x, p.y - kMoon.y) / 95));
    return cv::Vec4f(c[0], c[1], c[2], 1);
  });
  for (int star = 0; star < 330; ++star) {
    const Point c(dice.between(0, 960), dice.between(0, 350));
    const float size = dice.between(0.4F, 1.5F);
    canvas.glow(c, size, size, rgb(0xf4f2ff), {.opacity = dice.between(0.3F, 1) * smooth_step(370, 120, c.y)});
  }
}

void paint_moon(Canvas& canvas) {
  const Mask moon = canvas.mask(ellipse(kMoon, 58, 58), 0.8F);
  canvas.shade(moon, [](Point p) {
    const Point q = (p - kMoon) / 58.0F;
    const float seas = fractal_noise(Point(q.x * 1.6F + 3, q.y * 1.6F), 4, 8);
    const float limb = 1 - 0.35F * (q.x * q.x + q.y * q.y);
    return mix(rgb(0xfbf6e2), rgb(0xb3aec0), smooth_step(0.5F, 0.66F, seas) * 0.8F) * limb;
  });
}

void paint_mesas(Canvas& canvas) {
  const Path far{{-20, 418}, {60, 412},  {96, 352},  {214, 346},          {244, 402},         {330, 414},
                 {410, 404}, {456, 414}, {482, 372}, {562, 368},          {588, 410},         {800, 418},
                 {842, 380}, {922, 376}, {980, 410}, {980, kHorizon + 6}, {-20, kHorizon + 6}};
  const auto strata = [](const Color& dark, const Color& light, float offset) {
    return [=](Point p) {
      const float wobble = 5 * fractal_noise(Point(p.x * 0.02F, p.y * 0.05F), 3, 13);
      const float band = value_noise(Point(0.5F, (p.y + wobble) * 0.13F + offset), 17);
      const float crack = fractal_noise(Point(p.x * 0.09F, p.y * 0.012F), 3, 19);
      return mix(mix(dark, light, 0.2F + 0.6F * band), dark, 0.6F * crack);
    };
  };
  canvas.shade(canvas.mask(far, 0.7F), strata(rgb(0x4b2c55), rgb(0xa75d63), 0));
  const Path near{{580, kHorizon + 4}, {602, 428}, {632, 420}, {650, 396},
                  {756, 392},          {776, 424}, {830, 434}, {880, kHorizon + 4}};
  canvas.shade(canvas.mask(near, 0.7F), strata(rgb(0x35203c), rgb(0x86454b), 4));
}

void paint_dune(Canvas& canvas, const Path& crest, Color dark, Color mid, Color light, std::uint32_t seed) {
  const Path top = smooth(crest);
  const Mask dune = canvas.mask(joined(top, {{980, 820}, {-20, 820}}), 0.8F);
  canvas.shade(dune, [&](Point p) {
    const float slope = fractal_noise(Point(p.x * 0.006F + p.y * 0.004F, p.y * 0.014F), 3, seed);
    const float ripple = std::sin((p.y + 0.22F * p.x + 34 * fractal_noise(p * 0.008F, 3, seed + 1)) * 0.55F);
    return ramp(1.5F * slope - 0.3F + 0.05F * ripple + (p.x - 480) / 2600, dark, mid, light);
  });
  canvas.stroke(top, {2, 3, 2}, light, {.opacity = 0.6F, .soften_px = 1.5F});
}

void paint_land(Canvas& canvas) {
  canvas.fill({{-5, kHorizon}, {965, kHorizon}, {965, 805}, {-5, 805}}, rgb(0x8a4a45));
  paint_dune(canvas, {{-20, 462}, {140, 452}, {330, 470}, {520, 456}, {740, 468}, {980, 454}}, rgb(0x5d3040),
             rgb(0xa85f4c), rgb(0xe39a66), 23);
  paint_dune(canvas, {{-20, 520}, {160, 548}, {360, 560}, {560, 520}, {760, 504}, {980, 536}}, rgb(0x4a2539),
             rgb(0x93503f), rgb(0xd58a58), 29);
  paint_dune(canvas, {{-20, 578}, {120, 590}, {300, 606}, {500, 634}, {740, 650}, {980, 610}}, rgb(0x2f1a30),
             rgb(0x74402f), rgb(0xc4814c), 37);
}

/// One arm or the trunk: a rounded, ribbed column along a path, lit by the moon from the right.
void paint_column(Canvas& canvas, const Path& spine, float radius, Dice& dice) {
  const Path line = smooth(spine);
  canvas.stroke(line, {2 * radius, 2 * radius, 1.7F * radius}, rgb(0x1d3327), {.soften_px = 0.7F});
  canvas.fill(ellipse(line.back(), radius * 0.86F, radius * 0.9F), rgb(0x1d3327), {.soften_px = 0.7F});
  canvas.glow(line.back() + Point(radius * 0.4F, -radius * 0.3F), radius * 0.3F, radius * 0.4F, rgb(0x7f9f70),
              {.opacity = 0.6F});
  for (int rib = -3; rib <= 3; ++rib) {
    const float across = static_cast<float>(rib) / 3.6F;
    Path shifted;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Point ahead = line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0];
      const Point normal = Point(-ahead.y, ahead.x) / std::max(1e-3F, std::hypot(ahead.x, ahead.y));
      shifted.push_back(line[i] + normal * (across * radius * 0.95F));
    }
    const float lit = std::clamp(0.45F + 0.5F * across, 0.0F, 1.0F);
    canvas.stroke(shifted, {2, radius * 0.2F, 1.5F}, ramp(lit, rgb(0x18291f), rgb(0x3c6444), rgb(0xa9c08a)),
                  {.opacity = 0.85F, .soften_px = 0.8F});
    for (std::size_t i = 3; i + 3 < shifted.size(); i += 5) {
      const Point p = shifted[i];
      canvas.stroke({p, p + Point(dice.between(-4, 4), dice.between(-5, 1))}, {0.9F, 0.8F, 0.3F}, rgb(0xe8dcb8),
                    {.opacity = 0.55F});
    }
  }
}

/// A saguaro from its foot at (200, 606) to its top at (200, 300).
void paint_cactus(Canvas& canvas, Dice& dice) {
  canvas.glow({174, 608}, 92, 10, rgb(0x1a0e1c), {.opacity = 0.75F});
  paint_column(canvas, {{208, 500}, {172, 496}, {140, 478}, {130, 440}, {130, 392}}, 17, dice);
  paint_column(canvas, {{196, 470}, {236, 466}, {266, 446}, {274, 410}, {274, 356}}, 17, dice);
  paint_column(canvas, {{200, 608}, {200, 520}, {200, 420}, {200, 322}}, 27, dice);
}

}  // namespace

Canvas paint_desert() {
  Canvas canvas(960, 800);
  Dice dice(77);
  paint_sky(canvas, dice);
  paint_moon(canvas);
  paint_mesas(canvas);
  paint_land(canvas);
  paint_cactus(canvas, dice);
  return canvas;
}

}  // namespace morphkit::samples
