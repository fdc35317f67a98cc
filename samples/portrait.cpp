#include "samples/portrait.h"

#include <algorithm>
#include <cmath>

namespace morphkit::samples {

namespace {

constexpr float kDegree = static_cast<float>(CV_PI / 180.0);
constexpr float kHeadHalfWidth = 165;

struct EyeShape {
  Path upper, lower;  // outer to inner corner; inner to outer corner
};

EyeShape eye_shape(const EyeStyle& style, float side) {
  const Point c = eye_center(side);
  const float w = style.half_width;
  const float o = style.opening;
  const auto p = [&](float along, float y) { return Point(c.x + side * along * w, c.y + y); };
  return {smooth({p(1, -3), p(0.66F, -12 * o - 1), p(0.15F, -18 * o), p(-0.4F, -14 * o), p(-0.8F, -3), p(-1, 5)}),
          smooth({p(-1, 5), p(-0.55F, 9 * o + 1), p(0, 13 * o), p(0.5F, 10 * o), p(1, -3)})};
}

void paint_iris(Canvas& canvas, const Head& head, const EyeStyle& style, Point center, const Mask& ball) {
  const float radius = style.iris_radius * head.scale;
  const Point middle = head.at(center.x, center.y - 2);
  canvas.shade(canvas.mask(ellipse(middle, radius, radius), 0.5F),
               [&](Point p) {
                 const Point d = (p - middle) / radius;
                 const float r = std::hypot(d.x, d.y);
                 const float angle = std::atan2(d.y, d.x);
                 const float streak = value_noise(Point(8 + 7 * std::cos(angle), 8 + 7 * std::sin(angle)) + d, 31);
                 // Light enters above and leaves through the lower half: the iris glows opposite to the highlight.
                 const float glow = 0.45F + 0.4F * d.y - 0.15F * head.light_x * d.x + 0.5F * (streak - 0.5F);
                 const Color base = mix(style.iris_dark, style.iris_light, std::clamp(glow, 0.0F, 1.0F));
                 return mix(base, style.iris_dark * 0.35F, smooth_step(0.72F, 1.0F, r));
               },
               {.opacity = 1, .soften_px = 0, .clip = &ball});
  canvas.fill(ellipse(middle, radius * 0.42F, radius * 0.42F), rgb(0x0c0808),
              {.opacity = 0.97F, .soften_px = 0.7F, .clip = &ball});
}

void paint_lashes(Canvas& canvas, const Head& head, const EyeStyle& style, const EyeShape& shape, float side) {
  for (int lash = 0; lash < 9; ++lash) {
    const std::size_t root = static_cast<std::size_t>(lash) * 4;
    const Point a = shape.upper[root];
    const float length = 15 - 1.0F * static_cast<float>(lash);
    const float lean = 0.95F - 0.12F * static_cast<float>(lash);
    const Path hair =
        smooth({a, a + Point(side * lean * 0.6F, -0.35F) * length, a + Point(side * lean, -0.85F) * length});
    canvas.stroke(head.at(hair), {2.6F * head.scale, 1.6F * head.scale, 0.3F}, style.lash, {.opacity = 0.85F});
  }
}

}  // namespace

Point Head::at(float x, float y) const {
  const float bulge = std::max(0.0F, 1 - (x / kHeadHalfWidth) * (x / kHeadHalfWidth));
  const float turned = x + turn * bulge;
  const float cosine = std::cos(tilt_deg * kDegree) * scale;
  const float sine = std::sin(tilt_deg * kDegree) * scale;
  return {center.x + turned * cosine - y * sine, center.y + turned * sine + y * cosine};
}

Path Head::at(const Path& path) const {
  Path result;
  for (const Point& p : path) {
    result.push_back(at(p.x, p.y));
  }
  return result;
}

Point Head::to_head(Point canvas) const {
  const float cosine = std::cos(tilt_deg * kDegree) / scale;
  const float sine = std::sin(tilt_deg * kDegree) / scale;
  const Point d = canvas - center;
  return {d.x * cosine + d.y * sine, d.y * cosine - d.x * sine};
}

Color skin_tone(const Head& head, const Skin& skin, Point canvas) {
  const Point p = head.to_head(canvas);
  const float x = std::clamp((p.x - 0.6F * head.turn) / 172, -1.0F, 1.0F);
  const float y = std::clamp((p.y - 10) / 275, -1.0F, 1.0F);
  const float z = std::sqrt(std::max(0.02F, 1 - x * x - 0.8F * y * y));
  const float lit = 0.45F * head.light_x * x - 0.3F * y + 0.72F * z;
  const float grain = 0.05F * (fractal_noise(canvas * 0.05F, 3, 9) - 0.5F);
  const float tone = 0.12F + 1.0F * lit + grain;
  const Color base = ramp(tone, skin.shadow, skin.mid, skin.light);
  return mix(skin.deep, base, smooth_step(-0.15F, 0.4F, tone));
}

void paint_eye(Canvas& canvas, const Head& head, const Skin& skin, const EyeStyle& style, float side) {
  const EyeShape shape = eye_shape(style, side);
  const Point c = eye_center(side);
  const float s = head.scale;
  canvas.glow(head.at(c.x - side * 4, c.y - 16), 34 * s, 15 * s, skin.shadow, {.opacity = 0.55F}, head.tilt_deg);
  canvas.glow(head.at(c.x - side * 38, c.y - 6), 11 * s, 18 * s, skin.deep, {.opacity = 0.32F}, head.tilt_deg);
  canvas.glow(head.at(c.x, c.y + 22), 26 * s, 7 * s, skin.shadow, {.opacity = 0.3F}, head.tilt_deg);

  const Mask ball = canvas.mask(head.at(joined(shape.upper, shape.lower)), 0.4F);
  canvas.shade(ball, [&](Point p) {
    const Point local = head.to_head(p) - head.to_head(head.at(c.x, c.y));
    const float round = std::clamp(1 - std::pow(local.x / (style.half_width * 1.15F), 2.0F), 0.0F, 1.0F);
    return mix(rgb(0x9c8078), rgb(0xf2ece6), round * smooth_step(-19, 2, local.y));
  });
  paint_iris(canvas, head, style, c, ball);
  canvas.stroke(head.at(shape.upper), {8 * s, 11 * s, 4 * s}, rgb(0x20100c),
                {.opacity = 0.35F, .soften_px = 3 * s, .clip = &ball});
  canvas.fill(ellipse(head.at(c.x + head.light_x * 6, c.y - 8), 4.2F * s, 4.8F * s), rgb(0xffffff),
              {.soften_px = 0.6F});
  canvas.glow(head.at(c.x - head.light_x * 6, c.y + 5), 3.2F * s, 2.4F * s, rgb(0xffffff),
              {.opacity = 0.4F, .clip = &ball});
  canvas.fill(ellipse(head.at(c.x - side * (style.half_width - 4), c.y + 4), 4 * s, 3 * s), rgb(0xc98478),
              {.opacity = 0.7F, .soften_px = 1.2F * s});

  canvas.stroke(head.at(shape.upper), {3.2F * s, 5.0F * s, 1.4F * s}, style.lash,
                {.opacity = 0.95F, .soften_px = 0.5F});
  canvas.stroke(head.at(shape.lower), {0.8F, 1.8F * s, 1.6F * s}, mix(style.lash, skin.deep, 0.5F),
                {.opacity = 0.65F, .soften_px = 0.6F});
  Path crease;
  for (const Point& p : shape.upper) {
    crease.push_back(p + Point(side * 1.5F, -9.5F + 0.06F * std::abs(p.x - c.x)));
  }
  canvas.stroke(head.at(crease), {1, 3.4F * s, 1}, skin.deep, {.opacity = 0.6F, .soften_px = 1.1F * s});
  canvas.glow(head.at(c.x + side * 6, c.y - 36), 22 * s, 5 * s, skin.light, {.opacity = 0.35F}, head.tilt_deg);
  if (style.lashes) {
    paint_lashes(canvas, head, style, shape, side);
  }
}

void paint_nose(Canvas& canvas, const Head& head, const Skin& skin, const NoseStyle& style, const Mask& face) {
  const float s = head.scale;
  const float tip = style.length;
  const float w = style.half_width;
  const float dark_side = -head.light_x;
  const Path side_plane = smooth({{dark_side * 12, -12},
                                  {dark_side * 13, 25},
                                  {dark_side * 18, 58},
                                  {dark_side * (w - 3), tip - 8},
                                  {dark_side * (w + 5), tip + 2},
                                  {dark_side * (w + 16), tip - 8},
                                  {dark_side * 34, 46},
                                  {dark_side * 26, 4}},
                                 true);
  canvas.fill(head.at(side_plane), skin.shadow, {.opacity = 0.6F, .soften_px = 6 * s, .clip = &face});
  canvas.fill(ellipse(head.at(dark_side * 8, tip + 20), 26 * s, 8 * s, head.tilt_deg), skin.deep,
              {.opacity = 0.35F, .soften_px = 6 * s, .clip = &face});
  for (const float side : {-1.0F, 1.0F}) {
    canvas.fill(ellipse(head.at(side * (w - 8), tip + 1), 12 * s, 11 * s), skin.mid,
                {.opacity = 0.45F, .soften_px = 4 * s});
    const Path wing = smooth(
        {{side * (w - 5), tip - 17}, {side * (w + 2), tip - 8}, {side * (w + 2), tip + 5}, {side * (w - 6), tip + 11}});
    canvas.stroke(head.at(wing), {1, 4 * s, 1.5F}, skin.deep,
                  {.opacity = side == dark_side ? 0.7F : 0.42F, .soften_px = 1.6F * s});
    const Path nostril = smooth({{side * 6, tip + 11},
                                 {side * 12, tip + 7},
                                 {side * (w - 8), tip + 9},
                                 {side * (w - 9), tip + 13},
                                 {side * 12, tip + 13}},
                                true);
    canvas.fill(head.at(nostril), skin.deep * 0.45F, {.opacity = 0.8F, .soften_px = 1.3F * s});
  }
  canvas.stroke(head.at(smooth({{-9, tip + 12}, {0, tip + 15}, {9, tip + 12}})), {1, 3 * s, 1}, skin.deep,
                {.opacity = 0.5F, .soften_px = 1.5F * s});
  canvas.stroke(
      head.at(smooth(
          {{head.light_x * 3, -25}, {head.light_x * 3, 20}, {head.light_x * 4, 60}, {head.light_x * 4, tip - 14}})),
      {3 * s, 11 * s, 12 * s}, skin.light, {.opacity = 0.6F, .soften_px = 4.5F * s});
  canvas.glow(head.at(head.light_x * 4, tip - 7), 8 * s, 7 * s, mix(skin.light, rgb(0xffffff), 0.5F),
              {.opacity = 0.6F});
}

void paint_lips(Canvas& canvas, const Head& head, const Skin& skin, const LipStyle& style) {
  const float s = head.scale;
  const float y = style.y;
  const float w = style.half_width;
  const float f = style.fullness;
  const Path seam = smooth({{-w, y + 1},
                            {-w * 0.5F, y - 1},
                            {-w * 0.2F, y - 2},
                            {0, y + 1},
                            {w * 0.2F, y - 2},
                            {w * 0.5F, y - 1},
                            {w, y + 1}});
  const Path bow = smooth({{w, y + 1},
                           {w * 0.55F, y - 11 * f},
                           {w * 0.2F, y - 17 * f},
                           {0, y - 13 * f},
                           {-w * 0.2F, y - 17 * f},
                           {-w * 0.55F, y - 11 * f},
                           {-w, y + 1}});
  const Path under = smooth({{w, y + 1},
                             {w * 0.55F, y + 15 * f},
                             {w * 0.18F, y + 22 * f},
                             {-w * 0.18F, y + 22 * f},
                             {-w * 0.55F, y + 15 * f},
                             {-w, y + 1}});
  canvas.glow(head.at(0, y + 32 * f + 3), 26 * s, 6 * s, skin.deep, {.opacity = 0.42F}, head.tilt_deg);
  const auto tone = [&](Point p) {
    const Point local = head.to_head(p);
    const float across = 1 - std::pow((local.x - head.turn) / (w * 1.1F), 2.0F);
    const float crinkle = value_noise(Point(local.x * 0.45F, local.y * 0.06F), 17) - 0.5F;
    const float upper = local.y < y ? -0.35F : 0.1F;
    return ramp(0.12F + 0.5F * across + upper + 0.12F * crinkle + 0.12F * head.light_x * local.x / w, style.dark,
                style.mid, style.light);
  };
  canvas.shade(canvas.mask(head.at(joined(seam, bow)), 0.9F * s), tone, {.opacity = 0.95F});
  canvas.shade(canvas.mask(head.at(joined(seam, under)), 0.9F * s), tone, {.opacity = 0.95F});
  canvas.glow(head.at(head.light_x * 9, y + 10 * f), 13 * s, 3.4F * s, rgb(0xffffff),
              {.opacity = 0.5F * std::min(f, 1.0F)}, head.tilt_deg);
  canvas.stroke(head.at(seam), {1.5F * s, 3.2F * s, 1.5F * s}, style.dark * 0.45F,
                {.opacity = 0.85F, .soften_px = 0.8F * s});
  for (const float side : {-1.0F, 1.0F}) {
    canvas.glow(head.at(side * (w + 2), y + 1), 4.5F * s, 4 * s, skin.deep, {.opacity = 0.55F});
  }
  canvas.glow(head.at(-7, y - 26 * f), 3 * s, 8 * s, skin.shadow, {.opacity = 0.3F});
}

void paint_brow(Canvas& canvas, const Head& head, const Path& line, float thickness, const Color& dark,
                const Color& light, Dice& dice) {
  const Path spine = smooth(line);
  const float side = line.back().x > line.front().x ? 1.0F : -1.0F;
  canvas.stroke(head.at(spine), {thickness * 0.5F, thickness * head.scale, 1}, dark,
                {.opacity = 0.45F, .soften_px = thickness * 0.22F});
  for (int hair = 0; hair < 130; ++hair) {
    const float t = dice.between(0, 0.98F);
    const Point root = spine[static_cast<std::size_t>(t * static_cast<float>(spine.size() - 1))];
    const float spread = thickness * (0.55F - 0.4F * t);
    const Point a = root + Point(dice.between(-2, 2), dice.between(-spread, spread));
    const float length = dice.between(8, 17) * (0.7F + thickness / 40);
    const Point b = a + Point(side * (0.45F + 0.55F * t), -0.75F + 1.05F * t) * length;
    canvas.stroke(head.at(smooth({a, (a + b) * 0.5F + Point(side, -1), b})), {1.2F, 1.9F * head.scale, 0.3F},
                  mix(dark, light, dice.between(0, 1)), {.opacity = 0.7F});
  }
}

}  // namespace morphkit::samples
