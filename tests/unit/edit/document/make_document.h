#pragma once
// Documents for tests of editing.

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cli/edit/document/document.h"

namespace morphkit::test {

inline constexpr project::SideIndex kHere = project::kSource, kThere = project::kDestination;
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

inline project::Project empty_project() {
  project::Project project;
  project.pictures[project::kSource].image = "a.png";
  project.pictures[project::kDestination].image = "b.png";
  return project;
}

inline edit::Document document_of(cv::Size source = {400, 300}, cv::Size destination = {400, 300}) {
  return edit::Document(empty_project(), source, destination);
}

inline void expect_near(cv::Point2d a, cv::Point2d b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

inline void expect_reads_back(const edit::Document& document) {
  const std::string text = project::to_text(document.project());
  EXPECT_TRUE(project::same_document(project::parse(text, "x.json"), document.project())) << text;
}

inline project::Feature marked_line(const std::string& id, project::Points source, project::Points destination) {
  project::Feature feature;
  feature.id = id;
  feature.places[project::kSource] = std::move(source);
  feature.places[project::kDestination] = std::move(destination);
  return feature;
}

inline const project::Feature& feature(const edit::Document& document, int index) {
  return document.project().features.at(static_cast<std::size_t>(index));
}

}  // namespace morphkit::test
