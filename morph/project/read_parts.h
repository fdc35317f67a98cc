#pragma once
// What the readers of features, groups and meshes share. Internal to morph/project.

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core/types.hpp>

#include "morph/json/cursor.h"
#include "morph/project/project.h"

namespace morphkit::project {

/// [x, y], px.
cv::Point2d read_point(const json::Cursor& at);

/// @param what  names what is expected, for the message.
std::vector<cv::Point2d> read_points(const json::Cursor& at, std::size_t least, std::size_t most,
                                     const std::string& what);

std::set<std::string_view> group_ids(const std::vector<Group>& groups);

/// The id of one of the groups. @throws Error kBadInput with the nearest id if there is none.
void check_group(const json::Cursor& at, std::string_view group, const std::set<std::string_view>& known);

/// "mesh". @param groups  of the document. @throws Error kBadInput.
Mesh read_mesh(const json::Cursor& at, const std::vector<Group>& groups);

}  // namespace morphkit::project
