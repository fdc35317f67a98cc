#pragma once
// The state of the preview tool: the document, the views of it, and the input in progress.

#include <optional>
#include <string>
#include <vector>

#include "cli/edit/document/document.h"
#include "cli/edit/view/actions.h"
#include "cli/edit/view/panes.h"
#include "cli/edit/view/view.h"

namespace morphkit::edit {

/// A hit: a point of a feature, a whole feature, or a vertex of the mesh.
struct Handle {
  SideIndex side = project::kSource;
  int feature = -1;  ///< -1: a vertex
  int point = -1;    ///< of the feature; -1: the whole of it
  int vertex = -1;   ///< -1: a feature
  bool operator==(const Handle&) const = default;
};

/// A shape that is being drawn and is not in the document yet.
struct Sketch {
  enum class Shape { kBox, kLine, kCurve };
  Shape shape = Shape::kLine;
  SideIndex side = project::kSource;
  std::vector<cv::Point2d> points;  ///< picture px; box: two corners; line: two ends; curve: the clicks so far
  cv::Point2d next;                 ///< curve: where the next click would put a point
};

/// A line of text that the user types into the status line.
struct Entry {
  enum class What { kName, kGroup };
  What what = What::kName;
  std::string text;
};

/// A question over the canvas that must be answered first. Answers are single keys and can be clicked.
struct Question {
  struct Answer {
    char key = 0;       ///< lower case
    std::string label;  ///< "Save and close"
  };
  std::string title;
  std::vector<std::string> lines;
  std::vector<Answer> answers;
};

struct Model {
  Model(project::Project project, cv::Size source, cv::Size destination, cv::Size canvas)
      : document(std::move(project), source, destination), canvas_size(canvas) {}

  Document document;
  cv::Size canvas_size;  ///< of the window, px

  ToolId tool = ToolId::kLine;
  Show show = Show::kDissolve;
  View source_view, destination_view, result_view;  ///< result_view: of the output canvas
  double t = 0.5;
  bool playing = false;
  double speed = 1;  ///< times the project's own
  Switches switches;

  cv::Point mouse{-1, -1};             ///< canvas px
  std::optional<Handle> hover;         ///< hit test at the mouse
  std::optional<Handle> held;          ///< the last one that was pressed; keys act on it
  std::optional<cv::Point2d> snapped;  ///< snap target of the drag, picture px on the side of `held` or the sketch
  std::optional<Sketch> sketch;
  std::optional<Entry> entry;
  std::optional<Question> question;
  std::optional<char> answer;  ///< to `question`; the editor resets both
  bool help = false;
  bool welcome = false;    ///< the three lines of a first start
  std::string message;     ///< status line: what just happened
  bool complaint = false;  ///< `message` says that something was not done
  std::string file_name;   ///< for the status line

  View& view(Pane pane) { return this->*member_of(pane); }
  const View& view(Pane pane) const { return this->*member_of(pane); }
  /// Size of the content of a pane, px: a picture, or the output canvas.
  cv::Size content_size(Pane pane) const;
  /// The document at t: what the panes show.
  project::Moment moment() const { return document.moments().at(time()); }
  project::Time time() const { return document.moments().clock().at(t); }
  /// Fits all three.
  void fit_views();

 private:
  static View Model::*member_of(Pane pane) {
    return pane == Pane::kSource        ? &Model::source_view
           : pane == Pane::kDestination ? &Model::destination_view
                                        : &Model::result_view;
  }
};

}  // namespace morphkit::edit
