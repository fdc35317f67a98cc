#pragma once
// Playing, and moving through time.

#include "cli/edit/view/model.h"

namespace morphkit::edit {

/// Moves Model::t. Owns the direction of playing.
class Playback {
 public:
  explicit Playback(Model& model) : model_(model) {}

  /// Plays forward and backward, at the project's rate times Model::speed.
  void tick(double seconds);
  void toggle() { model_.playing = !model_.playing; }
  void step(int frames);  ///< stops
  void go_to(double t);   ///< stops
  void multiply_speed(double factor);
  void next_speed();  ///< doubles it; after the fastest comes the slowest

 private:
  Model& model_;
  double direction_ = 1;
};

}  // namespace morphkit::edit
