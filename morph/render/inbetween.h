#pragma once
// Features on every picture -> the lines of one moment.

#include <cstddef>
#include <span>
#include <vector>

#include "morph/project/evaluate.h"
#include "morph/render/placement.h"
#include "warp/field/line_field.h"

namespace morphkit::render {

/// A line of a feature on every picture, on the canvas. Points have p == q; curves are chains of lines.
struct FeatureLine {
  std::vector<warp::Line> sides;  ///< canvas px, in the order of the pictures
  std::size_t feature = 0;        ///< index into Moment::features
};

/// All features as lines; curves become chains of equal arc length on all sides.
/// @param placements  of the pictures. @param unit  canvas px per px of the placements, so that a view gets the same
/// chains as the whole canvas.
std::vector<FeatureLine> feature_lines(const std::vector<project::MomentFeature>& features,
                                       std::span<const Placement> placements, double unit = 1);

/// The mean of a line's sides; exactly the line of a side that has all the weight.
/// @param feature  that the line belongs to. @param weights  of the sides; they sum to 1.
warp::Line between(const FeatureLine& line, const project::MomentFeature& feature, std::span<const double> weights);

/// The same at a moment.
warp::Line between(const FeatureLine& line, const project::Moment& moment);

/// The lines of a moment: in-between lines, targets (one per side), weights. The value of a line is what its feature
/// takes of the last picture's colour.
/// @param lines  of the moment's features. @param unit  warp::LineWeight::unit, for lines on a view of the canvas.
std::vector<warp::FieldLine> field_lines(const std::vector<FeatureLine>& lines, const project::Moment& moment,
                                         double unit = 1);

}  // namespace morphkit::render
