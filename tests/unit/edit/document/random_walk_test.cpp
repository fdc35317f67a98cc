// Thousands of random operations: undo and redo return to every state, and every state can be saved and read back.

#include <array>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/edit/document/document.h"
#include "morph/project/project.h"

namespace morphkit::edit {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const cv::Size kSourceSize(400, 300), kDestinationSize(640, 200);

project::Project empty_project() {
  project::Project project;
  project.pictures[project::kSource].image = "a.png";
  project.pictures[project::kDestination].image = "b.png";
  return project;
}

class Walk {
 public:
  explicit Walk(unsigned seed, project::Project project = empty_project())
      : random_(seed), document(std::move(project), kSourceSize, kDestinationSize) {}

  /// One operation of any kind, sometimes several in one step.
  void operate() {
    if (integer(0, 9) != 0) {
      operate_once();
      return;
    }
    document.begin();
    for (int i = integer(0, 4); i > 0; --i) operate_once();
    if (integer(0, 3) == 0) {
      document.cancel();
    } else {
      document.end();
    }
  }

  int integer(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }

 private:
  void operate_once() {
    const std::array<void (Walk::*)(), 5> kinds = {&Walk::mark, &Walk::change, &Walk::tune, &Walk::mesh, &Walk::select};
    (this->*kinds[static_cast<std::size_t>(integer(0, 4))])();
  }

  void mark() {
    switch (document.project().features.size() < 40 ? integer(0, 5) : 5) {
      case 0:
      case 1:
        document.add_line(side(), place(), place());
        break;
      case 2:
        document.add_point(side(), place());
        break;
      case 3:
        document.add_curve(side(), places(integer(0, 6)), integer(0, 1) == 0);
        break;
      case 4:
        document.duplicate_selected(step());
        break;
      default:
        document.erase_selected();
    }
  }

  void change() {
    switch (integer(0, 5)) {
      case 0:
        document.move_point(feature(), side(), integer(-1, 5), place());
        break;
      case 1:
        document.move_selected(side(), step());
        break;
      case 2:
        document.swap_ends_selected();
        break;
      case 3:
        document.swap_ends_on(side());
        break;
      case 4:
        document.rename(feature(), name());
        break;
      default:
        document.group_selected(name());
    }
  }

  void tune() {
    switch (integer(0, 3)) {
      case 0:
        document.tune(static_cast<Tuning>(integer(0, 2)), number(-1, 10));
        break;
      case 1:
        document.reset_tuning();
        break;
      case 2:
        document.set_easing(static_cast<TimingKind>(integer(0, 1)), easing());
        break;
      default:
        document.set_method(integer(0, 1) == 0 ? project::MethodName::kLines : project::MethodName::kMesh);
    }
  }

  void mesh() {
    switch (integer(0, 9)) {
      case 0:
        document.make_mesh(integer(-1, 6), integer(-1, 6));
        break;
      case 1:
        document.insert_column(integer(-1, 6), number(-0.5, 1.5));
        break;
      case 2:
        document.insert_row(integer(-1, 6), number(-0.5, 1.5));
        break;
      case 3:
        document.remove_column(integer(-1, 7));
        break;
      case 4:
        document.remove_row(integer(-1, 7));
        break;
      default:
        document.move_vertices(std::vector<int>{integer(-1, 30), integer(0, 30)}, side(), step());
    }
  }

  void select() {
    Selection selection;
    for (int i = integer(0, 4); i > 0; --i) selection.features.push_back(feature());
    for (int i = integer(0, 4); i > 0; --i) selection.vertices.push_back(integer(-2, 40));
    if (integer(0, 9) == 0) {
      integer(0, 1) == 0 ? document.select_all_features() : document.select_all_vertices();
    } else {
      document.select(selection);
    }
  }

  SideIndex side() { return integer(0, 1) == 0 ? project::kSource : project::kDestination; }
  int feature() { return integer(-1, static_cast<int>(document.project().features.size())); }
  double number(double least, double most) {
    if (integer(0, 60) == 0) return kNaN;
    return std::uniform_real_distribution<double>(least, most)(random_);
  }
  /// Mostly in the pictures, often in few places so that points meet, now and then far out.
  cv::Point2d place() {
    if (integer(0, 3) == 0) return cv::Point2d(integer(0, 2) * 100, integer(0, 2) * 100);
    if (integer(0, 30) == 0) return {number(-3e6, 3e6), number(-3e6, 3e6)};
    return {number(0, 400), number(0, 300)};
  }
  std::vector<cv::Point2d> places(int count) {
    std::vector<cv::Point2d> points;
    points.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) points.push_back(place());
    return points;
  }
  cv::Point2d step() {
    if (integer(0, 40) == 0) return {number(-3e6, 3e6), number(-3e6, 3e6)};
    return {number(-50, 50), number(-50, 50)};
  }
  std::string name() {
    const std::array<const char*, 7> names = {"", "eye", "mouth", "Öhr", "a\nb", "\xff", "line 1"};
    return names[static_cast<std::size_t>(integer(0, 6))];
  }
  motion::Easing easing() {
    const std::array<motion::Easing, 6> easings = {
        motion::LinearEase{},    motion::SineEase{},        motion::SinusoidalEase{0.2, 0.1},
        motion::ParabolicEase{}, motion::CubicBezierEase{}, motion::KeysEase{{{0, 0, {}}, {0.3, 2, 1.5}, {1, 1, {}}}}};
    return easings[static_cast<std::size_t>(integer(0, 5))];
  }

  std::mt19937 random_;

 public:
  Document document;
};

struct Kept {
  project::Project project;
  Selection selection;
};

void expect_state(const Document& document, const Kept& kept) {
  ASSERT_TRUE(project::same_document(document.project(), kept.project)) << project::to_text(document.project());
}

void expect_valid_selection(const Document& document) {
  for (const int i : document.selection().features)
    ASSERT_LT(static_cast<std::size_t>(i), document.project().features.size());
  for (const int i : document.selection().vertices)
    ASSERT_LT(static_cast<std::size_t>(i), document.mesh_vertices(project::kSource).size());
}

void expect_reads_back(const Document& document) {
  const std::string text = project::to_text(document.project());
  ASSERT_TRUE(project::same_document(project::parse(text, "walk.json"), document.project())) << text;
}

/// Undoes all, redoes all, and compares with `states`, the last of which is the present one.
void expect_all_states(Document& document, const std::vector<Kept>& states) {
  for (std::size_t i = states.size() - 1; i-- > 0;) {
    SCOPED_TRACE(i);
    ASSERT_TRUE(document.undo());
    ASSERT_NO_FATAL_FAILURE(expect_state(document, states[i]));
    ASSERT_EQ(document.selection(), states[i].selection);
  }
  ASSERT_FALSE(document.undo());
  for (std::size_t i = 1; i < states.size(); ++i) {
    SCOPED_TRACE(i);
    ASSERT_TRUE(document.redo());
    ASSERT_NO_FATAL_FAILURE(expect_state(document, states[i]));
    ASSERT_EQ(document.selection(), states[i].selection);
  }
  ASSERT_FALSE(document.redo());
}

void walk(Walk& walk, int operations) {
  Document& document = walk.document;
  std::vector<Kept> states = {{document.project(), document.selection()}};
  std::uint64_t revision = document.revision();
  for (int i = 0; i < operations; ++i) {
    SCOPED_TRACE(i);
    // What is selected when an operation begins is what undo returns to.
    states.back().selection = document.selection();
    walk.operate();
    ASSERT_FALSE(document.in_step());
    ASSERT_NO_FATAL_FAILURE(expect_valid_selection(document));
    if (!project::same_document(document.project(), states.back().project)) {
      ASSERT_NE(document.revision(), revision);
      states.push_back({document.project(), document.selection()});
    }
    revision = document.revision();
    if (walk.integer(0, 19) == 0) {
      ASSERT_NO_FATAL_FAILURE(expect_reads_back(document));
    }
    // Now and then the walk goes on from an earlier state: what came after it is forgotten.
    if (walk.integer(0, 49) == 0) {
      for (int back = walk.integer(1, 5); back > 0 && document.undo(); --back) states.pop_back();
      ASSERT_NO_FATAL_FAILURE(expect_state(document, states.back()));
    }
  }
  states.back().selection = document.selection();
  EXPECT_GT(states.size(), static_cast<std::size_t>(operations) / 5);  // else too little has happened
  expect_all_states(document, states);
}

TEST(RandomWalk, UndoAndRedoReturnToEveryState) {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
    SCOPED_TRACE(seed);
    Walk random(seed);
    ASSERT_NO_FATAL_FAILURE(walk(random, 1500));
    EXPECT_TRUE(random.document.can_undo());
  }
}

/// A project of another hand: a mesh with groups, a mirror, all kinds of curves.
TEST(RandomWalk, StartsAnywhere) {
  const std::string text = R"({"morphkit": 1, "source": {"image": "a.png"}, "destination": {"image": "b.png"},
    "groups": [{"id": "eye"}, {"id": "mouth", "warp": {"a": 3}}, {"id": "idle"}],
    "features": [
      {"id": "dot", "line": {"source": [[5, 5], [5, 5]], "destination": [[9, 9], [9, 9]]}},
      {"id": "ring", "curve": {"source": [[0, 0], [50, 0], [50, 50], [0, 0]],
                               "destination": [[1, 1], [90, 0], [1, 1]]}},
      {"id": "bow", "group": "eye", "curve": {"spline": "bezier", "source": [[0, 0], [9, 0], [9, 9], [0, 9]],
                               "destination": [[0, 0], [9, 0], [9, 9], [0, 9], [1, 2], [3, 4], [5, 6]]}}],
    "mesh": {"size": [4, 3], "groups": [{"group": "mouth", "vertices": [[0, 0], [1, 1], [2, 1]]},
                                        {"group": "idle", "vertices": [[3, 2]]}]},
    "warp": {"border": "mirror"}})";
  for (const unsigned seed : {11U, 12U, 13U}) {
    SCOPED_TRACE(seed);
    Walk random(seed, project::parse(text, "given.json"));
    ASSERT_NO_FATAL_FAILURE(walk(random, 500));
  }
}

}  // namespace
}  // namespace morphkit::edit
