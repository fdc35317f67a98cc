// Other tools' files, in and out.

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "morph/exchange/import.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/exchange/xmorph_meshes.h"

namespace morphkit::exchange {
namespace {

using test::contains;
using test::error_of;
using test::kXmorphMesh;
using test::largest_distance;
using test::parsed;
using test::random_mesh;
using test::read_text;
using test::TemporaryFolder;
using test::write_text;

class Import : public ::testing::Test {
 protected:
  Import() {
    project_.pictures[project::kSource].image = "a.png";
    project_.pictures[project::kDestination].image = "b.png";
  }
  ImportInput input(const std::string& a, const std::string& b) const {
    return {{folder_ / a, folder_ / b}, {101, 51}, {201, 101}};
  }
  ExportOutput output(const std::string& a, const std::string& b, bool overwrite = false) const {
    return {{folder_ / a, folder_ / b}, {101, 51}, {201, 101}, overwrite};
  }
  Error import_error(const ImportInput& input) {
    const project::Project before = project_;
    const Error error = error_of([&] { import_into(project_, input); });
    EXPECT_TRUE(same_document(project_, before));
    return error;
  }

  TemporaryFolder folder_;
  project::Project project_;
};

TEST_F(Import, BothSidesBecomeTheMeshOfTheProject) {
  write_text(folder_ / "a.mesh", kXmorphMesh);
  write_text(folder_ / "B.MESH", kXmorphMesh);
  project_.warp.border = warp::Border::kMirror;
  const ImportReport report = import_into(project_, input("a.mesh", "B.MESH"));
  EXPECT_EQ(report.format, "xmorph");
  ASSERT_EQ(report.remarks.size(), 2U);
  EXPECT_EQ(report.remarks[0], (folder_ / "B.MESH").string() + ": drawn on 101 x 51 pixels, stretched to 201 x 101");
  EXPECT_TRUE(contains(report.remarks[1], "mirror"));
  EXPECT_EQ(method_name_of(project_), project::MethodName::kMesh);
  ASSERT_TRUE(project_.mesh);
  EXPECT_EQ(project_.mesh->vertices[project::kSource], parsed(kXmorphMesh, {101, 51}).vertices);
  EXPECT_EQ(project_.mesh->vertices[project::kDestination], parsed(kXmorphMesh, {201, 101}).vertices);
  EXPECT_TRUE(same_document(project::parse(project::to_text(project_), ""), project_));
}

TEST_F(Import, ReadsOneSideAlone) {
  write_text(folder_ / "a.mesh", kXmorphMesh);
  std::vector<std::string> remarks;
  EXPECT_EQ(read_xmorph_mesh(folder_ / "a.mesh", {101, 51}, remarks), parsed(kXmorphMesh, {101, 51}));
  EXPECT_EQ(error_of([&] { read_xmorph_mesh(folder_ / "missing.mesh", {101, 51}, remarks); }).kind(), ErrorKind::kIo);
  EXPECT_EQ(error_of([&] { read_xmorph_mesh(folder_.path(), {101, 51}, remarks); }).kind(), ErrorKind::kIo);
}

TEST_F(Import, SidesMustBeAlike) {
  write_text(folder_ / "a.mesh", kXmorphMesh);
  write_text(folder_ / "b.mesh", "M2\n2 2\n0 0\n9 0\n0 9\n9 9\n");
  const Error error = import_error(input("a.mesh", "b.mesh"));
  EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
  EXPECT_EQ(error.place(), (folder_ / "b.mesh").string());
  EXPECT_TRUE(contains(error.message(), "a mesh of 2 x 2 vertices, but")) << error.what();
  EXPECT_TRUE(contains(error.message(), "has 3 x 3; both sides need the same")) << error.what();
}

TEST_F(Import, WrongFilesAreRefused) {
  write_text(folder_ / "a.mesh", kXmorphMesh);
  write_text(folder_ / "bad.mesh", "M2\n3 3\n0 0\n");
  EXPECT_EQ(import_error(input("a.mesh", "bad.mesh")).place(), (folder_ / "bad.mesh").string() + ":3");
  EXPECT_EQ(import_error(input("a.mesh", "missing.mesh")).kind(), ErrorKind::kIo);
  const auto usage = [&](const ImportInput& wrong, const std::string& says) {
    const Error error = import_error(wrong);
    EXPECT_EQ(error.kind(), ErrorKind::kUnsupported);
    EXPECT_TRUE(contains(error.what(), says)) << error.what();
  };
  usage(input("a.mesh", "b.txt"), "no format has the extension '.txt'; known are .mesh (xmorph)");
  usage(input("a", "b"), "no format has the extension ''");
  usage({{folder_ / "a.mesh"}, {9, 9}, {9, 9}}, "1 files are named; xmorph wants two .mesh files, the source's first");
  usage({{}, {9, 9}, {9, 9}}, "no file is named");
}

TEST_F(Import, WhatIsExportedComesBack) {
  std::mt19937 random(7);
  const warp::Mesh source = random_mesh(random, {101, 51});
  project_.mesh = project::Mesh{source.columns, source.rows, {source.vertices, {}}, {}};
  project_.groups = {{"g", {}, {}}};
  project_.mesh->groups = {{"g", {{0, 0}}}};
  const std::vector<std::string> remarks = export_to(project_, output("a.mesh", "b.mesh"));
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_TRUE(contains(remarks[0], "groups"));
  project::Project back = project_;
  import_into(back, input("a.mesh", "b.mesh"));
  EXPECT_LE(largest_distance(back.mesh->vertices[project::kSource], source.vertices), 0.05 + 1e-9);
  const warp::Mesh even = warp::uniform_mesh(source.columns, source.rows, {0, 0, 201, 101});
  EXPECT_LE(largest_distance(back.mesh->vertices[project::kDestination], even.vertices), 0.05 + 1e-9);
  EXPECT_EQ(folder_.names().size(), 2U);
}

TEST_F(Import, ExportReplacesBothOrNeither) {
  project_.mesh = project::Mesh{2, 2, {{}, {}}, {}};
  write_text(folder_ / "b.mesh", "mine");
  EXPECT_EQ(error_of([&] { export_to(project_, output("a.mesh", "b.mesh")); }).kind(), ErrorKind::kIo);
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"b.mesh"});
  EXPECT_EQ(read_text(folder_ / "b.mesh"), "mine");
  export_to(project_, output("a.mesh", "b.mesh", true));
  EXPECT_EQ(read_text(folder_ / "b.mesh"), "M2\n2 2\n0 0 0\n2000 0 0\n0 1000 0\n2000 1000 0\n");
}

TEST_F(Import, WhatTheFormatCannotHoldIsRefusedOrToldOf) {
  EXPECT_TRUE(contains(error_of([&] { export_to(project_, output("a.mesh", "b.mesh")); }).what(), "has no \"mesh\""));
  project_.mesh = project::Mesh{2, 2, {{}, {}}, {}};
  ExportOutput narrow = output("a.mesh", "b.mesh");
  narrow.destination_size = {1, 90};
  EXPECT_TRUE(contains(error_of([&] { export_to(project_, narrow); }).what(), "1 x 90"));
  EXPECT_EQ(folder_.names().size(), 0U);
  project_.features.emplace_back();
  EXPECT_TRUE(contains(export_to(project_, output("a.mesh", "b.mesh")).at(0), "1 features are left out"));
}

TEST(Formats, EachHasExtensionsOfItsOwn) {
  std::vector<std::string_view> extensions;
  for (const Format& format : formats()) {
    EXPECT_FALSE(format.name.empty());
    EXPECT_GT(format.files, 0U);
    extensions.insert(extensions.end(), format.extensions.begin(), format.extensions.end());
  }
  std::ranges::sort(extensions);
  EXPECT_EQ(std::ranges::adjacent_find(extensions), extensions.end());
  EXPECT_FALSE(extensions.empty());
}

}  // namespace
}  // namespace morphkit::exchange
