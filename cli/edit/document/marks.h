#pragma once
// Edits of one feature that keep it valid for a project file. Internal to cli/edit.

#include <string_view>
#include <vector>

#include <opencv2/core/types.hpp>

#include "morph/project/project.h"
#include "morph/render/stage.h"

namespace morphkit::edit {

using project::Points;

Points& points_of(project::Feature& feature, project::SideIndex side);
const Points& points_of(const project::Feature& feature, project::SideIndex side);

bool finite(cv::Point2d point);

/// Rounds to a millionth of a px, to drop digits such as those of 0.30000000000000004.
cv::Point2d rounded_off(cv::Point2d point);

/// Within +-kMaxCoordinate. @pre finite.
cv::Point2d clamped(cv::Point2d point);

/// Whether the mark is a closed curve.
bool is_closed(const project::Mark& mark);

/// Whether a project file accepts the feature's places: both sides fit its kind and lie within kMaxCoordinate.
bool is_valid(const project::Feature& feature);

/// Moves one point; both ends of an open curve or of a line that lie at the same place on both sides move together.
/// @return whether the result is valid; if not, the feature is unchanged.
bool move_point(project::Feature& feature, project::SideIndex side, std::size_t point, cv::Point2d to);

/// Moves all points of a side as a whole, as far as the limits allow. @return as move_point.
bool move_all(project::Feature& feature, project::SideIndex side, cv::Point2d by);

/// Reverses a side; a closed curve keeps its first point.
void reverse(project::Feature& feature, project::SideIndex side);

/// "line", "point" or "curve".
std::string_view kind_name(const project::Mark& mark);

/// "line 3": with the smallest number that is free.
std::string free_id(const project::Project& project, const project::Mark& mark);

/// What is wrong with a name of a feature or a group; empty if nothing is.
std::string problem_of_name(const std::string& name);

}  // namespace morphkit::edit
