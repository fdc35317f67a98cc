#include <vector>

#include <gtest/gtest.h>

#include "cli/edit/document/document.h"
#include "morph/project/limits.h"
#include "tests/unit/edit/document/make_document.h"

namespace morphkit::edit {
namespace {

using test::document_of;
using test::empty_project;
using test::expect_reads_back;
using test::feature;
using test::kHere;
using test::kNaN;

TEST(Tuning, OfTheSelectionOrOfTheProject) {
  Document document = document_of();
  document.tune(Tuning::kB, 3);
  document.add_point(kHere, {1, 2});
  EXPECT_EQ(document.tuning(Tuning::kB), 3);
  EXPECT_FALSE(document.tuning_is_own(Tuning::kB));
  document.tune(Tuning::kB, 99);
  EXPECT_EQ(document.tuning(Tuning::kB), project::kMaxFalloff);
  EXPECT_TRUE(document.tuning_is_own(Tuning::kB));
  document.tune(Tuning::kP, kNaN);
  EXPECT_FALSE(document.tuning_is_own(Tuning::kP));
  document.reset_tuning();
  EXPECT_EQ(document.tuning(Tuning::kB), 3);
  document.select_none();
  EXPECT_TRUE(document.tuning_is_own(Tuning::kB));
}

TEST(Tuning, InheritingLeavesTheRestOfAFeatureAlone) {
  project::Project project = empty_project();
  Document first(project, {400, 300}, {400, 300});
  first.add_line(kHere, {10, 20}, {60, 40});
  project = first.project();
  project.features[0].pull.between = project::Between::kCentre;
  project.features[0].pull.turns = 1;
  project.features[0].pace.shape = motion::Timing{motion::SineEase{}, 0.25, 0.5};
  project.features[0].pull.p = 1;
  Document document(project, {400, 300}, {400, 300});
  document.select({{0}, {}});
  document.reset_tuning();
  project::Pull left;
  left.between = project::Between::kCentre;
  left.turns = 1;
  EXPECT_EQ(feature(document, 0).pull, left);
  EXPECT_EQ(feature(document, 0).pace, project::Pace{});
}

TEST(Easings, LeaveDelaysAndDurationsOfEveryFeature) {
  project::Project project = empty_project();
  project.pace.shape = motion::Timing{motion::LinearEase{}, 0.25, 0.5};
  Document document(project, {400, 300}, {400, 300});
  document.set_easing(TimingKind::kShape, motion::SineEase{});
  EXPECT_EQ(document.timing(TimingKind::kShape), (motion::Timing{motion::SineEase{}, 0.25, 0.5}));
  EXPECT_EQ(document.timing(TimingKind::kDissolve), motion::Timing{});
  document.add_line(kHere, {10, 20}, {60, 40});
  document.add_point(kHere, {5, 6});
  project = document.project();
  project.features[1].pace.shape = motion::Timing{motion::LinearEase{}, 0.5, 0.25};
  document.replace(project);
  document.select({{0, 1}, {}});
  document.set_easing(TimingKind::kShape, motion::ParabolicEase{});
  EXPECT_EQ(feature(document, 0).pace.shape, (motion::Timing{motion::ParabolicEase{}, 0.25, 0.5}));
  EXPECT_EQ(feature(document, 1).pace.shape, (motion::Timing{motion::ParabolicEase{}, 0.5, 0.25}));
}

TEST(Easings, ThatTheFileWouldRefuseAreNotSet) {
  Document document = document_of();
  document.set_easing(TimingKind::kShape, motion::SineEase{});
  const std::vector<motion::Easing> refused = {motion::StepEase{2}, motion::CubicBezierEase{0, 1e9, 1, 0},
                                               motion::SinusoidalEase{kNaN, 1}, motion::KeysEase{}};
  for (const motion::Easing& easing : refused) document.set_easing(TimingKind::kShape, easing);
  EXPECT_EQ(document.timing(TimingKind::kShape), (motion::Timing{motion::SineEase{}, 0, 1}));
  expect_reads_back(document);
}

}  // namespace
}  // namespace morphkit::edit
