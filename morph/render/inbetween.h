#pragma once
// Features of both sides -> the lines of one moment.

#include <string>
#include <vector>

#include "morph/project/project.h"
#include "morph/render/placement.h"
#include "warp/field/line_field.h"

namespace morphkit::render {

/// A line on both sides, on the canvas, with the settings that decide its moments. Points have p == q; curves are
/// chains of lines.
struct LinePair {
  warp::Line source, destination;  ///< canvas px
  project::Pull pull;              ///< no member empty
  project::Pace pace;              ///< likewise
  int feature = -1;                ///< index into Project::features
};

/// All features as pairs of canvas lines; curves become chains of equal arc length on both sides.
/// @param unit  canvas px per px of the placements, so that a view gets the same chains as the whole canvas.
std::vector<LinePair> line_pairs(const project::Project& project, const Placement& source, const Placement& destination,
                                 double unit = 1);

/// The line at progress s from source (0) to destination (1). s = 0 and 1 give the ends bit for bit.
warp::Line between(const LinePair& pair, double s);

/// The lines of the moment t in [0, 1]: in-between lines, targets (source, destination), weights, and the dissolve
/// progress of each feature as its value. @param unit  warp::LineWeight::unit, for pairs on a view of the canvas.
std::vector<warp::FieldLine> field_lines(const std::vector<LinePair>& pairs, double t, double unit = 1);

}  // namespace morphkit::render
