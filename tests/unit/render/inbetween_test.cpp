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

project::Moment moment_of(const project::Project& project, double t) {
  return project::evaluate(project, project::Clock(project.output).at(t));
}

std::vector<FeatureLine> lines_of(const project::Moment& moment) {
  return feature_lines(*moment.features, std::vector<Placement>(2));
}

/// The line at progress s, by the default timing.
warp::Line between_at(warp::Line source, warp::Line destination, project::Between between, double s, double turns = 0) {
  project::Project project;
  project.features = {line("l", source, destination)};
  project.pull.between = between;
  project.pull.turns = turns;
  const project::Moment moment = moment_of(project, s);
  return render::between(lines_of(moment).front(), moment);
}

TEST(Between, EndsAreExact) {
  std::mt19937 random(7);
  const auto coordinate = [&] { return static_cast<double>(random()) / 1e6 - 1000; };
  for (int i = 0; i < 1000; ++i) {
    const warp::Line a{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
    const warp::Line b{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
    for (const auto kind : {project::Between::kEndpoints, project::Between::kCentre}) {
      const warp::Line first = between_at(a, b, kind, 0), last = between_at(a, b, kind, 1);
      EXPECT_EQ(first.p, a.p);
      EXPECT_EQ(first.q, a.q);
      EXPECT_EQ(last.p, b.p);
      EXPECT_EQ(last.q, b.q);
    }
  }
}

TEST(Between, WhatDoesNotMoveStaysBitForBit) {
  const warp::Line l{{0.1, 0.7}, {33.3, 12.9}};
  for (const auto kind : {project::Between::kEndpoints, project::Between::kCentre})
    for (double s = 0; s <= 1; s += 0.01) {
      const warp::Line x = between_at(l, l, kind, s);
      EXPECT_EQ(x.p, l.p);
      EXPECT_EQ(x.q, l.q);
    }
}

TEST(Between, CentreKeepsTheLengthOfALineThatTurnsAndEndpointsShrinkIt) {
  const warp::Line a{{0, 0}, {10, 0}}, b{{5, -5}, {5, 5}};  // a quarter turn about (5, 0)
  const warp::Line centre = between_at(a, b, project::Between::kCentre, 0.5);
  EXPECT_NEAR(length(centre), 10, 1e-12);
  EXPECT_NEAR(std::atan2(centre.q.y - centre.p.y, centre.q.x - centre.p.x), std::numbers::pi / 4, 1e-12);
  EXPECT_NEAR(length(between_at(a, b, project::Between::kEndpoints, 0.5)), 10 / std::sqrt(2.0), 1e-12);
}

TEST(Between, TurnsTheShorterWayAndAsOftenAsAsked) {
  const auto angle = [](const warp::Line& l) { return std::atan2(l.q.y - l.p.y, l.q.x - l.p.x); };
  const auto at = [](double a) { return warp::Line{{0, 0}, {std::cos(a), std::sin(a)}}; };
  // From 170 to -170 degrees the shorter way leads through 180.
  const double degree = std::numbers::pi / 180;
  EXPECT_NEAR(std::abs(angle(between_at(at(170 * degree), at(-170 * degree), project::Between::kCentre, 0.5))),
              std::numbers::pi, 1e-12);
  // One extra turn: half way it has turned by 180 degrees more.
  EXPECT_NEAR(angle(between_at(at(0), at(20 * degree), project::Between::kCentre, 0.5, 1)), -170 * degree, 1e-12);
}

TEST(Between, ManySidesHaveAMean) {
  const FeatureLine three{{{{0, 0}, {10, 0}}, {{0, 0}, {0, 20}}, {{6, 6}, {-24, 6}}}, 0};  // each a quarter turn on
  project::MomentFeature feature;
  for (const auto kind : {project::Between::kEndpoints, project::Between::kCentre}) {
    feature.between = kind;
    const warp::Line last = between(three, feature, std::vector<double>{0, 0, 1});
    EXPECT_EQ(last.p, three.sides[2].p);
    EXPECT_EQ(last.q, three.sides[2].q);
  }
  const warp::Line ends = between(three, feature = {}, std::vector<double>{0.5, 0.25, 0.25});
  EXPECT_LE(cv::norm(ends.p - cv::Point2d(1.5, 1.5)), 1e-12);
  EXPECT_LE(cv::norm(ends.q - cv::Point2d(-1, 6.5)), 1e-12);
  feature.between = project::Between::kCentre;
  const warp::Line turned = between(three, feature, std::vector<double>{0.25, 0.5, 0.25});
  EXPECT_NEAR(length(turned), 20, 1e-12);
  EXPECT_NEAR(std::atan2(turned.q.y - turned.p.y, turned.q.x - turned.p.x), std::numbers::pi / 2, 1e-12);
}

TEST(FeatureLines, CurvesBecomeConnectedChainsOfEqualCount) {
  std::vector<FeatureLine> chain;
  for (const FeatureLine& line : lines_of(moment_of(small_project(), 0)))
    if (line.feature == 3) chain.push_back(line);
  ASSERT_GE(chain.size(), 2u);
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    for (std::size_t side = 0; side < 2; ++side) EXPECT_EQ(chain[i].sides[side].q, chain[i + 1].sides[side].p);
  EXPECT_EQ(chain.front().sides[0].p, cv::Point2d(30, 48));
  EXPECT_NEAR(chain.back().sides[1].q.x, 63, 1e-6);
}

TEST(FieldLines, EachFeatureMovesInItsOwnTime) {
  project::Project project = small_project();
  project.features[0].pace.shape = motion::Timing{motion::LinearEase{}, 0.5, 0.5};
  project.features[1].pace.dissolve = motion::Timing{motion::StepEase{0.2}, 0, 1};
  const project::Moment moment = moment_of(project, 0.5);
  const std::vector<warp::FieldLine> lines = field_lines(lines_of(moment), moment);
  EXPECT_EQ(lines[0].output.p, cv::Point2d(20, 14));
  EXPECT_EQ(lines[1].output.p, cv::Point2d(13, 21));
  EXPECT_EQ(lines[0].value, 0.5);
  EXPECT_EQ(lines[1].value, 1);
}

}  // namespace
}  // namespace morphkit::render
