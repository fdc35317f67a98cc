#include "morph/project/evaluate.h"

#include <gtest/gtest.h>

namespace morphkit::project {
namespace {

using Doubles = std::vector<double>;

Feature line(std::string id, std::string group, Points source, Points destination) {
  Feature feature;
  feature.id = std::move(id);
  feature.group = std::move(group);
  feature.places = {std::move(source), std::move(destination)};
  return feature;
}

Project small_project() {
  Project project;
  project.groups = {{"late", {}, {}}};
  project.groups[0].pull.b = 0.5;
  project.groups[0].pace.shape = motion::Timing{motion::LinearEase{}, 0.5, 0.5};
  project.features = {line("brow", "", {{1, 2}, {3, 4}}, {{5, 6}, {7, 8}}),
                      line("nose", "late", {{1, 1}, {2, 1}}, {{3, 1}, {3, 2}})};
  project.pull.turns = 2;
  return project;
}

Moment at(const Project& project, double t) {
  return evaluate(project, Clock(project.output).at(t));
}

TEST(Evaluate, TwoPicturesHaveWeightsThatFollowTheTimings) {
  Project project = small_project();
  project.pace.dissolve = motion::Timing{motion::LinearEase{}, 0, 0.25};
  const Moment moment = at(project, 0.125);
  EXPECT_EQ(moment.time.t, 0.125);
  EXPECT_EQ(moment.whole.shape, (Doubles{0.875, 0.125}));
  EXPECT_EQ(moment.whole.dissolve, (Doubles{0.5, 0.5}));
  ASSERT_EQ(moment.feature_weights.size(), 2u);
  EXPECT_EQ(moment.feature_weights[0].shape, (Doubles{0.875, 0.125}));
  EXPECT_EQ(moment.feature_weights[1].shape, (Doubles{1, 0}));
  EXPECT_EQ(moment.feature_weights[1].dissolve, (Doubles{0.5, 0.5}));
}

TEST(Evaluate, AnOvershootMovesPlacesButNotColours) {
  Project project;
  const motion::Timing overshoot{motion::CubicBezierEase{0.3, 3, 0.7, 3}, 0, 1};
  project.pace = {overshoot, overshoot};
  const Moment moment = at(project, 0.5);
  EXPECT_GT(moment.whole.shape[1], 1);
  EXPECT_EQ(moment.whole.shape[0], 1 - moment.whole.shape[1]);
  EXPECT_EQ(moment.whole.dissolve, (Doubles{0, 1}));
}

TEST(Evaluate, FeaturesCarryWhatTheyInherit) {
  const Moment moment = at(small_project(), 0.5);
  ASSERT_EQ(moment.features->size(), 2u);
  const MomentFeature& brow = (*moment.features)[0];
  const MomentFeature& nose = (*moment.features)[1];
  EXPECT_EQ(brow.id, "brow");
  EXPECT_EQ(brow.places[kDestination], (Points{{5, 6}, {7, 8}}));
  EXPECT_EQ(brow.weight.a, 1);
  EXPECT_EQ(brow.weight.b, 2);
  EXPECT_EQ(nose.weight.b, 0.5);
  EXPECT_EQ(nose.turns, 2);
  EXPECT_EQ(nose.scale, warp::LineScale::kAlong);
}

TEST(Evaluate, VerticesTakeTheWeightsOfTheirGroup) {
  Project project = small_project();
  EXPECT_EQ(at(project, 0.5).mesh, nullptr);
  project.mesh = Mesh{3, 2, {Points(6), {}}, {{"late", {{2, 0}, {1, 1}}}}};
  const Moment moment = at(project, 0.75);
  ASSERT_NE(moment.mesh, nullptr);
  EXPECT_EQ(moment.mesh->columns, 3);
  EXPECT_EQ(moment.mesh->vertices[kSource].size(), 6u);
  EXPECT_TRUE(moment.mesh->vertices[kDestination].empty());
  EXPECT_EQ(moment.mesh->group, (std::vector<std::size_t>{0, 0, 1, 0, 1, 0}));
  ASSERT_EQ(moment.mesh_weights.size(), 2u);
  EXPECT_EQ(moment.mesh_weights[0].shape, (Doubles{0.25, 0.75}));
  EXPECT_EQ(moment.mesh_weights[1].shape, (Doubles{0.5, 0.5}));
}

TEST(Evaluate, TheMethodComesWithItsSettings) {
  Project project = small_project();
  project.warp.of<LinesMethod>().field = warp::FieldAccuracy::kExact;
  EXPECT_EQ(std::get<LinesMethod>(at(project, 0).method).field, warp::FieldAccuracy::kExact);
  project.warp.method = MethodName::kMesh;
  project.warp.of<MeshMethod>().order = warp::PassOrder::kColumnsFirst;
  EXPECT_EQ(std::get<MeshMethod>(at(project, 0).method).order, warp::PassOrder::kColumnsFirst);
}

TEST(Evaluator, SharesWhatStaysAndKeepsItsOwnCopy) {
  Project project = small_project();
  const Evaluator moments(project);
  project.features.clear();
  const Moment early = moments.at(moments.clock().at_frame(1)), late = moments.at(moments.clock().at_frame(48));
  EXPECT_EQ(early.features, late.features);
  EXPECT_EQ(late.features->size(), 2u);
  EXPECT_EQ(early.whole.shape, (Doubles{1, 0}));
  EXPECT_EQ(late.whole.shape, (Doubles{0, 1}));
}

}  // namespace
}  // namespace morphkit::project
