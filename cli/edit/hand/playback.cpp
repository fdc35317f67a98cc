#include "cli/edit/hand/playback.h"

#include <algorithm>
#include <cmath>

namespace morphkit::edit {
namespace {

constexpr double kSlowest = 0.25, kFastest = 4;

}  // namespace

void Playback::tick(double seconds) {
  if (!model_.playing) return;
  const project::Output& output = model_.document.project().output;
  const double length_s = std::max(1, output.frames - 1) * static_cast<double>(output.fps.den) / output.fps.num;
  double t = model_.t + direction_ * seconds * model_.speed / length_s;
  if (t > 1) direction_ = -1;
  if (t < 0) direction_ = 1;
  // Reflected at both ends, as often as it takes.
  t = std::fmod(std::abs(t), 2.0);
  if (t > 1) t = 2 - t;
  model_.t = t;
}

void Playback::step(int frames) {
  model_.playing = false;
  const int last = std::max(1, model_.document.project().output.frames - 1);
  const double frame = std::round(model_.t * last) + frames;
  model_.t = std::clamp(frame / last, 0.0, 1.0);
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
