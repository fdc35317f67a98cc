#pragma once
// Integer-hashed noise and dice. The distributions of <random> differ between standard libraries; these do not.

#include <cstdint>

#include <opencv2/core.hpp>

namespace morphkit::samples {

/// A well-mixed 32-bit hash of a lattice point.
std::uint32_t hash(std::int32_t x, std::int32_t y, std::uint32_t seed);

/// Smooth noise in [0, 1] with one feature per unit.
float value_noise(cv::Point2f p, std::uint32_t seed);

/// Sum of `octaves` of value_noise, each twice as fine and half as strong; in [0, 1].
float fractal_noise(cv::Point2f p, int octaves, std::uint32_t seed);

/// A stream of uniform numbers; the same stream for the same seed on every machine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}

  /// Uniform in [low, high).
  float between(float low, float high);

 private:
  std::uint64_t state_;
};

}  // namespace morphkit::samples
