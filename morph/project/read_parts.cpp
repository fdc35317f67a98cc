#include "morph/project/read_parts.h"

#include <fmt/format.h>

#include "base/words.h"
#include "morph/project/limits.h"

namespace morphkit::project {

cv::Point2d read_point(const json::Cursor& at) {
  at.expect_array(2, 2, "a point [x, y] in pixels");
  return {at.item(0).number(-kMaxCoordinate, kMaxCoordinate), at.item(1).number(-kMaxCoordinate, kMaxCoordinate)};
}

std::vector<cv::Point2d> read_points(const json::Cursor& at, std::size_t least, std::size_t most,
                                     const std::string& what) {
  at.expect_array(least, most, what);
  std::vector<cv::Point2d> points;
  points.reserve(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) points.push_back(read_point(at.item(i)));
  return points;
}

std::set<std::string_view> group_ids(const std::vector<Group>& groups) {
  std::set<std::string_view> ids;
  for (const Group& group : groups) ids.insert(group.id);
  return ids;
}

void check_group(const json::Cursor& at, std::string_view group, const std::set<std::string_view>& known) {
  if (known.contains(group)) return;
  const std::vector<std::string_view> names(known.begin(), known.end());
  const auto meant = nearest(group, names);
  at.fail(fmt::format("no group has the id {}; {}", json::shown(group),
                      meant ? fmt::format("did you mean {}?", json::shown(*meant)) : "add it to \"groups\""));
}

}  // namespace morphkit::project
