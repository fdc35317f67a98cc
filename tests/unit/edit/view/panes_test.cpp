#include "cli/edit/view/panes.h"

#include <vector>

#include <gtest/gtest.h>

namespace morphkit::edit {
namespace {

const cv::Size kCanvases[] = {kMinCanvas, {1280, 720}, {1600, 900}, {3840, 2160}, {900, 1600}};

TEST(Panes, LieOnTheCanvasAndNeverOverEachOther) {
  for (const cv::Size canvas : kCanvases) {
    SCOPED_TRACE(testing::Message() << canvas);
    const Panes panes = panes_of(canvas);
    std::vector<cv::Rect> all = {panes.top, panes.time, panes.tuning, panes.status};
    all.insert(all.end(), std::begin(panes.heads), std::end(panes.heads));
    all.insert(all.end(), std::begin(panes.panes), std::end(panes.panes));
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_FALSE(all[i].empty()) << i;
      EXPECT_EQ(all[i] & cv::Rect({0, 0}, canvas), all[i]) << i;
      for (std::size_t j = 0; j < i; ++j) EXPECT_TRUE((all[i] & all[j]).empty()) << i << " and " << j;
    }
  }
}

TEST(Panes, ThreeOfOneSizeWithTheirTitlesAbove) {
  const Panes panes = panes_of({1600, 900});
  EXPECT_EQ(panes.scale, 1);
  for (const Pane pane : kPanes) {
    EXPECT_EQ(panes.pane(pane).size(), panes.pane(Pane::kSource).size());
    EXPECT_EQ(panes.head(pane).br().y, panes.pane(pane).y);
    EXPECT_EQ(panes.head(pane).x, panes.pane(pane).x);
  }
}

TEST(Panes, TheOneAtAPosition) {
  const Panes panes = panes_of({1600, 900});
  for (const Pane pane : kPanes) {
    EXPECT_EQ(panes.pane_at(panes.pane(pane).tl()), pane);
    EXPECT_EQ(panes.pane_at(panes.pane(pane).br() - cv::Point(1, 1)), pane);
    EXPECT_NE(panes.pane_at(panes.pane(pane).br()), pane);
  }
  EXPECT_FALSE(panes.pane_at(panes.status.tl()));
}

}  // namespace
}  // namespace morphkit::edit
