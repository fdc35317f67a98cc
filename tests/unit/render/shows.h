#pragma once
// What a frame depends on, against what a renderer says of it.

#include <gtest/gtest.h>

#include "morph/render/renderer.h"
#include "tests/support/pictures.h"

namespace morphkit::test {

/// Compares `shows` with frames of other pictures. @param size  of the pictures. @return how often a side is hidden.
inline int expect_shows_what_counts(const project::Project& project, cv::Size size) {
  const warp::Image a = random_image(size, 1), b = random_image(size, 2), c = random_image(size, 3);
  const render::Renderer renderer(project, pictures(a, b)), other_source(project, pictures(c, b)),
      other_destination(project, pictures(a, c));
  int hidden = 0;
  for (const double t : {0.0, 0.1, 0.15, 0.3, 0.45, 0.65, 0.8, 0.9, 1.0}) {
    SCOPED_TRACE(t);
    const warp::Image frame = frame_at(renderer, t);
    const project::Time time = renderer.clock().at(t);
    const bool source = renderer.shows(render::kSource, time), destination = renderer.shows(render::kDestination, time);
    EXPECT_EQ(source, !same_bits(frame, frame_at(other_source, t)));
    EXPECT_EQ(destination, !same_bits(frame, frame_at(other_destination, t)));
    hidden += !source + !destination;
  }
  return hidden;
}

}  // namespace morphkit::test
