#pragma once
// What can be done to one feature so that it stays one that a project file may hold. Internal to cli/edit.

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

/// Without the last digits that sums leave behind, as 0.30000000000000004: to a millionth of a px.
cv::Point2d settled(cv::Point2d point);

/// Within +-kMaxCoordinate. @pre finite.
cv::Point2d kept(cv::Point2d point);

/// Whether the mark is a closed curve.
bool is_closed(const project::Mark& mark);

/// Whether the project file takes the places of the feature: both sides are points or lines or curves of the kind that
/// it says, within kMaxCoordinate.
bool sound(const project::Feature& feature);

/// Moves one point; both ends of an open curve or of a line that lie at the same place on both sides move together.
/// @return whether what came out is sound; if not, the feature is unchanged.
bool move_point(project::Feature& feature, project::SideIndex side, std::size_t point, cv::Point2d to);

/// Moves all points of a side, shape and all, as far as the limits let it. @return as move_point.
bool move_all(project::Feature& feature, project::SideIndex side, cv::Point2d by);

/// Lets a side run the other way round; a closed curve keeps its first point.
void reverse(project::Feature& feature, project::SideIndex side);

/// "line", "point" or "curve".
std::string_view word_for(const project::Mark& mark);

/// "line 3": with the smallest number that makes it one that no feature has.
std::string free_id(const project::Project& project, const project::Mark& mark);

/// What is wrong with a name of a feature or a group as a name, or an empty string.
std::string problem_of_name(const std::string& name);

}  // namespace morphkit::edit
