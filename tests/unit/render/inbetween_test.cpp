#include "morph/render/inbetween.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/pictures.h"

namespace morphkit::render {
namespace {

using test::line;
using test::small_project;

double length(const warp::Line& l) {
  return std::hypot(l.q.x - l.p.x, l.q.y - l.p.y);
}

std::vector<LinePair> pairs_of(project::Project project) {
  return line_pairs(project, {}, {});
}

LinePair one_pair(warp::Line source, warp::Line destination, project::Between between, double turns = 0) {
  project::Project project;
  project.features = {line("l", source, destination)};
  project.pull.between = between;
  project.pull.turns = turns;
  return pairs_of(project).front();
}

TEST(Between, EndsAreExact) {
  std::mt19937 random(7);
  const auto coordinate = [&] { return static_cast<double>(random()) / 1e6 - 1000; };
  for (int i = 0; i < 1000; ++i) {
    const warp::Line a{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
    const warp::Line b{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
    for (const auto kind : {project::Between::kEndpoints, project::Between::kCentre}) {
      const LinePair pair = one_pair(a, b, kind);
      EXPECT_EQ(between(pair, 0).p, a.p);
      EXPECT_EQ(between(pair, 0).q, a.q);
      EXPECT_EQ(between(pair, 1).p, b.p);
      EXPECT_EQ(between(pair, 1).q, b.q);
    }
  }
}

TEST(Between, WhatDoesNotMoveStaysBitForBit) {
  const warp::Line l{{0.1, 0.7}, {33.3, 12.9}};
  for (const auto kind : {project::Between::kEndpoints, project::Between::kCentre})
    for (double s = 0; s <= 1; s += 0.01) {
      const warp::Line x = between(one_pair(l, l, kind), s);
      EXPECT_EQ(x.p, l.p);
      EXPECT_EQ(x.q, l.q);
    }
}

TEST(Between, CentreKeepsTheLengthOfALineThatTurnsAndEndpointsShrinkIt) {
  const warp::Line a{{0, 0}, {10, 0}}, b{{5, -5}, {5, 5}};  // a quarter turn about (5, 0)
  const warp::Line centre = between(one_pair(a, b, project::Between::kCentre), 0.5);
  EXPECT_NEAR(length(centre), 10, 1e-12);
  EXPECT_NEAR(std::atan2(centre.q.y - centre.p.y, centre.q.x - centre.p.x), std::numbers::pi / 4, 1e-12);
  EXPECT_NEAR(length(between(one_pair(a, b, project::Between::kEndpoints), 0.5)), 10 / std::sqrt(2.0), 1e-12);
}

TEST(Between, TurnsTheShorterWayAndAsOftenAsAsked) {
  const auto angle = [](const warp::Line& l) { return std::atan2(l.q.y - l.p.y, l.q.x - l.p.x); };
  const auto at = [](double a) { return warp::Line{{0, 0}, {std::cos(a), std::sin(a)}}; };
  // From 170 to -170 degrees the shorter way leads through 180.
  const double degree = std::numbers::pi / 180;
  EXPECT_NEAR(std::abs(angle(between(one_pair(at(170 * degree), at(-170 * degree), project::Between::kCentre), 0.5))),
              std::numbers::pi, 1e-12);
  // One extra turn: half way it has turned by 180 degrees more.
  EXPECT_NEAR(angle(between(one_pair(at(0), at(20 * degree), project::Between::kCentre, 1), 0.5)), -170 * degree,
              1e-12);
}

TEST(LinePairs, CurvesBecomeConnectedChainsOfEqualCount) {
  const std::vector<LinePair> pairs = pairs_of(small_project());
  std::vector<LinePair> chain;
  for (const LinePair& pair : pairs)
    if (pair.feature == 3) chain.push_back(pair);
  ASSERT_GE(chain.size(), 2u);
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    EXPECT_EQ(chain[i].source.q, chain[i + 1].source.p);
    EXPECT_EQ(chain[i].destination.q, chain[i + 1].destination.p);
  }
  EXPECT_EQ(chain.front().source.p, cv::Point2d(30, 48));
  EXPECT_NEAR(chain.back().destination.q.x, 63, 1e-6);
}

TEST(FieldLines, EachFeatureMovesInItsOwnTime) {
  project::Project project = small_project();
  project.features[0].pace.shape = motion::Timing{motion::LinearEase{}, 0.5, 0.5};
  project.features[1].pace.dissolve = motion::Timing{motion::StepEase{0.2}, 0, 1};
  const std::vector<warp::FieldLine> lines = field_lines(pairs_of(project), 0.5);
  EXPECT_EQ(lines[0].output.p, cv::Point2d(20, 14));
  EXPECT_EQ(lines[1].output.p, cv::Point2d(13, 21));
  EXPECT_EQ(lines[0].value, 0.5);
  EXPECT_EQ(lines[1].value, 1);
}

}  // namespace
}  // namespace morphkit::render
