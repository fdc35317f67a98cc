#include <algorithm>
#include <cmath>

#include "samples/pictures.h"
#include "samples/portrait.h"

namespace morphkit::samples {

namespace {

const Head kHead{.center = {424, 402}, .scale = 1.06F, .tilt_deg = 4, .turn = 10, .light_x = -1};
const Skin kSkin{rgb(0x6a3526), rgb(0xa86a4c), rgb(0xd69f78), rgb(0xf3d0ae), rgb(0xcf6a52)};
const Color kHairDark = rgb(0x1e1a19);
const Color kHairMid = rgb(0x544c48);
const Color kHairLight = rgb(0xa9a29a);

const Path kFaceSide = {{0, -182},  {72, -172}, {126, -126}, {150, -42}, {149, 50},
                        {140, 128}, {114, 192}, {62, 236},   {0, 250}};

Path face_outline() {
  const Path right = smooth(kFaceSide);
  return kHead.at(joined(right, mirrored(right)));
}

// Cheek line from the sideburn to under the nose, then back along the lower edge.
Path beard_outline() {
  const Path cheek = smooth({{0, 113}, {36, 112}, {66, 126}, {104, 106}, {136, 46}, {151, -12}});
  const Path edge = smooth({{159, -12}, {160, 60}, {152, 142}, {122, 216}, {68, 268}, {0, 286}});
  const Path right = joined(cheek, edge);
  return kHead.at(joined(right, mirrored(right)));
}

void paint_background(Canvas& canvas) {
  canvas.wash([](Point p) {
    const float far = std::hypot((p.x - 280) / 640, (p.y - 320) / 780);
    const float daub = fractal_noise(Point(p.x * 0.007F - p.y * 0.003F, p.y * 0.011F + p.x * 0.004F), 4, 5) - 0.5F;
    const Color c = ramp(1.02F - far + 0.4F * daub, rgb(0x2e1a0e), rgb(0x8a5a26), rgb(0xdcb46c));
    return cv::Vec4f(c[0], c[1], c[2], 1);
  });
}

void paint_jacket(Canvas& canvas) {
  const Path shoulders = smooth({{-20, 1010},
                                 {4, 900},
                                 {90, 836},
                                 {220, 796},
                                 {300, 750},
                                 {405, 860},
                                 {514, 748},
                                 {600, 794},
                                 {730, 834},
                                 {808, 900},
                                 {840, 1010}},
                                true);
  canvas.shade(canvas.mask(shoulders, 0.8F), [](Point p) {
    const float weave = fractal_noise(Point(p.x * 0.014F + p.y * 0.005F, p.y * 0.006F), 3, 33) - 0.5F;
    return ramp(0.62F - (p.x - 200) / 900 + 0.7F * weave, rgb(0x0e1116), rgb(0x2a3038), rgb(0x565e68));
  });
}

void paint_collar(Canvas& canvas) {
  for (const float side : {-1.0F, 1.0F}) {
    const auto at = [&](float x, float y) { return Point(405 + side * x, y); };
    const auto cloth = [&](Point p) {
      return ramp(0.7F - (p.x - 360) / 420, rgb(0x8f8a88), rgb(0xc9c3ba), rgb(0xf4efe4));
    };
    const Path front = {at(0, 850), at(78, 800), at(90, 890), at(36, 1010), at(0, 1010)};
    canvas.shade(canvas.mask(front, 0.8F), cloth);
    const Path flap = {at(84, 700), at(98, 736), at(104, 800), at(70, 892), at(4, 838), at(50, 780)};
    canvas.fill(flap, rgb(0x2a2522), {.opacity = 0.5F, .soften_px = 7});
    canvas.shade(canvas.mask(flap, 0.8F), cloth);
    const Path lapel = {at(100, 738), at(150, 768), at(186, 872), at(126, 886),
                        at(144, 916), at(46, 1010), at(22, 1010), at(70, 892)};
    canvas.fill(lapel, rgb(0x06080a), {.opacity = 0.6F, .soften_px = 6});
    canvas.shade(canvas.mask(lapel, 0.8F),
                 [&](Point p) { return ramp(0.75F - (p.x - 200) / 560, rgb(0x12161b), rgb(0x303740), rgb(0x5f6873)); });
  }
  for (const float y : {905.0F, 968.0F}) {
    canvas.fill(ellipse({405, y}, 6, 6), rgb(0x8b857c), {.soften_px = 0.6F});
    canvas.glow({403, y - 2}, 2.5F, 2.5F, rgb(0xffffff), {.opacity = 0.8F});
  }
  canvas.stroke({{405, 850}, {405, 1010}}, {1.5F, 2, 2}, rgb(0x77706a), {.opacity = 0.7F, .soften_px = 0.6F});
}

void paint_body(Canvas& canvas) {
  const Path neck = smooth({{312, 560}, {318, 690}, {312, 790}, {405, 880}, {498, 790}, {492, 690}, {500, 560}}, true);
  canvas.shade(canvas.mask(neck, 0.8F),
               [](Point p) { return ramp(0.5F - (p.x - 380) / 300, kSkin.deep, kSkin.shadow, kSkin.mid); });
  paint_jacket(canvas);
  // The jacket lies over the neck at the sides; the opening of the shirt shows it again.
  const Path opening = {{318, 690}, {320, 740}, {352, 786}, {405, 846}, {458, 786}, {490, 740}, {492, 690}};
  canvas.shade(canvas.mask(opening, 0.8F),
               [](Point p) { return ramp(0.55F - (p.x - 380) / 240, kSkin.deep, kSkin.shadow, kSkin.mid); });
  paint_collar(canvas);
}

void paint_ear(Canvas& canvas, float side) {
  const Path shell = smooth(
      {{side * 140, -14}, {side * 172, -24}, {side * 188, -4}, {side * 180, 36}, {side * 164, 66}, {side * 140, 60}},
      true);
  const Mask mask = canvas.mask(kHead.at(shell), 0.8F);
  canvas.fill(kHead.at(shell), side == kHead.light_x ? kSkin.mid : mix(kSkin.shadow, kSkin.deep, 0.3F));
  const Path rim = smooth({{side * 158, -8}, {side * 174, -12}, {side * 179, 2}, {side * 170, 38}});
  canvas.stroke(kHead.at(rim), {2, 6, 2}, kSkin.deep, {.opacity = 0.6F, .soften_px = 2, .clip = &mask});
}

void paint_lines(Canvas& canvas, const Mask& face) {
  for (const float y : {-88.0F, -112.0F, -134.0F}) {
    const Path fold = smooth({{-78, y + 8}, {-30, y}, {28, y + 1}, {80, y + 9}});
    canvas.stroke(kHead.at(fold), {1, 3.4F, 1}, kSkin.shadow, {.opacity = 0.55F, .soften_px = 1.8F, .clip = &face});
  }
  for (const float side : {-1.0F, 1.0F}) {
    const Path fold = smooth({{side * 34, 82}, {side * 54, 100}, {side * 66, 124}});
    canvas.stroke(kHead.at(fold), {2, 7, 3}, kSkin.deep, {.opacity = 0.45F, .soften_px = 3, .clip = &face});
    canvas.stroke(kHead.at(smooth({{side * 38, 24}, {side * 58, 33}, {side * 88, 28}})), {1, 4, 1}, kSkin.shadow,
                  {.opacity = 0.8F, .soften_px = 2});
    for (const float lift : {-6.0F, 4.0F, 14.0F}) {
      const Path crow = smooth({{side * 110, lift * 0.7F}, {side * 122, lift * 1.1F}, {side * 132, lift * 1.8F}});
      canvas.stroke(kHead.at(crow), {1.6F, 2.4F, 0.6F}, kSkin.deep, {.opacity = 0.3F, .soften_px = 1});
    }
  }
}

void paint_face(Canvas& canvas, const Mask& face, Dice& dice) {
  canvas.shade(face, [](Point p) { return skin_tone(kHead, kSkin, p); });
  for (const float side : {-1.0F, 1.0F}) {
    canvas.glow(kHead.at(side * 88, 66), 34, 24, kSkin.blush, {.opacity = 0.3F, .clip = &face}, -side * 20);
    canvas.glow(kHead.at(side * 138, -70), 22, 70, kSkin.shadow, {.opacity = 0.55F, .clip = &face});
  }
  canvas.glow(kHead.at(-34, -105), 56, 34, kSkin.light, {.opacity = 0.45F, .clip = &face});
  canvas.glow(kHead.at(-86, 50), 26, 13, kSkin.light, {.opacity = 0.55F, .clip = &face}, 20);
  canvas.glow(kHead.at(80, 52), 22, 11, kSkin.mid, {.opacity = 0.4F, .clip = &face}, -20);
  paint_lines(canvas, face);
  paint_nose(canvas, kHead, kSkin, {.length = 96, .half_width = 31}, face);
  for (const float side : {-1.0F, 1.0F}) {
    paint_eye(canvas, kHead, kSkin,
              {.half_width = 35,
               .opening = 0.86F,
               .iris_radius = 15.5F,
               .iris_dark = rgb(0x20364e),
               .iris_light = rgb(0x8fb4d0),
               .lash = rgb(0x2a1712)},
              side);
    paint_brow(canvas, kHead, {{side * 26, -34}, {side * 58, -46}, {side * 92, -46}, {side * 122, -26}}, 15,
               rgb(0x221d1b), rgb(0x8f8780), dice);
  }
}

// Short hairs over the mask, running down and away from the middle.
void paint_whiskers(Canvas& canvas, const Mask& mask, Dice& dice) {
  for (int hair = 0; hair < 5200; ++hair) {
    const Point root(dice.between(-160, 160), dice.between(-20, 284));
    const Point on_canvas = kHead.at(root.x, root.y);
    const bool beside_lips = std::hypot(root.x / 48, (root.y - 156) / 21) < 1;
    if (beside_lips || mask.at(static_cast<int>(on_canvas.x), static_cast<int>(on_canvas.y)) < 0.5F) {
      continue;
    }
    const float length = dice.between(12, 26) * (0.55F + 0.5F * smooth_step(20, 220, root.y));
    const float lean = 0.0022F * root.x * (1 - smooth_step(170, 290, root.y) * 1.6F) + dice.between(-0.28F, 0.28F);
    const Point tip = root + Point(lean, 1) * length;
    const Point bend = (root + tip) * 0.5F + Point(dice.between(-2, 2), 0);
    const float grey = std::exp(-std::pow(root.x / 62, 2.0F)) * smooth_step(150, 230, root.y);
    const float lit = 0.3F - 0.0022F * root.x + 0.42F * grey + dice.between(-0.3F, 0.3F);
    canvas.stroke(kHead.at(smooth({root, bend, tip})), {1.2F, 2.4F, 0.4F}, ramp(lit, kHairDark, kHairMid, kHairLight),
                  {.opacity = 0.72F});
  }
}

void paint_beard(Canvas& canvas, Dice& dice) {
  const Mask soft = canvas.mask(beard_outline(), 7);
  canvas.shade(soft, [](Point p) { return mix(kHairMid, kHairDark, smooth_step(-140, 80, kHead.to_head(p).x)); },
               {.opacity = 0.86F});
  paint_whiskers(canvas, soft, dice);
  paint_lips(canvas, kHead, kSkin,
             {.y = 152,
              .half_width = 45,
              .fullness = 0.78F,
              .dark = rgb(0x6c2c26),
              .mid = rgb(0xa85a4c),
              .light = rgb(0xd4907c)});
  for (const float side : {-1.0F, 1.0F}) {
    const Path upper = kHead.at(Path{{side * 3, 112}, {side * 30, 113}, {side * 58, 130}, {side * 67, 172}});
    const Path lower = kHead.at(Path{{side * 2, 133}, {side * 22, 140}, {side * 44, 150}, {side * 65, 175}});
    const Color light = mix(kHairMid, kHairLight, side < 0 ? 0.9F : 0.5F);
    paint_lock(canvas,
               {.first = upper,
                .second = lower,
                .strands = 240,
                .width_px = {1.2F, 2.6F, 0.4F},
                .jitter_px = 5,
                .dark = kHairDark,
                .mid = kHairMid,
                .light = light,
                .opacity = 0.62F},
               dice);
  }
}

// Parted on the left of the picture, cut above the ears.
void paint_hair(Canvas& canvas, Dice& dice) {
  const Path inner[] = {{{-58, -158}, {-98, -146}, {-128, -104}, {-145, -50}, {-149, 16}},
                        {{-58, -158}, {24, -172}, {100, -146}, {138, -84}, {149, 16}}};
  const Path outer[] = {{{-62, -222}, {-118, -206}, {-160, -146}, {-172, -72}, {-154, 22}},
                        {{-62, -222}, {40, -252}, {128, -212}, {171, -106}, {154, 22}}};
  for (const int right : {0, 1}) {
    const Path edge = kHead.at(smooth(inner[right]));
    Path back = kHead.at(smooth(outer[right]));
    std::reverse(back.begin(), back.end());
    canvas.stroke(edge, {10, 18, 6}, kSkin.deep, {.opacity = 0.45F, .soften_px = 7});
    canvas.shade(canvas.mask(joined(edge, back), 2),
                 [&](Point p) { return mix(kHairMid, kHairDark, smooth_step(-120, 60, kHead.to_head(p).x)); });
    const Color light = right == 1 ? mix(kHairMid, kHairLight, 0.6F) : kHairLight;
    paint_lock(canvas,
               {.first = kHead.at(inner[right]),
                .second = kHead.at(outer[right]),
                .strands = right == 1 ? 620 : 420,
                .width_px = {1, 3, 0.4F},
                .jitter_px = 7,
                .dark = kHairDark,
                .mid = kHairMid,
                .light = light,
                .opacity = 0.55F},
               dice);
  }
  canvas.glow(kHead.at(10, -212), 52, 16, kHairLight, {.opacity = 0.3F}, kHead.tilt_deg - 6);
}

}  // namespace

Canvas paint_man() {
  Canvas canvas(820, 1000);
  Dice dice(1987);
  paint_background(canvas);
  paint_body(canvas);
  paint_ear(canvas, -1);
  paint_ear(canvas, 1);
  const Mask face = canvas.mask(face_outline(), 0.7F);
  paint_face(canvas, face, dice);
  paint_beard(canvas, dice);
  paint_hair(canvas, dice);
  return canvas;
}

}  // namespace morphkit::samples
