#include "samples/noise.h"

#include <cmath>

namespace morphkit::samples {

namespace {

constexpr float kOneOver24Bits = 1.0F / 16777216.0F;

float lattice(std::int32_t x, std::int32_t y, std::uint32_t seed) {
  return static_cast<float>(hash(x, y, seed) >> 8U) * kOneOver24Bits;
}

float fade(float t) {
  return t * t * t * (t * (t * 6.0F - 15.0F) + 10.0F);
}

}  // namespace

std::uint32_t hash(std::int32_t x, std::int32_t y, std::uint32_t seed) {
  std::uint32_t h = seed * 0x9E3779B1U;
  for (const auto part : {static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)}) {
    h ^= part + 0x7F4A7C15U + (h << 6U) + (h >> 2U);
    h = (h ^ (h >> 16U)) * 0x85EBCA6BU;
    h = (h ^ (h >> 13U)) * 0xC2B2AE35U;
    h ^= h >> 16U;
  }
  return h;
}

float value_noise(cv::Point2f p, std::uint32_t seed) {
  const float x_floor = std::floor(p.x);
  const float y_floor = std::floor(p.y);
  const auto x = static_cast<std::int32_t>(x_floor);
  const auto y = static_cast<std::int32_t>(y_floor);
  const float u = fade(p.x - x_floor);
  const float v = fade(p.y - y_floor);
  const float top = lattice(x, y, seed) * (1 - u) + lattice(x + 1, y, seed) * u;
  const float bottom = lattice(x, y + 1, seed) * (1 - u) + lattice(x + 1, y + 1, seed) * u;
  return top * (1 - v) + bottom * v;
}

float fractal_noise(cv::Point2f p, int octaves, std::uint32_t seed) {
  float sum = 0;
  float total = 0;
  float strength = 1;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += strength * value_noise(p, seed + static_cast<std::uint32_t>(octave));
    total += strength;
    strength *= 0.5F;
    p *= 2.0F;
  }
  return sum / total;
}

float Dice::between(float low, float high) {
  // SplitMix64: Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", 2014.
  state_ += 0x9E3779B97F4A7C15ULL;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  z ^= z >> 31U;
  return low + (high - low) * static_cast<float>(z >> 40U) * kOneOver24Bits;
}

}  // namespace morphkit::samples
