// A burning light bulb that stands on its base: transparent around, with half-transparent glass.

#include <algorithm>
#include <cmath>

#include "samples/pictures.h"

namespace morphkit::samples {
namespace {

/// Right half of the glass, from the top down to the base; the axis is x = 320.
const Path kSide{{320, 84},  {384, 96},  {440, 138}, {466, 204}, {456, 272},
                 {420, 334}, {392, 384}, {378, 430}, {320, 440}};

Path glass_outline() {
  const Path right = smooth(kSide);
  return joined(right, mirrored(right, 320));
}

void paint_base(Canvas& canvas) {
  const Path shell{{264, 424}, {376, 424}, {374, 520}, {352, 542}, {288, 542}, {266, 520}};
  const Mask metal = canvas.mask(shell, 0.7F);
  const auto round = [](Point p) { return 1 - std::pow((p.x - 306) / 74, 2.0F); };
  canvas.shade(metal, [&](Point p) {
    const float thread = 0.5F + 0.5F * std::sin((p.y - 424 + (p.x - 320) * 0.06F) * 0.33F);
    return ramp(0.12F + 0.5F * round(p) + 0.3F * thread - 0.1F, rgb(0x2e2c2c), rgb(0x9c9690), rgb(0xf6f1e6));
  });
  const Path foot{{290, 540}, {350, 540}, {340, 560}, {300, 560}};
  canvas.shade(canvas.mask(foot, 0.7F),
               [&](Point p) { return ramp(0.5F * round(p), rgb(0x16130f), rgb(0x3a332a), rgb(0x8a7c66)); });
}

void paint_filament(Canvas& canvas) {
  canvas.stroke(smooth({{302, 428}, {298, 350}, {276, 246}}), {5, 3, 2.4F}, rgb(0x6e6152),
                {.opacity = 0.9F, .soften_px = 0.5F});
  canvas.stroke(smooth({{338, 428}, {342, 350}, {364, 246}}), {5, 3, 2.4F}, rgb(0x6e6152),
                {.opacity = 0.9F, .soften_px = 0.5F});
  canvas.stroke(smooth({{320, 430}, {320, 380}, {320, 330}}), {12, 8, 5}, rgb(0xe8dcc4),
                {.opacity = 0.6F, .soften_px = 1});
  Path coil;
  for (int i = 0; i <= 160; ++i) {
    const float t = static_cast<float>(i) / 160;
    coil.push_back({276 + 88 * t, 246 - 22 * std::sin(t * 3.14159F) + 6 * std::sin(t * 88)});
  }
  canvas.stroke(coil, {3, 3.6F, 3}, rgb(0xffb347), {.soften_px = 2.5F});
  canvas.stroke(coil, {2, 2.2F, 2}, rgb(0xfffbe8), {.soften_px = 0.4F});
}

}  // namespace

Canvas paint_bulb() {
  Canvas canvas(640, 640);
  canvas.glow({326, 562}, 84, 12, rgb(0x120d08), {.opacity = 0.7F});
  paint_base(canvas);
  const Path outline = glass_outline();
  const Mask glass = canvas.mask(outline, 0.6F);
  canvas.wash(
      [](Point p) {
        const float near = std::hypot(p.x - 320, p.y - 236);
        const Color c = ramp(1.1F - near / 230, rgb(0xb86a1c), rgb(0xf7c560), rgb(0xfffae0));
        return cv::Vec4f(c[0], c[1], c[2], 0.93F);
      },
      &glass);
  paint_filament(canvas);
  canvas.glow({320, 234}, 62, 42, rgb(0xfff6d0), {.opacity = 0.75F, .clip = &glass});
  // The rim, and the window reflected in the glass.
  Path rim = outline;
  rim.push_back(outline.front());
  canvas.stroke(rim, {5, 5, 5}, rgb(0x8a4d14), {.opacity = 0.55F, .soften_px = 2, .clip = &glass});
  canvas.stroke(smooth({{208, 262}, {200, 204}, {222, 150}, {262, 116}}), {3, 15, 3}, rgb(0xffffff),
                {.opacity = 0.85F, .soften_px = 2, .clip = &glass});
  canvas.stroke(smooth({{438, 282}, {450, 236}, {446, 196}}), {2, 7, 2}, rgb(0xffffff),
                {.opacity = 0.55F, .soften_px = 2, .clip = &glass});
  return canvas;
}

}  // namespace morphkit::samples
