#pragma once
// What several commands take as arguments.

#include <map>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

#include "morph/project/project.h"

namespace morphkit::cli {

/// What --filter, --field, --fit, --spline and --order may say.
const std::map<std::string, warp::Filter>& filter_names();
const std::map<std::string, warp::FieldAccuracy>& field_names();
const std::map<std::string, project::Fit>& fit_names();
const std::map<std::string, warp::MeshSpline>& spline_names();
const std::map<std::string, warp::PassOrder>& order_names();

/// The names of such a table, for the choices of an option.
template <typename Value>
std::vector<std::string> words_of(const std::map<std::string, Value>& names) {
  std::vector<std::string> words;
  for (const auto& [word, value] : names) words.push_back(word);
  return words;
}

/// "1280x720". @param option  that says it, for the message.
/// @throws Error kUsage if it is no size, or a larger one than a project may ask for.
cv::Size parse_size(const std::string& text, const std::string& option = "--size");

/// "25", "29.97", "30000/1001". @throws Error kUsage if it is no rate.
project::Rate parse_fps(const std::string& text);

/// @throws Error kUsage unless t lies in [0, 1]; NaN, which the parser lets pass, does not.
void require_moment(double t);

}  // namespace morphkit::cli
