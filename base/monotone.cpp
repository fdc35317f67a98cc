#include "base/monotone.h"

#include <algorithm>

namespace morphkit {
namespace {

// Slopes in [0, 3 secant] at both ends make a cubic monotone: the square inside Fritsch & Carlson's region. Unlike
// their circle it limits each knot by itself, so a given slope at the next knot does not matter.
double limited(double slope, double secant) {
  return secant >= 0 ? std::clamp(slope, 0.0, 3 * secant) : std::clamp(slope, 3 * secant, 0.0);
}

}  // namespace

double monotone_slope(Secant before, Secant after) {
  if (before.slope * after.slope <= 0) return 0;  // a local extreme stays one
  const double parabola = before.slope + before.width * (after.slope - before.slope) / (before.width + after.width);
  return limited(limited(parabola, before.slope), after.slope);
}

double monotone_end_slope(Secant near, Secant far) {
  // In this form, equal secants give exactly that slope: a map that moves nothing has slope 1.
  const double parabola = near.slope + near.width * (near.slope - far.slope) / (near.width + far.width);
  return limited(parabola, near.slope);
}

}  // namespace morphkit
