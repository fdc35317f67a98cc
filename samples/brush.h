#pragma once
// A small paintbox: paths, antialiased masks, soft edges, and a canvas to lay colour on.
//
// Colours are display-referred (sRGB code values over 255), because gradients look even there. Coordinates are
// morphkit's pixels: (0, 0) is the outer corner of the top left pixel.

#include <cmath>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "base/parallel.h"
#include "samples/noise.h"

namespace morphkit::samples {

using Point = cv::Point2f;
using Path = std::vector<Point>;
using Color = cv::Vec3f;

/// 0xRRGGBB as a colour.
Color rgb(std::uint32_t hex);

Color mix(const Color& a, const Color& b, float t);

/// dark at t <= 0, mid at 0.5, light at t >= 1.
Color ramp(float t, const Color& dark, const Color& mid, const Color& light);

/// Cubic step from 0 at `low` to 1 at `high`.
float smooth_step(float low, float high, float x);

/// Catmull-Rom curve through the points, as a fine polyline.
Path smooth(const Path& through, bool closed = false);

Path ellipse(Point center, float radius_x, float radius_y, float angle_deg = 0);

/// The path mirrored at the vertical line x = axis, running the other way round so that outlines can be joined.
Path mirrored(const Path& path, float axis = 0);

Path joined(Path first, const Path& second);

/// A tapered line as a closed outline: width_px grows from `start` to `middle` and back to `end`.
struct Taper {
  float start = 0;
  float middle = 2;
  float end = 0;
};
Path outline(const Path& line, Taper width_px);

/// Coverage in [0, 1] over a part of the canvas.
struct Mask {
  cv::Point origin;
  cv::Mat1f coverage;

  float at(int x, int y) const {
    const cv::Point p(x - origin.x, y - origin.y);
    const bool inside = p.x >= 0 && p.y >= 0 && p.x < coverage.cols && p.y < coverage.rows;
    return inside ? coverage(p.y, p.x) : 0.0F;
  }
};

/// How a colour is painted.
struct Brush {
  float opacity = 1;
  float soften_px = 0;         ///< standard deviation of the edge's blur
  const Mask* clip = nullptr;  ///< paint only here
};

class Canvas {
 public:
  Canvas(int width, int height) : pixels_(cv::Mat4f::zeros(height, width)) {}

  int width() const { return pixels_.cols; }
  int height() const { return pixels_.rows; }

  /// Area coverage of a closed outline (nonzero winding rule), clipped to the canvas with room for the blur.
  Mask mask(const Path& outline, float soften_px = 0) const;

  /// Paints shader(point) -> Color over the mask.
  template <typename Shader>
  void shade(const Mask& mask, const Shader& shader, const Brush& brush = {});

  /// Paints shader(point) -> cv::Vec4f (unpremultiplied colour and opacity) over the whole canvas.
  template <typename Shader>
  void wash(const Shader& shader, const Mask* clip = nullptr);

  void fill(const Path& outline, const Color& color, const Brush& brush = {});
  void stroke(const Path& line, Taper width_px, const Color& color, const Brush& brush = {});

  /// A round blob that fades like a Gaussian of the given standard deviations.
  void glow(Point center, float sigma_x, float sigma_y, const Color& color, const Brush& brush, float angle_deg = 0);

  /// Unpremultiplied RGBA, dithered by less than one code value so that gradients do not band.
  cv::Mat4b to_8bit() const;

 private:
  void lay(int x, int y, const Color& color, float alpha) {
    cv::Vec4f& under = pixels_(y, x);
    under *= 1 - alpha;
    under += cv::Vec4f(color[0] * alpha, color[1] * alpha, color[2] * alpha, alpha);
  }

  cv::Mat4f pixels_;  // premultiplied
};

/// A lock of hair: strands between two guide lines with the same number of points.
struct Lock {
  Path first, second;
  int strands = 100;
  Taper width_px{0.8F, 2.4F, 0.4F};
  float jitter_px = 4;
  Color dark, mid, light;
  float opacity = 0.6F;
};
void paint_lock(Canvas& canvas, const Lock& lock, Dice& dice, const Mask* clip = nullptr);

template <typename Shader>
void Canvas::shade(const Mask& mask, const Shader& shader, const Brush& brush) {
  const cv::Rect box = cv::Rect(mask.origin, mask.coverage.size()) & cv::Rect(0, 0, width(), height());
  for_rows(box.height, [&](int begin, int end) {
    for (int y = box.y + begin; y < box.y + end; ++y) {
      for (int x = box.x; x < box.x + box.width; ++x) {
        float alpha = brush.opacity * mask.at(x, y);
        if (brush.clip != nullptr) {
          alpha *= brush.clip->at(x, y);
        }
        if (alpha > 0) {
          lay(x, y, shader(Point(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F)), alpha);
        }
      }
    }
  });
}

template <typename Shader>
void Canvas::wash(const Shader& shader, const Mask* clip) {
  for_rows(height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < width(); ++x) {
        const cv::Vec4f c = shader(Point(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F));
        lay(x, y, Color(c[0], c[1], c[2]), c[3] * (clip != nullptr ? clip->at(x, y) : 1.0F));
      }
    }
  });
}

}  // namespace morphkit::samples
