#include "warp/mesh/mesh_curves.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/monotone.h"

namespace morphkit::warp {
namespace {

/// How far a curve may stray from its own polyline, as a part of the distance to the next polyline. Below a half, so
/// that two neighbours that stray towards each other do not meet.
constexpr double kStray = 0.45;

/// The gap on the outer side of the outermost curves, which have no neighbour there.
constexpr double kFree = 1e300;

/// Knots closer than this count as one.
constexpr double kNoWidth = 1e-12;

Secant secant(std::span<const double> x, std::span<const double> y, std::size_t i) {
  const double width = x[i + 1] - x[i];
  return width > kNoWidth ? Secant{width, (y[i + 1] - y[i]) / width} : Secant{kNoWidth, 0};
}

/// The segment of rising knots that contains x; beyond the ends, the first or last one.
std::size_t segment_of(std::span<const double> knots, double x) {
  const auto after = std::upper_bound(knots.begin() + 1, knots.end() - 1, x);
  return static_cast<std::size_t>(after - knots.begin()) - 1;
}

/// A slope of 0 at the border is monotone, but it would smear the border over many pixels.
double at_least_half(double slope, double secant) {
  return std::abs(slope) < std::abs(secant) / 2 ? secant / 2 : slope;
}

double slope_at(MeshSpline spline, std::span<const double> x, std::span<const double> y, std::size_t i) {
  const std::size_t last = x.size() - 1;
  if (last == 1) return secant(x, y, 0).slope;
  if (spline == MeshSpline::kMonotone) {
    if (i == 0) return at_least_half(monotone_end_slope(secant(x, y, 0), secant(x, y, 1)), secant(x, y, 0).slope);
    if (i == last)
      return at_least_half(monotone_end_slope(secant(x, y, last - 1), secant(x, y, last - 2)),
                           secant(x, y, last - 1).slope);
    return monotone_slope(secant(x, y, i - 1), secant(x, y, i));
  }
  const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, last);
  const double width = x[after] - x[before];
  return width > kNoWidth ? (y[after] - y[before]) / width : 0;
}

}  // namespace

void spline_slopes(MeshSpline spline, std::span<const double> x, std::span<const double> y, std::span<double> slopes) {
  for (std::size_t i = 0; i < x.size(); ++i) slopes[i] = slope_at(spline, x, y, i);
}

/// A coordinate on one curve: between knot `first` and the next, at the fraction u.
struct CurveFamily::Place {
  std::size_t first;
  double u, width;
};

CurveFamily::CurveFamily(MeshSpline spline, std::size_t knots, std::vector<double> along, std::vector<double> across)
    : spline_(spline), knots_(knots), along_(std::move(along)), across_(std::move(across)), slopes_(across_.size()) {
  for (std::size_t begin = 0; begin < along_.size(); begin += knots_) {
    const std::span<double> rising(along_.data() + begin, knots_);
    for (std::size_t i = 1; i < knots_; ++i) rising[i] = std::max(rising[i], rising[i - 1]);
    spline_slopes(spline_, rising, {across_.data() + begin, knots_}, {slopes_.data() + begin, knots_});
  }
}

CurveFamily::Place CurveFamily::place(std::size_t curve, double at, Hints& hints) const {
  const double* const along = along_.data() + curve * knots_;
  std::size_t& i = hints[curve];
  if (i == kUnknown) i = segment_of({along, knots_}, at);
  while (i > 0 && at < along[i]) --i;
  while (i + 2 < knots_ && at >= along[i + 1]) ++i;
  const double width = along[i + 1] - along[i];
  const double u = width > kNoWidth ? std::clamp((at - along[i]) / width, 0.0, 1.0) : 0;
  return {curve * knots_ + i, u, width};
}

double CurveFamily::linear(const Place& place) const {
  return std::lerp(across_[place.first], across_[place.first + 1], place.u);
}

double CurveFamily::cubic(const Place& place) const {
  const double u = place.u, v = 1 - u;
  const double a = across_[place.first], b = across_[place.first + 1];
  // The Hermite basis as a correction of the straight line: 0 where the curve is straight.
  const double rise = b - a;
  return std::lerp(a, b, u) +
         u * v *
             (v * (place.width * slopes_[place.first] - rise) - u * (place.width * slopes_[place.first + 1] - rise));
}

double CurveFamily::ordered(double linear, double cubic, double gap_before, double gap_after) const {
  // Each curve alone is monotone, but two neighbours through slanting vertices may still cross between vertices where
  // their polylines do not. With both kept within kStray of the gap, a tenth of the gap remains.
  if (spline_ != MeshSpline::kMonotone) return cubic;
  const double most = kStray * std::max(0.0, std::min(gap_before, gap_after));
  return linear + std::clamp(cubic - linear, -most, most);
}

void CurveFamily::intercepts(double at, Hints& hints, std::span<double> across) const {
  const std::size_t n = curves();
  Place here = place(0, at, hints);
  double here_linear = linear(here), gap_before = kFree;
  for (std::size_t i = 0; i < n; ++i) {
    const Place next = i + 1 < n ? place(i + 1, at, hints) : here;
    const double next_linear = linear(next);
    const double gap_after = i + 1 < n ? next_linear - here_linear : kFree;
    across[i] = spline_ == MeshSpline::kLinear ? here_linear : ordered(here_linear, cubic(here), gap_before, gap_after);
    here = next;
    here_linear = next_linear;
    gap_before = gap_after;
  }
}

double CurveFamily::intercept(std::size_t curve, double at, Hints& hints) const {
  const Place here = place(curve, at, hints);
  const double here_linear = linear(here);
  if (spline_ != MeshSpline::kMonotone) return spline_ == MeshSpline::kLinear ? here_linear : cubic(here);
  const double gap_before = curve > 0 ? here_linear - linear(place(curve - 1, at, hints)) : kFree;
  const double gap_after = curve + 1 < curves() ? linear(place(curve + 1, at, hints)) - here_linear : kFree;
  return ordered(here_linear, cubic(here), gap_before, gap_after);
}

void LineKnots::resize(std::size_t count) {
  to.resize(count);
  from.resize(count);
  slopes.resize(count);
}

void LineKnots::prepare(MeshSpline kind, double most) {
  spline = kind;
  // Clamp first: if knots were clamped later, their slopes would be too steep.
  for (double& place : from) place = std::clamp(place, 0.0, most);
  for (std::size_t i = 1; i < to.size(); ++i) {
    to[i] = std::max(to[i], to[i - 1]);
    from[i] = std::max(from[i], from[i - 1]);
  }
  if (spline != MeshSpline::kLinear) spline_slopes(spline, to, from, slopes);
}

LineKnots::Cubic LineKnots::cubic(std::size_t segment) const {
  const std::size_t next = segment + 1;
  const double width = to[next] - to[segment];
  Cubic cubic;
  cubic.c0 = from[segment] - to[segment];
  if (width <= kNoWidth) return cubic;
  cubic.inverse_width = 1 / width;
  const double rise = from[next] - to[next] - cubic.c0;
  cubic.c1 = rise;
  if (spline == MeshSpline::kLinear) return cubic;
  const double start = width * (slopes[segment] - 1), end = width * (slopes[next] - 1);
  cubic.c1 = start;
  cubic.c2 = 3 * rise - 2 * start - end;
  cubic.c3 = start + end - 2 * rise;
  return cubic;
}

double LineKnots::at(double x, std::size_t& segment) const {
  if (x < to.front()) return from.front();
  if (x >= to.back()) return from.back();
  if (segment == kUnknown) segment = segment_of(to, x);
  while (segment > 0 && x < to[segment]) --segment;
  while (segment + 2 < to.size() && x >= to[segment + 1]) ++segment;
  const Cubic c = cubic(segment);
  const double u = (x - to[segment]) * c.inverse_width;
  return std::clamp(x + (c.c0 + u * (c.c1 + u * (c.c2 + u * c.c3))), from[segment], from[segment + 1]);
}

void LineKnots::edges(std::span<double> edges) {
  const std::size_t n = edges.size();
  cubics_.clear();
  cubics_.reserve(to.size());
  for (std::size_t i = 0; i + 1 < to.size(); ++i) cubics_.push_back(cubic(i));
  fill_edges(*this, cubics_, edges);
  const auto at = [&](double place) { return edges.begin() + static_cast<std::ptrdiff_t>(whole_from(place, n)); };
  std::fill(edges.begin(), at(to.front()), from.front());
  std::fill(at(to.back()), edges.end(), from.back());
  if (spline != MeshSpline::kCatmullRom) return;  // it may overshoot and turn back
  for (std::size_t i = 1; i < n; ++i) edges[i] = std::max(edges[i], edges[i - 1]);
}

MeshPass::Hints MeshPass::hints() const {
  return {CurveFamily::Hints(to.curves(), kUnknown), CurveFamily::Hints(from.curves(), kUnknown)};
}

void MeshPass::knots(double along, double most, Hints& hints, LineKnots& knots) const {
  knots.resize(to.curves());
  to.intercepts(along, hints.to, knots.to);
  from.intercepts(along, hints.from, knots.from);
  knots.prepare(spline, most);
}

double MeshPass::at(double along, double x, double most, Hints& hints, std::size_t& segment) const {
  const std::size_t curves = to.curves();
  if (segment == kUnknown) {
    segment = 0;
    for (std::size_t end = curves - 1; end - segment > 1;) {
      const std::size_t middle = (segment + end) / 2;
      (to.intercept(middle, along, hints.to) <= x ? segment : end) = middle;
    }
  }
  while (segment > 0 && x < to.intercept(segment, along, hints.to)) --segment;
  while (segment + 2 < curves && x >= to.intercept(segment + 1, along, hints.to)) ++segment;
  // The slopes at both ends of the segment depend on the next curve on either side.
  const std::size_t first = segment > 0 ? segment - 1 : 0;
  const std::size_t count = std::min(segment + 3, curves) - first;
  thread_local LineKnots knots;
  knots.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    knots.to[i] = to.intercept(first + i, along, hints.to);
    knots.from[i] = from.intercept(first + i, along, hints.from);
  }
  knots.prepare(spline, most);
  std::size_t local = segment - first;
  return knots.at(x, local);
}

}  // namespace morphkit::warp
