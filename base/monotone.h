#pragma once
// Slopes for a piecewise cubic: it is monotone wherever its knots are.
// Fritsch and Carlson, "Monotone Piecewise Cubic Interpolation", SIAM J. Numer. Anal. 17(2), 1980.

namespace morphkit {

/// The interval between two knots: its width (> 0) and (y1 - y0) / width.
struct Secant {
  double width = 1, slope = 0;
};

/// Slope at the knot between two intervals: the slope of the parabola through the three knots, clamped to [0, 3 secant]
/// of both sides; 0 at a local extreme.
double monotone_slope(Secant before, Secant after);

/// Slope at the outer knot of `near`; `far` is the interval beyond it.
double monotone_end_slope(Secant near, Secant far);

}  // namespace morphkit
