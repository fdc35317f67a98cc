// Which method a document means, and which settings it does not use.

#include <gtest/gtest.h>

#include "morph/project/project.h"

namespace morphkit::project {
namespace {

using Sentences = std::vector<std::string>;

Project with_method(MethodName method) {
  Project project;
  project.mesh = Mesh{3, 3, {{}, {}}, {}};
  project.warp.method = method;
  return project;
}

TEST(Method, HoldsTheSettingsOfItsOwnKindAlone) {
  Project project = with_method(MethodName::kLines);
  project.warp.of<LinesMethod>().field = warp::FieldAccuracy::kExact;
  project.warp.of<MeshMethod>().spline = warp::MeshSpline::kLinear;
  EXPECT_EQ(method_of(project), Method(LinesMethod{warp::FieldAccuracy::kExact}));
  project.warp.method = MethodName::kMesh;
  EXPECT_EQ(method_of(project), Method(MeshMethod{warp::MeshSpline::kLinear, warp::PassOrder::kAuto}));
}

TEST(UnusedSettings, DefaultsAreNotTold) {
  EXPECT_TRUE(unused_settings(with_method(MethodName::kLines)).empty());
  EXPECT_TRUE(unused_settings(with_method(MethodName::kMesh)).empty());
}

TEST(UnusedSettings, OfLinesAreThoseOfTheMesh) {
  Project project = with_method(MethodName::kLines);
  project.warp.of<LinesMethod>().field = warp::FieldAccuracy::kExact;
  project.warp.filter = warp::Filter::kLanczos;
  project.pull.a = 5;
  EXPECT_TRUE(unused_settings(project).empty());
  project.warp.of<MeshMethod>() = {warp::MeshSpline::kLinear, warp::PassOrder::kRowsFirst};
  EXPECT_EQ(unused_settings(project), (Sentences{"\"spline\" of \"warp\" is not used, for the method is lines",
                                                 "\"order\" of \"warp\" is not used, for the method is lines"}));
}

TEST(UnusedSettings, OfAMeshAreThoseOfLinesAndTheFilter) {
  Project project = with_method(MethodName::kMesh);
  project.warp.of<MeshMethod>() = {warp::MeshSpline::kLinear, warp::PassOrder::kRowsFirst};
  EXPECT_TRUE(unused_settings(project).empty());
  project.pull.b = 1;
  project.warp.of<LinesMethod>().field = warp::FieldAccuracy::kExact;
  project.warp.filter = warp::Filter::kLanczos;
  EXPECT_EQ(unused_settings(project), (Sentences{"\"b\" of \"warp\" is not used, for the method is mesh",
                                                 "\"field\" of \"warp\" is not used, for the method is mesh",
                                                 "\"filter\" of \"warp\" is not used, for the method is mesh"}));
}

}  // namespace
}  // namespace morphkit::project
