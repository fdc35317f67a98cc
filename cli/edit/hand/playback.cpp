#include "cli/edit/hand/playback.h"

#include <algorithm>
#include <cmath>

#include "morph/project/clock.h"

namespace morphkit::edit {
namespace {

constexpr double kSlowest = 0.25, kFastest = 4;

}  // namespace

void Playback::tick(double seconds) {
  if (!model_.playing) return;
  const double span_s = project::Clock(model_.document.project().output).span_s();
  double t = model_.t + direction_ * seconds * model_.speed / span_s;
  if (t > 1) direction_ = -1;
  if (t < 0) direction_ = 1;
  // Reflected at both ends, as often as it takes.
  t = std::fmod(std::abs(t), 2.0);
  if (t > 1) t = 2 - t;
  model_.t = t;
}

void Playback::step(int frames) {
  model_.playing = false;
  model_.t = project::Clock(model_.document.project().output).stepped(model_.t, frames).t;
}

void Playback::go_to(double t) {
  model_.playing = false;
  model_.t = t;
}

void Playback::multiply_speed(double factor) {
  model_.speed = std::clamp(model_.speed * factor, kSlowest, kFastest);
}

void Playback::next_speed() {
  model_.speed = model_.speed >= kFastest ? kSlowest : model_.speed * 2;
}

}  // namespace morphkit::edit
