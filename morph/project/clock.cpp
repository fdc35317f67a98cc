#include "morph/project/clock.h"

#include <algorithm>
#include <cmath>

namespace morphkit::project {

Clock::Clock(const Output& output) noexcept : start_(output.start), frames_(output.frames), fps_(output.fps) {}

Time Clock::at_frame(double frame) const noexcept {
  const double t = frames_ <= 1 ? 0 : std::clamp((frame - start_) / (frames_ - 1), 0.0, 1.0);
  return {frame, t};
}

Time Clock::at(double t) const noexcept {
  return {start_ + t * std::max(0, frames_ - 1), t};
}

Time Clock::stepped(double t, int frames) const noexcept {
  const int last = std::max(1, frames_ - 1);
  return at(std::clamp((std::round(t * last) + frames) / last, 0.0, 1.0));
}

double Clock::duration_s() const noexcept {
  return static_cast<double>(frames_) * fps_.den / fps_.num;
}

double Clock::span_s() const noexcept {
  return std::max(1, frames_ - 1) * static_cast<double>(fps_.den) / fps_.num;
}

}  // namespace morphkit::project
