#pragma once
// Everything that the canvas shows and the hand changes: the document, how it is looked at, and what is going on.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/edit/document/document.h"
#include "cli/edit/view/layout.h"
#include "cli/edit/view/view.h"

namespace morphkit::edit {

enum class Tool { kSelect, kLine, kPoint, kCurve, kMesh };

/// What the result pane shows.
enum class Show { kDissolve, kSource, kDestination, kDifference, kGrid };

/// Something that can be held: a point of a feature, a whole feature, or a vertex of the mesh.
struct Handle {
  SideIndex side = kSource;
  int feature = -1;  ///< -1: a vertex
  int point = -1;    ///< of the feature; -1: the whole of it
  int vertex = -1;   ///< -1: a feature
  bool operator==(const Handle&) const = default;
};

/// What is being drawn and is no feature yet.
struct Sketch {
  Tool tool = Tool::kLine;  ///< kSelect: a rubber band; kLine; kCurve
  SideIndex side = kSource;
  std::vector<cv::Point2d> points;  ///< picture px; band: two corners; line: two ends; curve: those clicked so far
  cv::Point2d next;                 ///< curve: where the next click would put a point
};

/// One line of text that is being typed into the status line.
struct Entry {
  enum class What { kName, kGroup };
  What what = What::kName;
  std::string text;
};

/// A question over the canvas that must be answered first. Answers are single keys, and can be clicked.
struct Question {
  struct Answer {
    char key = 0;       ///< lower case
    std::string label;  ///< "Save and close"
  };
  std::string title;
  std::vector<std::string> lines;
  std::vector<Answer> answers;
};

struct Switches {
  bool locked = true;    ///< both pictures zoom and pan together
  bool snap = true;      ///< to ends of other features and to edges
  bool onion = false;    ///< features at several moments
  bool folds = true;     ///< painted red
  bool loupe = false;    ///< a magnifier at the mouse
  bool features = true;  ///< marks are drawn
};

struct Model {
  Model(project::Project project, cv::Size source, cv::Size destination, cv::Size canvas)
      : document(std::move(project), source, destination), canvas_size(canvas) {}

  Document document;
  cv::Size canvas_size;  ///< of the window, px

  Tool tool = Tool::kLine;
  Show show = Show::kDissolve;
  View source_view, destination_view, result_view;  ///< the last one of the canvas that is rendered
  double t = 0.5;
  bool playing = false;
  double speed = 1;  ///< times the project's own
  Switches switches;

  cv::Point mouse{-1, -1};      ///< canvas px
  std::optional<Handle> hover;  ///< what a press would hold
  std::optional<Handle> held;
  std::optional<cv::Point2d> snapped;  ///< picture px on the side of `held` or the sketch: what it has snapped to
  std::optional<Sketch> sketch;
  std::optional<Entry> entry;
  std::optional<Question> question;
  std::optional<char> answer;  ///< to `question`; whoever asked takes both away
  bool help = false;
  bool welcome = false;   ///< the three lines of a first start
  std::string message;    ///< status line: what just happened
  std::string file_name;  ///< for the status line

  View& view(Pane pane) { return this->*member_of(pane); }
  const View& view(Pane pane) const { return this->*member_of(pane); }
  /// Size of what a pane shows, px: a picture, or the canvas that is rendered.
  cv::Size content_size(Pane pane) const;
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
