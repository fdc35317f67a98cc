#include <vector>

#include <gtest/gtest.h>

#include "cli/edit/document/document.h"
#include "morph/project/limits.h"
#include "tests/unit/edit/document/make_document.h"

namespace morphkit::edit {
namespace {

using Points = std::vector<cv::Point2d>;
using test::document_of;
using test::empty_project;
using test::expect_reads_back;
using test::kHere;
using test::kNaN;
using test::kThere;

TEST(Mesh, IsMadeByTheMethodThatNeedsOne) {
  Document document = document_of();
  document.add_point(kHere, {1, 2});
  document.set_method(project::MethodName::kMesh);
  ASSERT_TRUE(document.has_mesh());
  EXPECT_EQ(document.mesh_vertices(kHere).size(), 25U);
  EXPECT_EQ(document.method(), project::MethodName::kMesh);
  expect_reads_back(document);
  EXPECT_TRUE(document.undo());
  EXPECT_FALSE(document.has_mesh());
}

TEST(Mesh, CannotMirror) {
  project::Project project = empty_project();
  project.warp.border = warp::Border::kMirror;
  Document document(project, {400, 300}, {400, 300});
  document.add_point(kHere, {1, 2});
  document.make_mesh(3, 3);
  EXPECT_EQ(document.project().warp.border, warp::Border::kMirror) << "the features still warp";
  document.erase_selected();
  EXPECT_EQ(document.method(), project::MethodName::kMesh);
  expect_reads_back(document);
}

TEST(Mesh, BorderVerticesSlideAndCornersStay) {
  Document document = document_of({400, 300}, {800, 600});
  document.make_mesh(3, 3);
  document.undo();
  document.redo();
  document.move_vertices(std::vector{0, 2, 6, 8}, kHere, {9, 9});
  EXPECT_TRUE(document.project().mesh->vertices[project::kSource].empty()) << "corners only: nothing has happened";
  document.move_vertices(std::vector{0, 1, 3, 4, -1, 99}, kHere, {30, 40});
  const Points vertices = document.mesh_vertices(kHere);
  EXPECT_EQ(vertices[0], cv::Point2d(0, 0));
  EXPECT_EQ(vertices[1], cv::Point2d(230, 0));
  EXPECT_EQ(vertices[3], cv::Point2d(0, 190));
  EXPECT_EQ(vertices[4], cv::Point2d(230, 190));
  document.move_vertices(std::vector{4}, kHere, {1e7, -1e7});
  EXPECT_EQ(document.mesh_vertices(kHere)[4], cv::Point2d(400, 0));
  EXPECT_TRUE(document.project().mesh->vertices[project::kDestination].empty());
  EXPECT_EQ(document.mesh_vertices(kThere)[4], cv::Point2d(400, 300));
  expect_reads_back(document);
}

project::Project grouped_mesh() {
  project::Project project = empty_project();
  project.groups = {{"a", {}, {}}, {"b", {}, {}}};
  project.mesh = project::Mesh{
      .columns = 3, .rows = 3, .vertices = {{}, {}}, .groups = {{"a", {{0, 1}, {1, 1}, {2, 2}}}, {"b", {{2, 1}}}}};
  return project;
}

TEST(Mesh, ColumnsComeAndGoWithTheirGroupsAndSelection) {
  Document document(grouped_mesh(), {400, 300}, {800, 600});
  document.select({{}, {1, 4, 8}});
  document.insert_column(0, 0.25);
  EXPECT_EQ(document.project().mesh->columns, 4);
  EXPECT_EQ(document.mesh_vertices(kHere)[1], cv::Point2d(50, 0));
  EXPECT_EQ(document.mesh_vertices(kThere)[5], cv::Point2d(100, 300));
  EXPECT_EQ(document.project().mesh->groups[0].vertices, (std::vector<cv::Point>{{0, 1}, {2, 1}, {3, 2}, {1, 1}}));
  EXPECT_EQ(document.selection().vertices, (std::vector{2, 6, 11}));
  expect_reads_back(document);
  EXPECT_FALSE(document.remove_column(0));
  EXPECT_FALSE(document.remove_column(3));
  EXPECT_TRUE(document.remove_column(2));
  EXPECT_EQ(document.project().mesh->groups[0].vertices, (std::vector<cv::Point>{{0, 1}, {2, 2}, {1, 1}}));
  EXPECT_EQ(document.selection().vertices, (std::vector{8}));
  EXPECT_EQ(document.mesh_vertices(kHere)[2], cv::Point2d(400, 0));
  expect_reads_back(document);
}

TEST(Mesh, RowsLikewiseAndAnEmptiedGroupGoes) {
  Document document(grouped_mesh(), {400, 300}, {800, 600});
  document.select({{}, {1, 4, 8}});
  document.insert_row(1, 0.5);
  EXPECT_EQ(document.project().mesh->rows, 4);
  EXPECT_EQ(document.mesh_vertices(kHere)[7], cv::Point2d(200, 225));
  EXPECT_EQ(document.project().mesh->groups[0].vertices, (std::vector<cv::Point>{{0, 1}, {1, 1}, {2, 3}}));
  EXPECT_EQ(document.selection().vertices, (std::vector{1, 4, 11}));
  EXPECT_TRUE(document.remove_row(1));
  ASSERT_EQ(document.project().mesh->groups.size(), 1U);
  ASSERT_EQ(document.project().groups.size(), 1U);
  EXPECT_EQ(document.project().groups[0].id, "a");
  EXPECT_EQ(document.selection().vertices, (std::vector{1, 8}));
  expect_reads_back(document);
}

TEST(Mesh, InsertingAndRemovingReturnsTheVertices) {
  Document document = document_of({400, 300}, {800, 600});
  document.make_mesh(5, 4);
  document.move_vertices(std::vector{6}, kHere, {7, 3});
  const Points before = document.mesh_vertices(kHere);
  document.insert_row(2, 0.3);
  document.insert_column(3, 0.7);
  EXPECT_TRUE(document.remove_column(4));
  EXPECT_TRUE(document.remove_row(3));
  EXPECT_EQ(document.mesh_vertices(kHere), before);
}

TEST(Mesh, StaysWithinTheLimits) {
  Document document = document_of();
  document.make_mesh(1, -4);
  EXPECT_EQ(document.mesh_vertices(kHere).size(), 4U);
  EXPECT_FALSE(document.remove_column(0));
  EXPECT_FALSE(document.remove_row(1));
  document.insert_column(1, 0.5);
  document.insert_column(-1, 0.5);
  document.insert_column(0, kNaN);
  EXPECT_EQ(document.project().mesh->columns, 2);
  document.make_mesh(5000, 2);
  EXPECT_EQ(document.project().mesh->columns, project::kMaxMeshSize);
  document.insert_column(3, 0.5);
  EXPECT_EQ(document.project().mesh->columns, project::kMaxMeshSize);
}

}  // namespace
}  // namespace morphkit::edit
