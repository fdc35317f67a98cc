// Tests morph/exchange/fit_mesh.cpp, morph/exchange/import_session.cpp and morph/exchange/text_lines.cpp. Other tools'
// files, in and out.

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
using test::random_unfolded_mesh;
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
  const auto read = [&](const std::filesystem::path& file) {
    const MeshFile one{file, {101, 51}, {}};
    return read_xmorph_meshes({&one, 1}, remarks).at(0).mesh;
  };
  EXPECT_EQ(read(folder_ / "a.mesh"), parsed(kXmorphMesh, {101, 51}));
  EXPECT_EQ(error_of([&] { read(folder_ / "missing.mesh"); }).kind(), ErrorKind::kIo);
  EXPECT_EQ(error_of([&] { read(folder_.path()); }).kind(), ErrorKind::kIo);
}

/// The destination's border is free: its first column lies well inside the picture.
constexpr const char* kFreeMesh =
    "M2\n3 3\n"
    "100 0 0\n480 0 0\n1000 0 0\n"
    "90 240 0\n515 263 -1\n1000 260 0\n"
    "100 500 0\n500 500 0\n1000 500 0\n";

TEST_F(Import, BothSidesGetARowWhereOneHasAFreeBorder) {
  write_text(folder_ / "a.mesh", kXmorphMesh);
  write_text(folder_ / "b.mesh", kFreeMesh);
  import_into(project_, {{folder_ / "a.mesh", folder_ / "b.mesh"}, {101, 51}, {101, 51}});
  ASSERT_TRUE(project_.mesh);
  EXPECT_EQ(cv::Size(project_.mesh->columns, project_.mesh->rows), cv::Size(4, 3));
  for (const std::vector<cv::Point2d>& side : project_.mesh->vertices) {
    const warp::Mesh mesh{4, 3, side};
    EXPECT_FALSE(warp::off_outline(mesh, {0, 0, 101, 51}, 0));
    EXPECT_TRUE(warp::find_folds(mesh).empty());
  }
  EXPECT_EQ(project_.mesh->vertices[project::kSource][1], cv::Point2d(1, 0)) << "there the border has come inside";
  EXPECT_EQ(project_.mesh->vertices[project::kDestination][5], cv::Point2d(9.5, 24.5));
}

TEST_F(Import, AMeshThatFoldsIsUnfoldedAndToldOf) {
  std::string folded = kXmorphMesh;
  folded.replace(folded.find("480 0 0"), 7, "1030 0 0");
  write_text(folder_ / "a.mesh", folded);
  write_text(folder_ / "b.mesh", kXmorphMesh);
  const ImportReport report = import_into(project_, {{folder_ / "a.mesh", folder_ / "b.mesh"}, {101, 51}, {101, 51}});
  const warp::Mesh mesh{3, 3, project_.mesh->vertices[project::kSource]};
  EXPECT_TRUE(warp::find_folds(mesh).empty());
  EXPECT_EQ(project_.mesh->vertices[project::kDestination], parsed(kXmorphMesh, {101, 51}).vertices);
  ASSERT_EQ(report.remarks.size(), 1U);
  EXPECT_TRUE(contains(report.remarks[0], "a.mesh: folded over; ")) << report.remarks[0];
}

constexpr const char* kSession =
    "<gtkmorph session>\n<image>\n<image file in>\none.png\n</image file in>\n<preserve aspect>\n1\n"
    "</preserve aspect>\n<mesh file>\na.mesh\n</mesh file>\n</image>\n<image>\n<image file in>\ntwo.png\n"
    "<mesh file>\nb.mesh\n</image>\n<resulting_size>\n201 101\n</resulting_size>\n</gtkmorph session>\n";

TEST_F(Import, ASessionNamesPicturesMeshesAndTheFrame) {
  write_text(folder_ / "a.mesh", kXmorphMesh);
  write_text(folder_ / "b.mesh", kXmorphMesh);
  write_text(folder_ / "x.session", kSession);
  const std::filesystem::path session = folder_ / "x.session";
  EXPECT_EQ(pictures_in({session}), (std::vector<std::filesystem::path>{folder_ / "one.png", folder_ / "two.png"}));
  EXPECT_TRUE(pictures_in({folder_ / "a.mesh", folder_ / "b.mesh"}).empty());
  const ImportReport report = import_into(project_, {{session}, {201, 101}, {201, 101}});
  EXPECT_EQ(report.format, "gtkmorph");
  // The meshes fill half of the frame, so they get a row and a column.
  EXPECT_EQ(cv::Size(project_.mesh->columns, project_.mesh->rows), cv::Size(4, 4));
  EXPECT_EQ(project_.mesh->vertices[project::kSource][5], cv::Point2d(52, 26.8));
  EXPECT_TRUE(contains(error_of([&] { export_to(project_, {{session}, {9, 9}, {9, 9}, true}); }).what(), "only read"));
}

TEST_F(Import, BadSessionsAreRefused) {
  const auto error = [&](const std::string& text) {
    write_text(folder_ / "x.session", text);
    return std::string(import_error({{folder_ / "x.session"}, {9, 9}, {9, 9}}).what());
  };
  EXPECT_TRUE(contains(error("M2\n"), "x.session:1: expected \"<gtkmorph session>\""));
  EXPECT_TRUE(contains(error(""), "found an empty file"));
  EXPECT_TRUE(contains(error("<gtkmorph session>\n"), "names 0 pictures"));
  EXPECT_TRUE(contains(error("<gtkmorph session>\n<mesh file>\na\n"), "before the first <image>"));
  EXPECT_TRUE(contains(error("<gtkmorph session>\n<image>\n<mesh file>\n</mesh file>\n"), "the name of a file"));
  EXPECT_TRUE(contains(error("<gtkmorph session>\n<resulting_size>\n0 5\n"), ":3: <resulting_size> is too small"));
  std::string cut = kSession;
  cut.erase(cut.find("<mesh file>\na.mesh"), 19);
  EXPECT_TRUE(contains(error(cut), "names no picture or no mesh"));
  EXPECT_TRUE(contains(error(kSession), "a.mesh: ")) << "which is not there";
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
  usage(input("a.mesh", "b.txt"), "no format has the extension '.txt'; known are .mesh (xmorph), .session (gtkmorph)");
  usage(input("a", "b"), "no format has the extension ''");
  usage({{folder_ / "a.mesh"}, {9, 9}, {9, 9}}, "1 files are named; xmorph wants two .mesh files, the source's first");
  usage({{}, {9, 9}, {9, 9}}, "no file is named");
}

TEST_F(Import, WhatIsExportedComesBack) {
  std::mt19937 random(7);
  const warp::Mesh source = random_unfolded_mesh(random, {101, 51});
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
