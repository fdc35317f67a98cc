#include "cli/edit/document/history.h"

#include <string>

#include <gtest/gtest.h>

#include "cli/edit/document/document.h"
#include "tests/unit/edit/document/make_document.h"

namespace morphkit::edit {
namespace {

using test::empty_project;
using test::marked_line;

TEST(History, AStepCostsWhatItChanged) {
  State state{empty_project(), {}};
  constexpr int kFeatures = 50, kSteps = 2000;
  for (int i = 0; i < kFeatures; ++i)
    state.project.features.push_back(marked_line(std::to_string(i), {{0, 0}, {1.0 * i, 9}}, {{0, 0}, {9, 9}}));
  History history;
  history.push(state);
  const std::size_t first = history.size().parts;
  EXPECT_EQ(first, kFeatures + 3U) << "the rest, the list of features, the groups";
  for (int i = 0; i < kSteps; ++i) {
    state.project.features[static_cast<std::size_t>(i % kFeatures)].places[project::kSource][0].x += 1;
    history.push(state);
  }
  const HistorySize size = history.size();
  EXPECT_EQ(size.states, kSteps + 1U);
  EXPECT_EQ(size.parts, first + 2 * kSteps) << "each step: one feature, and the list";
}

TEST(History, SharesAlsoWhereFeaturesHaveMovedUp) {
  State state{empty_project(), {}};
  for (int i = 0; i < 10; ++i)
    state.project.features.push_back(marked_line(std::to_string(i), {{0, 0}, {1, 9}}, {{0, 0}, {9, 9}}));
  History history;
  history.push(state);
  const std::size_t first = history.size().parts;
  state.project.features.erase(state.project.features.begin() + 2);
  history.push(state);
  EXPECT_EQ(history.size().parts, first + 1) << "a list of features";
  state.project.output.frames = 3;
  for (int i = 0; i < 3; ++i) {
    SCOPED_TRACE(i);
    state = history.undo(history.undo(state));
    EXPECT_EQ(state.project.features.size(), 10U);
    state = history.redo(history.redo(state));
    EXPECT_EQ(state.project.output.frames, 3);
    EXPECT_LE(history.size().parts, first + 2) << "the rest, once; going back and forth makes nothing new";
  }
}

}  // namespace
}  // namespace morphkit::edit
