#pragma once
// From positions to a frame: sampling, dissolve and background, for every method.

#include "morph/project/project.h"
#include "morph/render/warper.h"
#include "warp/image/image.h"
#include "warp/sample/sample.h"

namespace morphkit::render {

/// All pictures of a moment, warped and mixed, without a background, on the stage's canvas or view.
/// Parallel over bands; one fused pass per band where the method samples.
warp::Image compose(const Stage& stage, const Warper& warper, warp::Filter filter, project::Blend blend);

/// One of these pictures as `compose` draws it, without the others.
warp::Image draw_side(const Stage& stage, const Warper& warper, SideIndex side, warp::Filter filter);

/// Samples a side at positions for the whole canvas, in bands. @param map  Pixels::kHeld. @param out  of map's size.
void sample_side(const StageSide& side, const warp::Map& map, warp::Filter filter, warp::Image& out);

/// Lays the image over `behind`: empty (nothing), 1 x 1 (a colour) or of the image's size.
void composite_over(warp::Image& image, const warp::Image& behind);

}  // namespace morphkit::render
