// A pear, transparent around, with a soft shadow.

#include <algorithm>
#include <cmath>

#include "samples/pictures.h"

namespace morphkit::samples {
namespace {

/// Right half of the outline, from the stem down; the axis is x = 320.
const Path kSide{{320, 150}, {356, 162}, {378, 205}, {392, 260}, {428, 320},
                 {462, 390}, {462, 460}, {424, 520}, {366, 544}, {320, 540}};
const Path kStem{{320, 166}, {324, 130}, {336, 96}, {354, 74}};

Path pear_outline() {
  const Path right = smooth(kSide);
  return joined(right, mirrored(right, 320));
}

Color pear_skin(Point p) {
  // A rounded body under a light from the upper left; the neck is narrower than the belly.
  const float half_width = 66 + 78 * smooth_step(190, 400, p.y);
  const float x = (p.x - 320) / half_width, y = (p.y - 420) / 190;
  const float facing = 0.78F - 0.34F * x - 0.26F * y - 0.34F * (x * x + 0.5F * y * y);
  const float mottle = fractal_noise(p * 0.035F, 4, 3) - 0.5F;
  Color c = ramp(facing + 0.14F * mottle, rgb(0x5a5a16), rgb(0xaeb234), rgb(0xf0e684));
  const float blush = smooth_step(350, 450, p.x + 0.25F * (p.y - 380)) * smooth_step(190, 330, p.y);
  return mix(c, ramp(facing + 0.1F * mottle, rgb(0x571a10), rgb(0xb8502a), rgb(0xf0a070)), 0.65F * blush);
}

}  // namespace

Canvas paint_pear() {
  Canvas canvas(640, 640);
  canvas.glow({332, 552}, 120, 15, rgb(0x120d08), {.opacity = 0.7F});
  const Path outline = pear_outline();
  const Mask body = canvas.mask(outline, 0.6F);
  canvas.shade(body, pear_skin);
  Dice dice(5);
  for (int freckle = 0; freckle < 420; ++freckle) {
    const float size = dice.between(0.6F, 1.5F);
    const Point c(dice.between(175, 465), dice.between(160, 540));
    canvas.fill(ellipse(c, size, size), rgb(0x6a5a1e),
                {.opacity = dice.between(0.2F, 0.6F), .soften_px = 0.4F, .clip = &body});
  }
  // Light reflected from the ground, the shine, and the dimple at the stem.
  canvas.glow({338, 536}, 80, 9, rgb(0xd9c27a), {.opacity = 0.5F, .clip = &body});
  canvas.glow({262, 372}, 26, 44, rgb(0xfffdf0), {.opacity = 0.75F, .clip = &body}, 18);
  canvas.glow({290, 232}, 10, 24, rgb(0xfffdf0), {.opacity = 0.55F, .clip = &body}, 14);
  canvas.glow({322, 166}, 17, 8, rgb(0x3f3a10), {.opacity = 0.7F, .clip = &body});
  canvas.stroke(smooth(kStem), {11, 9, 12}, rgb(0x4a2f1a), {.soften_px = 0.5F});
  canvas.stroke(smooth({{317, 164}, {321, 130}, {333, 98}, {350, 78}}), {2, 3, 3}, rgb(0xa07a4c),
                {.opacity = 0.8F, .soften_px = 0.7F});

  const Path leaf = smooth({{332, 108}, {372, 74}, {436, 66}, {494, 92}, {440, 122}, {380, 128}}, true);
  const Mask blade = canvas.mask(leaf, 0.5F);
  canvas.shade(blade, [](Point p) {
    const float vein = std::abs(std::sin((p.x - p.y * 0.7F) * 0.16F));
    return ramp(0.75F - (p.y - 70) / 90 + 0.12F * vein, rgb(0x1d4418), rgb(0x4c8c2c), rgb(0xa7cf62));
  });
  canvas.stroke(smooth({{334, 108}, {400, 98}, {488, 93}}), {2.4F, 1.8F, 0.6F}, rgb(0xd2e39a),
                {.opacity = 0.8F, .clip = &blade});
  return canvas;
}

}  // namespace morphkit::samples
