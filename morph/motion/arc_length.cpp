#include "morph/motion/arc_length.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace morphkit::motion {
namespace {

using Node = ArcLength::Node;

// Halves may agree with the whole by chance, so every segment is halved at least this often ...
constexpr int kMinDepth = 3;
// ... and at most this often: 2^-40 of a segment is the size of a cusp at 1e-6 in a curve of 1e6.
constexpr int kMaxDepth = 40;
constexpr double kRoundingShare = 1e-13;

double speed(const Curve& curve, double u) {
  const cv::Point2d d = curve.derivative(u);
  return std::hypot(d.x, d.y);
}

// Gauss-Legendre with five nodes: exact for |Q'| up to degree nine. Its nodes are inside, so no joint is evaluated.
double integrate(const Curve& curve, double from, double to) {
  constexpr std::array kNodes = {0.0, 0.53846931010568309104, 0.90617984593866399280};
  constexpr std::array kWeights = {0.56888888888888888889, 0.47862867049936646804, 0.23692688505618908751};
  const double middle = (from + to) / 2, half = (to - from) / 2;
  double sum = kWeights[0] * speed(curve, middle);
  for (std::size_t i = 1; i < kNodes.size(); ++i) {
    sum += kWeights[i] * (speed(curve, middle - half * kNodes[i]) + speed(curve, middle + half * kNodes[i]));
  }
  return half * sum;
}

// Appends the nodes of (from, to]; `whole` is the integral over it as one piece.
void refine(const Curve& curve, double from, double to, double whole, double tolerance, int depth,
            std::vector<Node>& table) {
  const double middle = (from + to) / 2;
  const double left = integrate(curve, from, middle), right = integrate(curve, middle, to);
  const bool agrees = depth >= kMinDepth && std::abs(left + right - whole) <= tolerance;
  if (agrees || depth == kMaxDepth) {
    table.push_back({middle, table.back().s + left});
    table.push_back({to, table.back().s + right});
    return;
  }
  refine(curve, from, middle, left, tolerance / 2, depth + 1, table);
  refine(curve, middle, to, right, tolerance / 2, depth + 1, table);
}

}  // namespace

ArcLength::ArcLength(Curve curve, double tolerance) : curve_(std::move(curve)), table_{{0, 0}} {
  const int segments = curve_.segments();
  for (int i = 0; i < segments; ++i) {
    const double whole = integrate(curve_, i, i + 1);
    const double share = std::max(tolerance / segments, whole * kRoundingShare);
    refine(curve_, i, i + 1, whole, share, 0, table_);
  }
}

double ArcLength::length_at(double u) const {
  if (!(u > 0)) return 0;
  const auto after = std::upper_bound(table_.begin(), table_.end(), u, [](double x, Node node) { return x < node.u; });
  if (after == table_.end()) return total();
  const Node before = *(after - 1);
  return std::min(before.s + integrate(curve_, before.u, u), after->s);
}

double ArcLength::parameter_at(double s) const {
  if (!(s > 0)) return 0;
  // The first node beyond s. Its interval has a length above 0, even after pieces of length 0.
  const auto after = std::upper_bound(table_.begin(), table_.end(), s, [](double x, Node node) { return x < node.s; });
  if (after == table_.end()) return curve_.segments();
  const Node before = *(after - 1);
  constexpr int kIterations = 60;
  const double enough = total() * 1e-15;
  double low = before.u, high = after->u;
  double u = low + (high - low) * (s - before.s) / (after->s - before.s);
  for (int i = 0; i < kIterations; ++i) {
    const double error = before.s + integrate(curve_, before.u, u) - s;
    if (std::abs(error) <= enough) break;
    (error > 0 ? high : low) = u;
    const double next = u - error / speed(curve_, u);
    u = next > low && next < high ? next : (low + high) / 2;  // also where |Q'| = 0
  }
  return u;
}

}  // namespace morphkit::motion
