#include <algorithm>
#include <cmath>

#include "samples/pictures.h"
#include "samples/portrait.h"

namespace morphkit::samples {

namespace {

const Head kHead{.center = {392, 430}, .scale = 1.0F, .tilt_deg = -5, .turn = -9, .light_x = -1};
const Skin kSkin{rgb(0x7a3f33), rgb(0xc07f66), rgb(0xeab897), rgb(0xfce3cc), rgb(0xe07a68)};
const Color kHairDark = rgb(0x3c130a);
const Color kHairMid = rgb(0x8a3413);
const Color kHairLight = rgb(0xdd8040);

const Path kFaceSide = {{0, -206},  {70, -190}, {122, -128}, {141, -38}, {138, 50},
                        {122, 122}, {90, 182},  {48, 222},   {0, 236}};

Path face_outline() {
  const Path right = smooth(kFaceSide);
  return kHead.at(joined(right, mirrored(right)));
}

void paint_background(Canvas& canvas) {
  canvas.wash([](Point p) {
    const float far = std::hypot((p.x - 300) / 620, (p.y - 330) / 760);
    const float daub = fractal_noise(Point(p.x * 0.006F + p.y * 0.003F, p.y * 0.012F - p.x * 0.004F), 4, 3) - 0.5F;
    const Color c = ramp(1.05F - far + 0.4F * daub, rgb(0x17302f), rgb(0x3f7470), rgb(0xa9cbb4));
    return cv::Vec4f(c[0], c[1], c[2], 1);
  });
}

void paint_back_hair(Canvas& canvas, Dice& dice) {
  const Path outline = smooth({{398, 168},
                               {500, 186},
                               {572, 270},
                               {596, 400},
                               {602, 540},
                               {630, 680},
                               {652, 800},
                               {640, 905},
                               {560, 960},
                               {400, 940},
                               {232, 960},
                               {162, 900},
                               {150, 800},
                               {172, 680},
                               {196, 540},
                               {190, 400},
                               {214, 270},
                               {296, 190}},
                              true);
  const Mask mask = canvas.mask(outline, 1.5F);
  canvas.shade(mask, [](Point p) { return mix(kHairDark, kHairMid, smooth_step(950, 250, p.y) * 0.5F); });
  const Mask soft = canvas.mask(outline, 5);
  for (const float side : {-1.0F, 1.0F}) {
    const float c = 395;
    const auto at = [&](float x, float y) { return Point(c + side * x, y); };
    paint_lock(canvas,
               {.first = {at(150, 300), at(120, 450), at(110, 600), at(100, 760), at(60, 930)},
                .second = {at(196, 300), at(205, 450), at(214, 600), at(258, 780), at(235, 930)},
                .strands = 420,
                .width_px = {1, 3.4F, 0.5F},
                .jitter_px = 7,
                .dark = kHairDark,
                .mid = kHairMid,
                .light = mix(kHairMid, kHairLight, 0.6F)},
               dice, &soft);
  }
}

void paint_body(Canvas& canvas, Dice& dice) {
  const Path neck = smooth({{318, 560},
                            {322, 680},
                            {316, 742},
                            {250, 790},
                            {160, 840},
                            {90, 1010},
                            {720, 1010},
                            {655, 850},
                            {556, 792},
                            {486, 745},
                            {476, 680},
                            {484, 560}},
                           true);
  const Mask skin = canvas.mask(neck, 0.8F);
  canvas.shade(skin, [](Point p) {
    const float round = 1 - std::pow((p.x - 385) / 110, 2.0F);
    const float column = 0.25F + 0.35F * round - (p.x - 380) / 400;
    const float chest = 0.82F - (p.x - 330) / 700;
    return ramp(std::lerp(column, chest, smooth_step(715, 805, p.y)), kSkin.shadow, kSkin.mid, kSkin.light);
  });
  // The chin's shadow on the neck, and the collar bones.
  canvas.fill(smooth({{316, 590}, {360, 690}, {420, 715}, {486, 690}, {500, 600}, {470, 560}, {330, 560}}, true),
              kSkin.deep, {.opacity = 0.62F, .soften_px = 14, .clip = &skin});
  canvas.stroke(smooth({{330, 690}, {352, 750}, {384, 796}}), {4, 9, 5}, kSkin.shadow,
                {.opacity = 0.5F, .soften_px = 5, .clip = &skin});
  canvas.stroke(smooth({{478, 690}, {446, 760}, {414, 796}}), {4, 9, 5}, kSkin.deep,
                {.opacity = 0.35F, .soften_px = 5, .clip = &skin});
  canvas.stroke(smooth({{250, 812}, {310, 806}, {376, 822}}), {3, 9, 4}, kSkin.shadow,
                {.opacity = 0.7F, .soften_px = 4, .clip = &skin});
  canvas.stroke(smooth({{250, 800}, {310, 793}, {372, 806}}), {3, 8, 4}, kSkin.light,
                {.opacity = 0.6F, .soften_px = 4, .clip = &skin});
  canvas.stroke(smooth({{424, 822}, {490, 806}, {560, 812}}), {3, 9, 4}, kSkin.deep,
                {.opacity = 0.45F, .soften_px = 4, .clip = &skin});

  const Path dress = smooth({{60, 1010},
                             {84, 905},
                             {150, 846},
                             {228, 812},
                             {258, 870},
                             {330, 926},
                             {400, 940},
                             {476, 922},
                             {536, 868},
                             {562, 812},
                             {650, 850},
                             {722, 912},
                             {752, 1010}},
                            true);
  const Mask cloth = canvas.mask(dress, 0.7F);
  canvas.fill(dress, kSkin.deep, {.opacity = 0.4F, .soften_px = 7, .clip = &skin});
  canvas.shade(cloth, [](Point p) {
    const float fold = fractal_noise(Point(p.x * 0.018F + p.y * 0.006F, p.y * 0.005F), 3, 21) - 0.5F;
    return ramp(0.62F - (p.x - 300) / 900 + 0.9F * fold, rgb(0x0d2440), rgb(0x245a86), rgb(0x6fb0c8));
  });
  canvas.stroke(smooth({{228, 812}, {258, 870}, {330, 926}, {400, 940}, {476, 922}, {536, 868}, {562, 812}}), {4, 6, 4},
                rgb(0xe3cf9a), {.opacity = 0.9F, .soften_px = 0.6F});
  for (int pearl = 0; pearl < 23; ++pearl) {
    const float t = static_cast<float>(pearl) / 22 * 2 - 1;
    const Point c(399 + 112 * t + dice.between(-0.5F, 0.5F), 872 - 92 * t * t - 10 * std::abs(t));
    canvas.fill(ellipse(c + Point(1.5F, 3), 6.5F, 6.5F), kSkin.deep, {.opacity = 0.4F, .soften_px = 2});
    canvas.fill(ellipse(c, 6, 6), rgb(0xd8cabb));
    canvas.glow(c + Point(-1.8F, -1.8F), 2.4F, 2.4F, rgb(0xffffff), {.opacity = 0.95F});
  }
}

void paint_face(Canvas& canvas, const Mask& face, Dice& dice) {
  canvas.shade(face, [](Point p) { return skin_tone(kHead, kSkin, p); });
  for (const float side : {-1.0F, 1.0F}) {
    canvas.glow(kHead.at(side * 82, 82), 36, 28, kSkin.blush, {.opacity = 0.36F, .clip = &face}, -side * 20);
    canvas.glow(kHead.at(side * 128, -70), 22, 70, kSkin.shadow, {.opacity = 0.55F, .clip = &face});
  }
  canvas.glow(kHead.at(-30, -95), 50, 32, kSkin.light, {.opacity = 0.5F, .clip = &face});
  canvas.glow(kHead.at(-84, 52), 26, 13, rgb(0xfff2e2), {.opacity = 0.55F, .clip = &face}, 20);
  canvas.glow(kHead.at(74, 54), 22, 11, kSkin.light, {.opacity = 0.4F, .clip = &face}, -20);
  canvas.glow(kHead.at(-6, 207), 20, 12, kSkin.light, {.opacity = 0.5F, .clip = &face});
  canvas.stroke(kHead.at(smooth({{140, 0}, {134, 90}, {98, 182}, {40, 232}})), {20, 34, 14}, kSkin.deep,
                {.opacity = 0.4F, .soften_px = 14, .clip = &face});
  // Light reflected from the dress keeps the dark side of the jaw visible.
  canvas.stroke(kHead.at(smooth({{126, 118}, {94, 182}, {52, 222}})), {2, 6, 2}, rgb(0xd9a58c),
                {.opacity = 0.5F, .soften_px = 3, .clip = &face});

  paint_nose(canvas, kHead, kSkin, {.length = 90, .half_width = 24}, face);
  paint_lips(canvas, kHead, kSkin,
             {.y = 148,
              .half_width = 46,
              .fullness = 1.05F,
              .dark = rgb(0x7e2426),
              .mid = rgb(0xc4504c),
              .light = rgb(0xee9486)});
  for (const float side : {-1.0F, 1.0F}) {
    paint_eye(canvas, kHead, kSkin,
              {.half_width = 38,
               .opening = 1.1F,
               .iris_radius = 17.5F,
               .iris_dark = rgb(0x1c4a3c),
               .iris_light = rgb(0x9fd48a),
               .lash = rgb(0x1e0c08),
               .lashes = true},
              side);
    paint_brow(canvas, kHead, {{side * 30, -44}, {side * 62, -57}, {side * 92, -56}, {side * 118, -38}}, 9,
               rgb(0x46190c), rgb(0x8a3f1e), dice);
  }
}

// Two curtains of hair from the parting, over the temples and down past the shoulders.
void paint_front_hair(Canvas& canvas, Dice& dice) {
  const Point part(373, 232);
  const Path left_inner = {part, {306, 280}, {266, 366}, {250, 480}, {246, 600}, {236, 730}, {214, 880}};
  const Path left_outer = {{366, 170}, {238, 220}, {182, 360}, {182, 500}, {178, 620}, {140, 760}, {186, 930}};
  const Path right_inner = {part, {462, 262}, {522, 346}, {540, 470}, {548, 600}, {562, 730}, {588, 880}};
  const Path right_outer = {{378, 168}, {540, 206}, {604, 350}, {610, 500}, {622, 620}, {668, 760}, {614, 930}};
  for (const bool right : {false, true}) {
    const Path& inner = right ? right_inner : left_inner;
    const Path& outer = right ? right_outer : left_outer;
    const Path edge = smooth(inner);
    Path back = smooth(outer);
    std::reverse(back.begin(), back.end());
    const Path shape = joined(edge, back);
    canvas.stroke(edge, {2, 26, 10}, rgb(0x3a160d), {.opacity = 0.4F, .soften_px = 9});
    canvas.shade(canvas.mask(shape, 1.2F), [&](Point p) {
      const float shine = std::exp(-std::pow((p.y - 330 - 0.12F * std::abs(p.x - 390)) / 75, 2.0F));
      return ramp(0.25F + 0.35F * shine - (right ? 0.12F : 0.0F), kHairDark, kHairMid, kHairLight);
    });
    Path mid_line;
    for (std::size_t i = 0; i < inner.size(); ++i) {
      mid_line.push_back((inner[i] + outer[i]) * 0.5F);
    }
    const Color light = right ? mix(kHairMid, kHairLight, 0.62F) : kHairLight;
    paint_lock(canvas,
               {.first = inner,
                .second = outer,
                .strands = 520,
                .width_px = {0.8F, 3.2F, 0.4F},
                .jitter_px = 5,
                .dark = kHairDark,
                .mid = kHairMid,
                .light = light,
                .opacity = 0.55F},
               dice);
    paint_lock(canvas,
               {.first = inner,
                .second = mid_line,
                .strands = 120,
                .width_px = {0.5F, 1.6F, 0.3F},
                .jitter_px = 4,
                .dark = kHairMid,
                .mid = kHairMid,
                .light = mix(light, rgb(0xffc080), 0.4F),
                .opacity = 0.5F},
               dice);
    const Mask mask = canvas.mask(shape, 3);
    const Point sheen = right ? Point(560, 320) : Point(226, 320);
    canvas.glow(sheen, 34, 46, rgb(0xffb066), {.opacity = right ? 0.22F : 0.4F, .clip = &mask}, right ? -20.0F : 20.0F);
  }
}

}  // namespace

Canvas paint_woman() {
  Canvas canvas(800, 1000);
  Dice dice(2027);
  paint_background(canvas);
  paint_back_hair(canvas, dice);
  paint_body(canvas, dice);
  const Mask face = canvas.mask(face_outline(), 0.7F);
  paint_face(canvas, face, dice);
  paint_front_hair(canvas, dice);
  return canvas;
}

}  // namespace morphkit::samples
