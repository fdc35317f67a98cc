#pragma once
// Frames, progress and seconds of a morph, and every formula between them.

#include "morph/project/project.h"

namespace morphkit::project {

/// A moment of a morph.
struct Time {
  double frame = 1;  ///< as numbered in files; may lie between two frames
  double t = 0;      ///< progress, in [0, 1]
};

class Clock {
 public:
  explicit Clock(const Output& output) noexcept;

  int first() const noexcept { return start_; }
  int last() const noexcept { return start_ + frames_ - 1; }

  /// t is 0 at the first frame and before it, 1 at the last one and after it; 0 if there is only one.
  Time at_frame(double frame) const noexcept;
  Time at(double t) const noexcept;

  /// The frame that is `frames` after the one nearest to t, not beyond either end.
  Time stepped(double t, int frames) const noexcept;

  double duration_s() const noexcept;  ///< all frames, each shown for its time
  double span_s() const noexcept;      ///< from the first frame to the last; one frame counts as two

 private:
  int start_, frames_;
  Rate fps_;
};

}  // namespace morphkit::project
