#pragma once
// The edited project, its selection and its history. Independent of windows and files.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

#include "cli/edit/document/history.h"
#include "morph/project/evaluate.h"
#include "morph/project/project.h"
#include "morph/render/stage.h"

namespace morphkit::edit {

using project::SideIndex;

inline SideIndex other(SideIndex side) {
  return side == project::kSource ? project::kDestination : project::kSource;
}

/// The numbers that sliders change, for the project or for the selected features.
enum class Tuning { kA, kB, kP };

/// Which timing an easing is set for.
enum class TimingKind { kShape, kDissolve };

/// Every operation below that changes the project is one step of undo; all operations between `begin` and `end` are one
/// step together. An operation that changes nothing makes no step. Positions
/// are px of the picture of that side; they are kept within project limits (kMaxCoordinate) and finite. Indices are
/// into project().features; vertices are row * columns + column.
class Document {
 public:
  /// @param source, destination  sizes of the pictures, px.
  Document(project::Project project, cv::Size source, cv::Size destination);

  const project::Project& project() const noexcept { return state_.project; }
  const project::Evaluator& moments() const;  ///< of the project as it is now
  const Selection& selection() const noexcept { return state_.selection; }
  cv::Size picture_size(SideIndex side) const noexcept { return side == project::kSource ? source_ : destination_; }
  std::uint64_t revision() const noexcept { return revision_; }  ///< another number whenever the project changes

  // Steps
  void begin();   ///< starts a step. @pre not begun
  void end();     ///< ends the step; no step if nothing has changed
  void cancel();  ///< restores the state at `begin`
  bool in_step() const noexcept { return before_.has_value(); }
  bool undo();  ///< false: nothing to undo. @pre not begun
  bool redo();
  bool can_undo() const noexcept { return history_.can_undo(); }
  bool can_redo() const noexcept { return history_.can_redo(); }

  /// Whether the project differs from what was last marked as saved. Undoing back to it makes it unchanged again.
  bool changed() const;
  /// @param project  the content of the file, with its `file` and `original`.
  void mark_saved(const project::Project& project);
  /// Takes another project (one restored, or edited by hand) as one step of undo; clears the selection. `file` and
  /// `original` stay those of the last saved state, also on undo.
  void replace(project::Project project);

  // Selection; no steps of undo
  void select(Selection selection);  ///< ignores what does not exist
  void select_all_features();
  void select_all_vertices();
  void select_none() { select({}); }

  // Features. New ones are selected. The partner of a new mark is placed by the current warp. Each returns the new
  // index, or -1 if the feature would be invalid (both ends in one place, numbers that are not finite, too many).
  int add_line(SideIndex side, cv::Point2d from, cv::Point2d to);
  int add_point(SideIndex side, cv::Point2d at);
  /// Through the points (Catmull-Rom). -1 also if they are not a valid curve (motion::Curve::problem).
  int add_curve(SideIndex side, const std::vector<cv::Point2d>& points, bool closed);
  /// An end of a line, a point, a control point of a curve. Refuses moves that make the feature invalid (a line
  /// or a curve without length). Ends at the same place on both sides move together. @return whether it was done.
  bool move_point(int feature, SideIndex side, int point, cv::Point2d to);
  void move_selected(SideIndex side, cv::Point2d by);  ///< features and vertices
  void erase_selected();                               ///< features only
  void duplicate_selected(cv::Point2d by);             ///< copies with new ids, moved on both sides, selected
  void swap_ends_selected();                           ///< of lines and open curves, on both sides: the same warp
  void swap_ends_on(SideIndex side);  ///< of the selected, on one side: repairs a line drawn in the opposite direction
  /// @return what is wrong with the name (empty, taken), or nothing.
  std::optional<std::string> rename(int feature, const std::string& id);
  /// Puts the selected features into the group, which is made if necessary; empty: into none. Removes groups that are
  /// empty and have no settings. @return what is wrong with the name, or nothing.
  std::optional<std::string> group_selected(const std::string& group);

  // Tuning: of the selected features, or of the project if none is selected
  double tuning(Tuning which) const;       ///< effective, of the first selected feature
  bool tuning_is_own(Tuning which) const;  ///< whether it is set there, not inherited
  void tune(Tuning which, double value);   ///< clamped to what the project file allows
  void reset_tuning();                     ///< the selected features inherit these numbers and timings again
  motion::Timing timing(TimingKind which) const;
  /// Each feature keeps its delay and duration. Does nothing if the project file would refuse the result.
  void set_easing(TimingKind which, const motion::Easing& easing);
  project::MethodName method() const { return project::method_name_of(project()); }
  void set_method(project::MethodName method);  ///< kMesh makes a mesh of 5 x 5 if there is none

  // Mesh
  void make_mesh(int columns, int rows);  ///< evenly spaced on both pictures; replaces the present one
  bool has_mesh() const noexcept { return project().mesh.has_value(); }
  /// Positions of the vertices of a side, also of a uniform mesh. Empty without a mesh.
  std::vector<cv::Point2d> mesh_vertices(SideIndex side) const;
  /// Vertices at the border slide along it, corners stay; all stay on the picture. The mesh may fold.
  void move_vertices(std::span<const int> vertices, SideIndex side, cv::Point2d by);
  void insert_column(int after, double fraction);  ///< between `after` and the next, on both sides at that fraction
  void insert_row(int after, double fraction);
  bool remove_column(int column);  ///< inner ones only: two columns always stay. @return whether it was done
  bool remove_row(int row);

  /// The position in the other picture by the current warp; without features, the same canvas position.
  cv::Point2d counterpart(SideIndex side, cv::Point2d position) const;
  std::vector<cv::Point2d> counterparts(SideIndex side, std::span<const cv::Point2d> positions) const;

 private:
  void change(const std::function<void(project::Project&)>& edit);
  void change_selected(const std::function<void(project::Feature&)>& edit);
  void take(State state);
  void touch();
  int add(project::Feature feature);
  void change_mesh(bool columns, const std::function<void(project::Mesh&)>& edit, const std::function<int(int)>& moved);
  void insert(bool column, int after, double fraction);
  bool remove(bool column, int which);
  cv::Point2d partner_end(SideIndex side, cv::Point2d start, cv::Point2d from, cv::Point2d to) const;

  cv::Size source_, destination_;
  State state_;
  std::optional<State> before_;
  History history_;
  project::Project saved_;
  std::uint64_t revision_ = 0;
  mutable std::optional<project::Evaluator> moments_;  ///< of this revision, if asked before
  mutable std::optional<bool> changed_;                ///< the answer for this revision, if asked before
};

}  // namespace morphkit::edit
