#include "morph/render/mesh_inbetween.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/support/errors.h"
#include "tests/support/pictures.h"

namespace morphkit::render {
namespace {

using test::contains;
using test::error_of;

/// Two by two cells whose middle vertex lies at `middle`.
project::MomentMesh mesh_with(cv::Point2d middle) {
  project::MomentMesh mesh;
  mesh.columns = mesh.rows = 3;
  mesh.vertices = {{{0, 0}, {48, 0}, {96, 0}, {0, 32}, middle, {96, 32}, {0, 64}, {48, 64}, {96, 64}}, {}};
  return mesh;
}

TEST(MeshOn, AnEmptyListIsAnEvenMesh) {
  EXPECT_EQ(mesh_on(mesh_with({50, 30}), kDestination, {96, 64}, ""), warp::uniform_mesh(3, 3, {0, 0, 96, 64}));
}

TEST(MeshOn, BorderVerticesAreBroughtToTheBorderOrRefused) {
  project::MomentMesh mesh = mesh_with({50, 30});
  mesh.vertices[kSource][1].y = 0.9 * kOutlineTolerancePx;
  const warp::Mesh snapped = mesh_on(mesh, kSource, {96, 64}, "");
  EXPECT_EQ(snapped.at(1, 0), cv::Point2d(48, 0));
  EXPECT_EQ(snapped.at(1, 1), cv::Point2d(50, 30));
  mesh.vertices[kSource][1].y = 1.1 * kOutlineTolerancePx;
  const Error error = error_of([&] { mesh_on(mesh, kSource, {96, 64}, "pair.json"); });
  EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
  EXPECT_EQ(error.place(), "pair.json: /mesh/source/1");
  EXPECT_TRUE(contains(error.message(), "column 1, row 0 is at (48, 0.55)")) << error.message();
}

TEST(BroughtTo, ScalesPerAxisAndKeepsTheBorderExact) {
  const warp::Mesh mesh = mesh_on(mesh_with({50, 30}), kSource, {96, 64}, "");
  EXPECT_EQ(scaled_to(mesh, {96, 64}, {96, 64}), mesh);
  const warp::Mesh scaled = scaled_to(mesh, {96, 64}, {48, 128});
  EXPECT_EQ(scaled.at(1, 1), cv::Point2d(25, 60));
  EXPECT_EQ(scaled.at(2, 2), cv::Point2d(48, 128));
}

TEST(MeshBetween, VerticesMoveAsTheirGroupDoes) {
  project::Project project;
  project.groups = {{"late", {}, {}}};
  project.groups[0].pace.shape = motion::Timing{motion::LinearEase{}, 0.5, 0.5};
  project.groups[0].pace.dissolve = motion::Timing{motion::StepEase{0.25}, 0, 1};
  project.mesh = project::Mesh{3, 3, {mesh_with({40, 30}).vertices[0], mesh_with({56, 34}).vertices[0]}, {}};
  const Footage both = test::pictures(test::random_image({96, 64}, 1), test::random_image({96, 64}, 2));
  const auto middle_at = [&](double t) {
    const project::Moment moment = project::evaluate(project, project::Clock(project.output).at(t));
    return between(mesh_sides(*moment.mesh, make_stage(project, both), ""), moment).at(1, 1);
  };
  EXPECT_EQ(middle_at(0), cv::Point2d(40, 30));
  EXPECT_EQ(middle_at(0.5), cv::Point2d(48, 32));
  EXPECT_EQ(middle_at(1), cv::Point2d(56, 34));
  project.mesh->groups = {{"late", {{1, 1}}}};
  EXPECT_EQ(middle_at(0.5), cv::Point2d(40, 30));
  const project::Moment moment = project::evaluate(project, project::Clock(project.output).at(0.5));
  const std::vector<double> taken = dissolves(moment, kDestination);
  ASSERT_EQ(taken.size(), 9u);
  EXPECT_EQ(taken[0], 0.5);
  EXPECT_EQ(taken[4], 1);
}

}  // namespace
}  // namespace morphkit::render
