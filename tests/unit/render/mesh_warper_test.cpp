#include "morph/render/mesh_warper.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "morph/render/check.h"
#include "morph/render/renderer.h"
#include "tests/support/errors.h"
#include "tests/support/pictures.h"
#include "tests/support/threads.h"
#include "tests/unit/render/shows.h"

namespace morphkit::render {
namespace {

using test::contains;
using test::dissolved;
using test::error_of;
using test::expect_shows_what_counts;
using test::frame_at;
using test::pictures;
using test::random_image;
using test::same_bits;

const cv::Size kSize(96, 64);
constexpr int kColumns = 7, kRows = 5;

/// An even grid whose inner vertices are moved by less than half a cell: never folded.
std::vector<cv::Point2d> jittered(cv::Size size, unsigned seed, double amount = 0.4) {
  std::mt19937 random(seed);
  warp::Mesh mesh = warp::uniform_mesh(kColumns, kRows, {{0, 0}, cv::Size2d(size)});
  const cv::Point2d cell(size.width / (kColumns - 1.0), size.height / (kRows - 1.0));
  const auto shift = [&] { return (static_cast<double>(random()) / 4294967296.0 * 2 - 1) * amount; };
  for (int row = 1; row < kRows - 1; ++row)
    for (int column = 1; column < kColumns - 1; ++column)
      mesh.at(column, row) += cv::Point2d(shift() * cell.x, shift() * cell.y);
  return mesh.vertices;
}

project::Project mesh_project(cv::Size source = kSize, cv::Size destination = kSize) {
  project::Project project;
  project.file = "pair.json";
  project.mesh = project::Mesh{kColumns, kRows, {jittered(source, 1), jittered(destination, 2)}, {}};
  project.output.frames = 9;
  return project;
}

TEST(MeshWarper, EndsAreThePicturesBitForBit) {
  for (const bool with_alpha : {false, true})
    for (const auto order : {warp::PassOrder::kAuto, warp::PassOrder::kRowsFirst, warp::PassOrder::kColumnsFirst})
      for (const auto spline :
           {warp::MeshSpline::kMonotone, warp::MeshSpline::kCatmullRom, warp::MeshSpline::kLinear}) {
        const warp::Image a = random_image(kSize, 1, with_alpha), b = random_image(kSize, 2, with_alpha);
        project::Project project = mesh_project();
        project.warp.of<project::MeshMethod>().order = order;
        project.warp.of<project::MeshMethod>().spline = spline;
        const Renderer renderer(project, pictures(a, b, with_alpha));
        EXPECT_TRUE(same_bits(frame_at(renderer, 0), a));
        EXPECT_TRUE(same_bits(frame_at(renderer, 1), b));
      }
}

TEST(MeshWarper, ASideShowsAsLongAsTheFrameDependsOnIt) {
  project::Project project = mesh_project();
  EXPECT_EQ(expect_shows_what_counts(project, kSize), 2) << "the other one at either end";
  project.pace.dissolve = motion::Timing{motion::LinearEase{}, 0.5, 0.3};
  project.groups = {{"early", {}, {}}};
  project.groups[0].pace.dissolve = motion::Timing{motion::LinearEase{}, 0.2, 0.2};
  project.mesh->groups = {{"early", {{2, 2}, {3, 2}}}};
  EXPECT_EQ(expect_shows_what_counts(project, kSize), 3 + 3);
}

TEST(MeshWarper, EqualMeshesGiveTheDissolveExactly) {
  const warp::Image a = random_image(kSize, 3), b = random_image(kSize, 4);
  project::Project project = mesh_project();
  project.mesh->vertices[project::kDestination] = project.mesh->vertices[project::kSource];
  const Renderer renderer(project, pictures(a, b));
  for (const double t : {0.125, 0.5, 0.9}) {
    EXPECT_TRUE(same_bits(frame_at(renderer, t), dissolved(a, b, static_cast<float>(t))));
  }
}

TEST(MeshWarper, UniformMeshesNeedNoVertices) {
  const warp::Image a = random_image(kSize, 5), b = random_image({80, 90}, 6);
  project::Project uniform = mesh_project(), plain;
  uniform.mesh->vertices[project::kSource].clear();
  uniform.mesh->vertices[project::kDestination].clear();
  uniform.output.fit = plain.output.fit = project::Fit::kStretch;
  const warp::Image frame = frame_at(Renderer(uniform, pictures(a, a)), 0.5);
  EXPECT_TRUE(same_bits(frame, frame_at(Renderer(plain, pictures(a, a)), 0.5)));
  EXPECT_EQ(frame_at(Renderer(uniform, pictures(a, b)), 0.3).size(), kSize);
}

TEST(MeshWarper, SameBytesForAnyNumberOfThreads) {
  project::Project project = mesh_project(kSize, {70, 80});
  project.groups.push_back({"early", {}, {}});
  project.groups.back().pace.dissolve = motion::Timing{motion::SineEase{}, 0, 0.4};
  project.mesh->groups.push_back({"early", {{2, 2}, {3, 2}}});
  const Renderer renderer(project, pictures(random_image(kSize, 9, true), random_image({70, 80}, 10, true), true));
  test::set_threads(1);
  const warp::Image one = frame_at(renderer, 0.4);
  for (const int threads : {2, 5}) {
    test::set_threads(threads);
    EXPECT_TRUE(same_bits(frame_at(renderer, 0.4), one)) << threads << " threads";
  }
  test::set_threads(0);
}

TEST(MeshWarper, AMapLooksWhereThePicturesComeFrom) {
  const project::Project project = mesh_project(kSize, {48, 32});
  const Renderer renderer(project, pictures(random_image(kSize, 11), random_image({48, 32}, 12)));
  const warp::Map source = renderer.map(renderer.clock().at(0), kSource),
                  destination = renderer.map(renderer.clock().at(1), kDestination);
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x) {
      ASSERT_EQ(source(y, x), warp::MapPoint(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F));
      ASSERT_NEAR(destination(y, x)[0], (x + 0.5) / 2, 1e-4);
      ASSERT_NEAR(destination(y, x)[1], (y + 0.5) / 2, 1e-4);
    }
}

TEST(MeshWarper, VerticesMoveInTheTimeOfTheirGroup) {
  project::Project project = mesh_project();
  project.groups.push_back({"late", {}, {}});
  project.groups.back().pace.shape = motion::Timing{motion::LinearEase{}, 0.5, 0.5};
  project.mesh->groups.push_back({"late", {{2, 2}}});
  const Footage both = pictures(random_image(kSize, 13), random_image(kSize, 14));
  const Stage stage = make_stage(project, both);
  const project::Evaluator moments(project);
  const auto between_at = [&](double t) {
    const project::Moment moment = moments.at(moments.clock().at(t));
    return between(mesh_sides(*moment.mesh, stage, project.file), moment);
  };
  const warp::Mesh early = between_at(0.5), late = between_at(0.75);
  const auto at = [&](const std::vector<cv::Point2d>& side, int column, int row) {
    return side[early.index(column, row)];
  };
  EXPECT_EQ(early.at(2, 2), at(project.mesh->vertices[project::kSource], 2, 2));
  const cv::Point2d half =
      (at(project.mesh->vertices[project::kSource], 2, 2) + at(project.mesh->vertices[project::kDestination], 2, 2)) /
      2.0;
  EXPECT_NEAR(late.at(2, 2).x, half.x, 1e-9);
  EXPECT_NEAR(late.at(2, 2).y, half.y, 1e-9);
  EXPECT_NEAR(early.at(3, 2).x,
              (at(project.mesh->vertices[project::kSource], 3, 2).x +
               at(project.mesh->vertices[project::kDestination], 3, 2).x) /
                  2,
              1e-9);
}

TEST(MeshWarper, LocalDissolveFollowsTheVertices) {
  project::Project project = mesh_project();
  project.mesh->vertices[project::kDestination] = project.mesh->vertices[project::kSource];
  project.groups.push_back({"early", {}, {}});
  project.groups.back().pace.dissolve = motion::Timing{motion::StepEase{}, 0, 0.1};
  project.groups.push_back({"late", {}, {}});
  project.groups.back().pace.dissolve = motion::Timing{motion::StepEase{}, 0.9, 0.1};
  project::MeshGroup early{"early", {}}, late{"late", {}};
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) (column <= 2 ? early : late).vertices.emplace_back(column, row);
  project.mesh->groups = {early, late};
  const warp::Image black(kSize, warp::Pixel(0, 0, 0, 1)), white(kSize, warp::Pixel(1, 1, 1, 1));
  const warp::Image frame = frame_at(Renderer(project, pictures(black, white)), 0.5);
  EXPECT_EQ(frame(30, 2)[0], 1.0F);
  EXPECT_EQ(frame(30, 93)[0], 0.0F);
  const double cell = kSize.width / (kColumns - 1.0);
  EXPECT_NEAR(frame(0, static_cast<int>(2.5 * cell))[0], 0.5F, 0.05F);
}

TEST(MeshWarper, WhiteStaysWhiteWhereItCoversAndClearWhereItDoesNot) {
  const warp::Image wide({100, 50}, warp::Pixel(1, 1, 1, 1)), tall({50, 100}, warp::Pixel(1, 1, 1, 1));
  project::Project project = mesh_project({100, 50}, {50, 100});
  project.output.size = cv::Size(61, 47);
  for (const double t : {0.0, 0.3, 0.5, 1.0}) {
    const warp::Image frame = frame_at(Renderer(project, pictures(wide, tall)), t);
    for (const warp::Pixel& pixel : frame)
      for (int c = 0; c < 4; ++c) ASSERT_NEAR(pixel[c], 1.0F, 1e-5F) << "t = " << t;
  }
  project.output.fit = project::Fit::kContain;
  const Renderer contained(project, pictures(wide, tall));
  EXPECT_TRUE(contained.has_alpha());
  EXPECT_EQ(frame_at(contained, 0)(0, 30)[3], 0.0F);
  EXPECT_NEAR(frame_at(contained, 0)(23, 30)[3], 1.0F, 1e-5F);
}

TEST(MeshWarper, ABorderVertexOffTheBorderIsNamed) {
  project::Project project = mesh_project();
  project.mesh->vertices[project::kDestination][3] = {48, 2};
  const Error error = error_of([&] { Renderer(project, pictures(random_image(kSize, 15), random_image(kSize, 16))); });
  EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
  EXPECT_TRUE(contains(error.what(), "pair.json: /mesh/destination/3: the vertex in column 3, row 0")) << error.what();
}

TEST(MeshWarper, AFoldIsNamedUnlessItIsAllowed) {
  const Footage both = pictures(random_image(kSize, 17), random_image(kSize, 18));
  project::Project project = mesh_project();
  warp::Mesh source{kColumns, kRows, project.mesh->vertices[project::kSource]};
  source.at(3, 2).x = source.at(2, 2).x - 1;
  project.mesh->vertices[project::kSource] = source.vertices;
  const Error error = error_of([&] { Renderer(project, both); });
  EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
  EXPECT_FALSE(contains(error.what(), "--")) << "libraries know no options: " << error.what();
  EXPECT_TRUE(contains(error.what(), "/mesh/source/17: the source mesh folds over: the vertex in column 3, row 2"))
      << error.what();
  const Renderer renderer(project, both, {.allow_folds = true});
  for (const double t : {0.0, 0.5, 1.0})
    for (const warp::Pixel& pixel : frame_at(renderer, t))
      for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(pixel[c]));
}

/// The inner vertices turned round the middle; least at the border, so that it stays.
std::vector<cv::Point2d> turned(cv::Size size, int columns, int rows, double angle_rad) {
  warp::Mesh mesh = warp::uniform_mesh(columns, rows, {{0, 0}, cv::Size2d(size)});
  const cv::Point2d middle(size.width / 2.0, size.height / 2.0);
  for (cv::Point2d& vertex : mesh.vertices) {
    const cv::Point2d arm = vertex - middle;
    const double radius = 2 * std::max(std::abs(arm.x) / size.width, std::abs(arm.y) / size.height);
    const double angle = angle_rad * std::pow(1 - radius * radius, 2);
    vertex = middle + cv::Point2d(arm.x * std::cos(angle) - arm.y * std::sin(angle),
                                  arm.x * std::sin(angle) + arm.y * std::cos(angle));
  }
  return mesh.vertices;
}

project::Project turning_project(double angle_rad) {
  project::Project project;
  project.file = "turn.json";
  project.mesh = project::Mesh{13, 13, {{}, turned({128, 128}, 13, 13, angle_rad)}, {}};
  return project;
}

TEST(MeshWarper, ATurnIsABottleneck) {
  const cv::Size size(128, 128);
  const Footage both = pictures(random_image(size, 19), random_image(size, 20));
  const auto kinds = [&](double degrees) {
    std::vector<std::string> names;
    const project::Project project = turning_project(degrees * 3.14159265358979 / 180);
    for (const Finding& finding : check(Renderer(project, both, {.allow_folds = true})))
      names.emplace_back(name_of(finding.kind));
    return names;
  };
  EXPECT_TRUE(kinds(5).empty());
  const auto turned_far = kinds(70);
  EXPECT_EQ(std::count(turned_far.begin(), turned_far.end(), "bottleneck"), 2);
  EXPECT_EQ(std::count(turned_far.begin(), turned_far.end(), "mesh-fold"), 0);
}

TEST(MeshWarper, TheBottleneckIsThatOfThePictureAsItIsHeld) {
  // Eight times larger than the canvas: in pixels of the file the first pass would have room enough.
  const cv::Size large(1024, 1024);
  project::Project project = turning_project(70 * 3.14159265358979 / 180);
  project.mesh->vertices[project::kDestination] = turned(large, 13, 13, 70 * 3.14159265358979 / 180);
  project.output.size = cv::Size(128, 128);
  const Renderer renderer(project, pictures(random_image(large, 25), random_image(large, 26)), {.allow_folds = true});
  std::size_t bottlenecks = 0;
  for (const Finding& finding : check(renderer)) bottlenecks += finding.kind == Finding::Kind::kBottleneck ? 1 : 0;
  EXPECT_EQ(bottlenecks, 2U);
}

TEST(MeshWarper, AMomentIsJudgedByThePicturesThatShow) {
  // The source turns too far at t = 1, where nothing of it is left.
  const cv::Size size(128, 128);
  project::Project project = turning_project(0.9);
  project.mesh->vertices[project::kSource] = turned(size, 13, 13, -0.9);
  project.pace.dissolve = motion::Timing{motion::LinearEase{}, 0.4, 0.2};
  const Renderer renderer(project, pictures(random_image(size, 23), random_image(size, 24)));
  EXPECT_NO_THROW(renderer.require(renderer.clock().at(0)));
  EXPECT_NO_THROW(renderer.require(renderer.clock().at(1)));
  project.pace.dissolve = motion::Timing{motion::StepEase{}, 0.99, 0.01};
  const Renderer late(project, pictures(random_image(size, 23), random_image(size, 24)));
  EXPECT_THROW(late.require(late.clock().at(0.98)), Error);
}

TEST(MeshWarper, CarriesVerticesToTheirPartners) {
  const project::Project project = mesh_project(kSize, {80, 70});
  const Renderer renderer(project, pictures(random_image(kSize, 27), random_image({80, 70}, 28)));
  const auto warper = renderer.warper(renderer.clock().at(0.3));
  const std::vector<project::Points>& vertices = project.mesh->vertices;
  for (std::size_t i = 0; i < vertices[kSource].size(); ++i) {
    const auto there = warper->carry(kSource, kDestination, vertices[kSource][i]);
    ASSERT_TRUE(there);
    EXPECT_LE(cv::norm(*there - vertices[kDestination][i]), 1e-9) << i;
  }
  EXPECT_EQ(warper->carry(kSource, kDestination, {-9, 500}), cv::Point2d(0, 70));
}

TEST(MeshWarper, ItsProblemsAreThoseOfItsMoment) {
  const cv::Size size(128, 128);
  const Renderer renderer(turning_project(1.2217), pictures(random_image(size, 29), random_image(size, 30)),
                          {.allow_folds = true});
  const auto problems = [&](double t) { return renderer.warper(renderer.clock().at(t))->problems(); };
  EXPECT_EQ(problems(1).size(), 0u) << "the source does not show, the destination stays";
  const std::vector<Finding> early = problems(0.01), late = problems(0.99);
  ASSERT_EQ(early.size(), 1u);
  EXPECT_EQ(early[0].kind, Finding::Kind::kBottleneck);
  EXPECT_EQ(early[0].where, "destination");
  EXPECT_EQ(early[0].t, 0.01);
  ASSERT_EQ(late.size(), 1u);
  EXPECT_EQ(late[0].where, "source");
}

TEST(MeshWarper, CheckNamesFoldedVertices) {
  const Footage both = pictures(random_image(kSize, 21), random_image(kSize, 22));
  project::Project project = mesh_project();
  EXPECT_TRUE(check(Renderer(project, both)).empty());
  warp::Mesh destination{kColumns, kRows, project.mesh->vertices[project::kDestination]};
  destination.at(4, 3).y = destination.at(4, 2).y - 2;
  project.mesh->vertices[project::kDestination] = destination.vertices;
  const std::vector<Finding> found = check(Renderer(project, both, {.allow_folds = true}));
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].kind, Finding::Kind::kMeshFold);
  EXPECT_EQ(found[0].where, "destination");
  EXPECT_NE(std::find(found[0].vertices.begin(), found[0].vertices.end(), cv::Point(4, 3)), found[0].vertices.end());
}

}  // namespace
}  // namespace morphkit::render
