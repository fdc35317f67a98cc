// Curves as chains of chords at equal arc length.

#include <algorithm>
#include <cmath>
#include <vector>

#include "morph/motion/arc_length.h"
#include "morph/motion/curve.h"

namespace morphkit::motion {

std::vector<cv::Point2d> equal_arc_points(const Curve& curve, int n) {
  const ArcLength arc(curve);
  std::vector<cv::Point2d> points(static_cast<std::size_t>(n) + 1);
  for (int i = 0; i <= n; ++i) {
    const double u = i == n ? curve.segments() : arc.parameter_at(arc.total() * i / n);
    points[static_cast<std::size_t>(i)] = curve.at(u);
  }
  return points;
}

namespace {

struct Sample {
  double s;
  cv::Point2d point;
};

// Samples are at most 1/8 chord apart. The one nearest to the top of an arc (a parabola) is then at most 1/16 chord
// away and misses 1/64 of the arc's height. The nodes of the table add joints and cusps, where the top is sharp.
constexpr int kSamplesPerChord = 8;
constexpr double kSeenShare = 63.0 / 64.0;

std::vector<Sample> dense_samples(const ArcLength& arc, int limit) {
  std::vector<Sample> samples;
  const int count = limit * kSamplesPerChord;
  for (int i = 0; i <= count; ++i) {
    const double s = arc.total() * i / count;
    samples.push_back({s, arc.curve().at(arc.parameter_at(s))});
  }
  for (const ArcLength::Node node : arc.table()) samples.push_back({node.s, arc.curve().at(node.u)});
  std::ranges::stable_sort(samples, {}, &Sample::s);
  return samples;
}

double distance(cv::Point2d p, cv::Point2d a, cv::Point2d b) {
  const cv::Point2d chord = b - a, to_point = p - a;
  const double square = chord.dot(chord);
  const double along = square > 0 ? std::clamp(to_point.dot(chord) / square, 0.0, 1.0) : 0;
  const cv::Point2d off = to_point - chord * along;
  return std::hypot(off.x, off.y);
}

bool within(const ArcLength& arc, const std::vector<Sample>& samples, int chords, double tolerance_px) {
  auto sample = samples.begin();
  cv::Point2d begin = arc.curve().at(0);
  for (int i = 1; i <= chords; ++i) {
    const double end_s = arc.total() * i / chords;
    const cv::Point2d end = arc.curve().at(arc.parameter_at(end_s));
    for (; sample != samples.end() && sample->s <= end_s; ++sample) {
      if (distance(sample->point, begin, end) > tolerance_px) return false;
    }
    begin = end;
  }
  return true;
}

}  // namespace

int chords_needed(const Curve& curve, double tolerance_px, int limit) {
  const ArcLength arc(curve);
  const std::vector<Sample> samples = dense_samples(arc, limit);
  for (int n = curve.closed() ? 3 : 1; n < limit; ++n) {
    if (within(arc, samples, n, tolerance_px * kSeenShare)) return n;
  }
  return limit;
}

}  // namespace morphkit::motion
