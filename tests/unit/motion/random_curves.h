#pragma once

#include <random>
#include <string>
#include <vector>

#include "morph/motion/curve.h"

namespace morphkit::test {

constexpr motion::CurveKind kKinds[] = {motion::CurveKind::kPolyline, motion::CurveKind::kCatmullRom,
                                        motion::CurveKind::kBezier};

struct RandomCurve {
  motion::CurveKind kind;
  bool closed;
  std::vector<cv::Point2d> points;
  std::string name;

  motion::Curve curve() const { return {kind, points, closed}; }
};

/// Between 2 and 7 points in a square of 400 px; Beziers and closed curves get the next allowed number.
inline RandomCurve random_curve(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 400);
  RandomCurve result;
  result.kind = kKinds[random() % 3];
  result.closed = random() % 2 == 0;
  std::size_t count = 2 + random() % 6;
  if (result.closed && count < 3) count = 3;
  if (result.kind == motion::CurveKind::kBezier) count = result.closed ? count / 3 * 3 : 4 + count / 3 * 3;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = place(random), y = place(random);
    result.points.emplace_back(x, y);
  }
  result.name = "seed " + std::to_string(seed) + ", kind " + std::to_string(static_cast<int>(result.kind)) +
                (result.closed ? ", closed, " : ", open, ") + std::to_string(count) + " points";
  return result;
}

constexpr unsigned kRandomCurves = 60;

}  // namespace morphkit::test
