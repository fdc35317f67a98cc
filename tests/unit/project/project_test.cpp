#include "morph/project/project.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/unit/project/documents.h"

namespace morphkit::project {
namespace {

using test::with;

TEST(MethodName, TheMethodIsAsTheProjectSaysOrHas) {
  const std::string features = R"(, "features": [{"id": "x", "point": {"source": [0, 0], "destination": [0, 0]}}])";
  const std::string mesh = R"("mesh": {"size": [2, 2]})";
  const auto method = [](const std::string& more) { return method_name_of(parse(with(more), "")); };
  EXPECT_EQ(method(""), MethodName::kLines);
  EXPECT_EQ(method(mesh), MethodName::kMesh);
  EXPECT_EQ(method(mesh + features), MethodName::kLines);
  EXPECT_EQ(method(mesh + features + R"(, "warp": {"method": "mesh"})"), MethodName::kMesh);
  EXPECT_EQ(method(mesh + R"(, "warp": {"method": "lines"})"), MethodName::kLines);
}

TEST(Resolve, PathsStartAtTheFolderOfTheProject) {
  Project project;
  project.file = "shots/pair.json";
  EXPECT_EQ(resolve(project, "a.png"), "shots/a.png");
  EXPECT_EQ(resolve(project, "/abs.png"), "/abs.png");
}

TEST(SameDocument, TheFileDoesNotCountButEveryValueDoes) {
  const Project project = parse(test::kFull, "a.json");
  Project other = parse(test::kFull, "b.json");
  EXPECT_TRUE(same_document(project, other));
  other.features[1].pull.a = 9;
  EXPECT_FALSE(same_document(project, other));
}

TEST(Effective, TheNearestSettingWins) {
  Project project = parse(test::kFull, "");
  const Pull nose = effective_pull(project, project.features[1]);
  EXPECT_EQ(nose.a, 10);  // its own
  EXPECT_EQ(nose.b, 2);   // the project's
  const Pull eye = effective_pull(project, project.features[0]);
  EXPECT_EQ(eye.a, 1);
  EXPECT_EQ(eye.b, 1.5);  // its group's
  EXPECT_EQ(effective_pace(project, project.features[0]).shape, project.groups[0].pace.shape);
  EXPECT_EQ(effective_pace(project, project.features[1]).shape, project.pace.shape);
}

TEST(Effective, OfAGroup) {
  const Project project = parse(test::kMesh, "");
  EXPECT_EQ(effective_pace(project, "face").shape, (motion::Timing{motion::SineEase{}, 0, 1}));
  EXPECT_EQ(effective_pace(project, "rim"), effective_pace(project));
  EXPECT_EQ(effective_pull(project, "rim"), effective_pull(project));
  EXPECT_EQ(effective_pace(project, std::string()), effective_pace(project));
}

TEST(Effective, NothingStaysOpen) {
  const Pull pull = effective_pull(Project{});
  const Pace pace = effective_pace(Project{});
  EXPECT_EQ(pull.a, 1);
  EXPECT_EQ(pull.b, 2);
  EXPECT_EQ(pull.p, 0);
  EXPECT_EQ(pull.scale, warp::LineScale::kAlong);
  EXPECT_EQ(pull.between, Between::kEndpoints);
  EXPECT_EQ(pull.turns, 0);
  EXPECT_EQ(pace.shape, motion::Timing{});
  EXPECT_EQ(pace.dissolve, motion::Timing{});
  EXPECT_EQ(effective_pull(Project{}, Feature{}), pull);
  EXPECT_EQ(effective_pace(Project{}, Feature{}), pace);
}

}  // namespace
}  // namespace morphkit::project
