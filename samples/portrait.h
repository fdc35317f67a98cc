#pragma once
// The parts of every painted face. A sitter is described in head space: the origin lies between the eyes, x points to
// the right of the picture, y down, and the chin is near y = 230. `Head` maps head space to the canvas.

#include "samples/brush.h"

namespace morphkit::samples {

/// Position and pose of the head.
struct Head {
  Point center;        ///< canvas position of the point between the eyes
  float scale = 1;     ///< canvas pixels per head unit
  float tilt_deg = 0;  ///< clockwise
  float turn = 0;      ///< shift of the middle of the face, head units: a turn of the head
  float light_x = -1;  ///< -1: light from the left of the picture, 1: from the right

  Point at(float x, float y) const;
  Path at(const Path& path) const;
  Point to_head(Point canvas) const;  ///< inverse of `at`, except for the turn
};

struct Skin {
  Color deep, shadow, mid, light, blush;
};

struct EyeStyle {
  float half_width = 37;
  float opening = 1;  ///< 1: wide awake
  float iris_radius = 17;
  Color iris_dark, iris_light, lash;
  bool lashes = false;
};

struct NoseStyle {
  float length = 92;  ///< y of the tip
  float half_width = 27;
};

struct LipStyle {
  float y = 148;
  float half_width = 48;
  float fullness = 1;
  Color dark, mid, light;
};

/// Position of the middle of the eye in head space; side is -1 (left in the picture) or 1.
inline Point eye_center(float side) {
  return {side * 68, 0};
}

/// Colour of a rounded head under the head's light.
Color skin_tone(const Head& head, const Skin& skin, Point canvas);

void paint_eye(Canvas& canvas, const Head& head, const Skin& skin, const EyeStyle& style, float side);
void paint_nose(Canvas& canvas, const Head& head, const Skin& skin, const NoseStyle& style, const Mask& face);
void paint_lips(Canvas& canvas, const Head& head, const Skin& skin, const LipStyle& style);

/// A brow of short hairs along `line` (head space, from the nose outwards).
void paint_brow(Canvas& canvas, const Head& head, const Path& line, float thickness, const Color& dark,
                const Color& light, Dice& dice);

}  // namespace morphkit::samples
