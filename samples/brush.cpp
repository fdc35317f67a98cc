#include "samples/brush.h"

#include <algorithm>
#include <cmath>

namespace morphkit::samples {

namespace {

constexpr int kStepsPerSpan = 12;
constexpr float kDegree = static_cast<float>(CV_PI / 180.0);

// Adds one edge to the running-sum buffer of signed areas: after a prefix sum along each row, a cell holds the part of
// the pixel that lies right of the edges, counted with their direction.
void add_edge(cv::Mat1f& areas, Point from, Point to) {
  const float direction = from.y < to.y ? 1.0F : -1.0F;
  if (from.y > to.y) {
    std::swap(from, to);
  }
  const float top = std::max(from.y, 0.0F);
  const float bottom = std::min(to.y, static_cast<float>(areas.rows));
  const float right = static_cast<float>(areas.cols - 2);
  for (int row = static_cast<int>(top); static_cast<float>(row) < bottom; ++row) {
    const float y0 = std::max(top, static_cast<float>(row));
    const float y1 = std::min(bottom, static_cast<float>(row + 1));
    const float slope = (to.x - from.x) / (to.y - from.y);
    const float xa = std::clamp(from.x + (y0 - from.y) * slope, 0.0F, right);
    const float xb = std::clamp(from.x + (y1 - from.y) * slope, 0.0F, right);
    const float x0 = std::min(xa, xb);
    const float x1 = std::max(xa, xb);
    const float area = direction * (y1 - y0);
    for (int column = static_cast<int>(x0); column <= static_cast<int>(x1); ++column) {
      const float left_end = std::max(x0, static_cast<float>(column));
      const float right_end = std::min(x1, static_cast<float>(column + 1));
      const float part = x1 > x0 ? area * (right_end - left_end) / (x1 - x0) : area;
      const float middle = 0.5F * (left_end + right_end) - static_cast<float>(column);
      areas(row, column) += part * (1 - middle);
      areas(row, column + 1) += part * middle;
    }
  }
}

// One pass of a moving average of `radius` cells to each side, along the rows of `from`, written transposed.
void box_pass_transposed(const cv::Mat1f& from, cv::Mat1f& to, int radius) {
  const float scale = 1.0F / static_cast<float>(2 * radius + 1);
  for (int y = 0; y < from.rows; ++y) {
    double sum = 0;
    for (int x = 0; x < std::min(radius, from.cols); ++x) {
      sum += from(y, x);
    }
    for (int x = 0; x < from.cols; ++x) {
      sum += x + radius < from.cols ? from(y, x + radius) : 0.0F;
      to(x, y) = static_cast<float>(sum) * scale;
      sum -= x - radius >= 0 ? from(y, x - radius) : 0.0F;
    }
  }
}

// Three moving averages in each direction: close to a Gaussian, and its cost does not depend on sigma.
void blur(cv::Mat1f& image, float sigma) {
  const int radius = std::max(1, static_cast<int>(std::lround((std::sqrt(4 * sigma * sigma + 1) - 1) / 2)));
  cv::Mat1f turned(image.cols, image.rows);
  for (int pass = 0; pass < 3; ++pass) {
    box_pass_transposed(image, turned, radius);
    box_pass_transposed(turned, image, radius);
  }
}

}  // namespace

Color rgb(std::uint32_t hex) {
  return Color(static_cast<float>((hex >> 16U) & 255U), static_cast<float>((hex >> 8U) & 255U),
               static_cast<float>(hex & 255U)) /
         255.0F;
}

Color mix(const Color& a, const Color& b, float t) {
  return a * (1 - t) + b * t;
}

Color ramp(float t, const Color& dark, const Color& mid, const Color& light) {
  t = std::clamp(t, 0.0F, 1.0F);
  return t < 0.5F ? mix(dark, mid, 2 * t) : mix(mid, light, 2 * t - 1);
}

float smooth_step(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

Path smooth(const Path& through, bool closed) {
  const int count = static_cast<int>(through.size());
  const auto at = [&](int i) {
    const int index = closed ? (i + count) % count : std::clamp(i, 0, count - 1);
    return through[static_cast<std::size_t>(index)];
  };
  Path fine;
  for (int span = 0; span < (closed ? count : count - 1); ++span) {
    const Point a = at(span - 1), b = at(span), c = at(span + 1), d = at(span + 2);
    for (int step = 0; step < kStepsPerSpan; ++step) {
      const float t = static_cast<float>(step) / kStepsPerSpan;
      // Catmull and Rom, 1974: tangents are half the chord of the neighbours.
      fine.push_back(0.5F *
                     (2 * b + t * (c - a) + t * t * (2 * a - 5 * b + 4 * c - d) + t * t * t * (3 * b - a - 3 * c + d)));
    }
  }
  if (!closed) {
    fine.push_back(through.back());
  }
  return fine;
}

Path ellipse(Point center, float radius_x, float radius_y, float angle_deg) {
  constexpr int kCorners = 96;
  const float cosine = std::cos(angle_deg * kDegree);
  const float sine = std::sin(angle_deg * kDegree);
  Path path;
  for (int corner = 0; corner < kCorners; ++corner) {
    const float angle = static_cast<float>(2 * CV_PI) * static_cast<float>(corner) / kCorners;
    const Point p(radius_x * std::cos(angle), radius_y * std::sin(angle));
    path.push_back(center + Point(p.x * cosine - p.y * sine, p.x * sine + p.y * cosine));
  }
  return path;
}

Path mirrored(const Path& path, float axis) {
  Path result;
  for (auto p = path.rbegin(); p != path.rend(); ++p) {
    result.emplace_back(2 * axis - p->x, p->y);
  }
  return result;
}

Path joined(Path first, const Path& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Path outline(const Path& line, Taper width_px) {
  const std::size_t last = line.size() - 1;
  Path left, right;
  for (std::size_t i = 0; i <= last; ++i) {
    const Point along = line[std::min(i + 1, last)] - line[i == 0 ? 0 : i - 1];
    const float length = std::max(1e-6F, std::hypot(along.x, along.y));
    const float t = static_cast<float>(i) / static_cast<float>(std::max<std::size_t>(last, 1));
    const float bump = 4 * t * (1 - t);
    const float width = (width_px.start * (1 - t) + width_px.end * t) * (1 - bump) + width_px.middle * bump;
    const Point half = Point(-along.y, along.x) * (0.5F * width / length);
    left.push_back(line[i] + half);
    right.push_back(line[i] - half);
  }
  std::reverse(right.begin(), right.end());
  return joined(std::move(left), right);
}

Mask Canvas::mask(const Path& outline, float soften_px) const {
  float x0 = outline[0].x, x1 = x0, y0 = outline[0].y, y1 = y0;
  for (const Point& p : outline) {
    x0 = std::min(x0, p.x);
    x1 = std::max(x1, p.x);
    y0 = std::min(y0, p.y);
    y1 = std::max(y1, p.y);
  }
  const int room = 1 + static_cast<int>(std::ceil(3 * soften_px));
  cv::Rect box(cv::Point(static_cast<int>(std::floor(x0)) - room, static_cast<int>(std::floor(y0)) - room),
               cv::Point(static_cast<int>(std::ceil(x1)) + room, static_cast<int>(std::ceil(y1)) + room));
  box &= cv::Rect(-room, -room, width() + 2 * room, height() + 2 * room);
  if (box.empty()) {
    return {};
  }
  cv::Mat1f areas(box.height, box.width + 2, 0.0F);
  const Point origin(static_cast<float>(box.x), static_cast<float>(box.y));
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point from = outline[i] - origin;
    const Point to = outline[(i + 1) % outline.size()] - origin;
    if (from.y != to.y) {
      add_edge(areas, from, to);
    }
  }
  Mask result{box.tl(), cv::Mat1f(box.height, box.width)};
  for (int y = 0; y < box.height; ++y) {
    float sum = 0;
    for (int x = 0; x < box.width; ++x) {
      sum += areas(y, x);
      result.coverage(y, x) = std::min(std::abs(sum), 1.0F);
    }
  }
  if (soften_px > 0) {
    blur(result.coverage, soften_px);
  }
  return result;
}

void Canvas::fill(const Path& outline, const Color& color, const Brush& brush) {
  shade(
      mask(outline, brush.soften_px), [&](Point) { return color; }, brush);
}

void Canvas::stroke(const Path& line, Taper width_px, const Color& color, const Brush& brush) {
  fill(outline(line, width_px), color, brush);
}

void Canvas::glow(Point center, float sigma_x, float sigma_y, const Color& color, const Brush& brush, float angle_deg) {
  const float cosine = std::cos(angle_deg * kDegree);
  const float sine = std::sin(angle_deg * kDegree);
  const int reach = static_cast<int>(std::ceil(3.2F * std::max(sigma_x, sigma_y)));
  cv::Rect box(static_cast<int>(center.x) - reach, static_cast<int>(center.y) - reach, 2 * reach + 1, 2 * reach + 1);
  box &= cv::Rect(0, 0, width(), height());
  for (int y = box.y; y < box.y + box.height; ++y) {
    for (int x = box.x; x < box.x + box.width; ++x) {
      const Point d = Point(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F) - center;
      const float u = (d.x * cosine + d.y * sine) / sigma_x;
      const float v = (d.y * cosine - d.x * sine) / sigma_y;
      // Reaches zero at 3.2 sigma, so the edge of the box is invisible.
      const float bell = std::max(0.0F, std::exp(-0.5F * (u * u + v * v)) - 0.006F);
      const float alpha = brush.opacity * bell * (brush.clip != nullptr ? brush.clip->at(x, y) : 1.0F);
      if (alpha > 0) {
        lay(x, y, color, std::min(alpha, 1.0F));
      }
    }
  }
}

cv::Mat4b Canvas::to_8bit() const {
  cv::Mat4b result(pixels_.size());
  for_rows(height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < width(); ++x) {
        const cv::Vec4f& p = pixels_(y, x);
        const float dither = static_cast<float>(hash(x, y, 77) >> 8U) / 16777216.0F;
        cv::Vec4b& out = result(y, x);
        for (int c = 0; c < 3; ++c) {
          const float straight = p[3] > 0 ? p[c] / p[3] : 0.0F;
          out[c] = static_cast<uchar>(std::clamp(straight * 255.0F + dither, 0.0F, 255.0F));
        }
        out[3] = static_cast<uchar>(std::clamp(p[3] * 255.0F + 0.5F, 0.0F, 255.0F));
      }
    }
  });
  return result;
}

void paint_lock(Canvas& canvas, const Lock& lock, Dice& dice, const Mask* clip) {
  for (int strand = 0; strand < lock.strands; ++strand) {
    const float across = dice.between(0, 1);
    const float slide = dice.between(-lock.jitter_px, lock.jitter_px);
    Path line;
    for (std::size_t i = 0; i < lock.first.size(); ++i) {
      const Point wobble(dice.between(-0.4F, 0.4F) * lock.jitter_px, dice.between(-0.4F, 0.4F) * lock.jitter_px);
      line.push_back(lock.first[i] * (1 - across) + lock.second[i] * across + wobble + Point(slide, slide * 0.5F));
    }
    // Neighbouring strands share a tone: this makes it a lock and not a doormat.
    const float tone = 0.65F * value_noise(Point(across * 9, 0.5F), 5) + 0.35F * dice.between(0, 1);
    const float scale = dice.between(0.6F, 1.3F);
    const Taper width{lock.width_px.start * scale, lock.width_px.middle * scale, lock.width_px.end * scale};
    canvas.stroke(smooth(line), width, ramp(1.3F * tone - 0.15F, lock.dark, lock.mid, lock.light),
                  {.opacity = lock.opacity, .soften_px = 0, .clip = clip});
  }
}

}  // namespace morphkit::samples
