#pragma once
// A frame is a pure function of (project, frame number). Everything that frames share is prepared once.

#include <optional>
#include <span>
#include <vector>

#include "morph/media/image_file.h"
#include "morph/project/project.h"
#include "morph/render/inbetween.h"
#include "morph/render/placement.h"
#include "warp/image.h"
#include "warp/line_field.h"
#include "warp/sample.h"

namespace morphkit::render {

enum class SideName { kSource, kDestination };

/// The two pictures (and the background) of a project, loaded.
struct Pictures {
  media::Picture source, destination;
  std::optional<media::Picture> background;
};

/// Loads what the project names. @throws Error as media::read_picture.
Pictures load_pictures(const project::Project& project);

/// The canvas that a project renders to, px: its output.size, or the size of the source picture.
cv::Size canvas_size(const project::Project& project, cv::Size source_picture);

/// Renders moments of one project. Immutable: any number of threads may render at once.
class Renderer {
 public:
  Renderer(project::Project project, Pictures pictures);

  cv::Size size() const noexcept { return size_; }        ///< of the canvas, px
  bool has_alpha() const noexcept { return has_alpha_; }  ///< whether a frame may be transparent
  const project::Project& project() const noexcept { return project_; }
  const std::vector<LinePair>& pairs() const noexcept { return pairs_; }  ///< canvas px

  /// t of a frame number: 0 at the first, 1 at the last; 0 if there is only one.
  double time_of(int frame) const noexcept;

  cv::Size picture_size(SideName side) const noexcept { return this->side(side).file_size; }  ///< of the file, px
  const Placement& placement(SideName side) const noexcept { return this->side(side).file; }

  /// The frame at t in [0, 1]; parallel over rows. t = 0 and 1 give the pictures bit for bit where the canvas has
  /// their size and nothing shows behind them. Memory: the frame and a few rows.
  warp::Image frame(double t) const;

  /// Source positions for every canvas pixel at t, px of that side's image file.
  warp::Map map(double t, SideName side_name) const;

 private:
  /// One picture, ready for sampling. A picture larger than its place on the canvas is reduced once, by area
  /// averaging; `file` places the picture as it is in the file, `held` as it is held in memory.
  struct Side {
    warp::Image image;
    cv::Size file_size;
    Placement file, held;
    warp::Border border = warp::Border::kClamp;
  };

  struct Moment;

  const Side& side(SideName name) const noexcept { return name == SideName::kSource ? source_ : destination_; }
  Side make_side(const media::Picture& picture) const;
  void make_background(const std::optional<media::Picture>& picture);
  void render_row(const Moment& moment, int y, std::span<warp::Pixel> out) const;
  void sample_side(const Side& side, std::span<warp::MapPoint> positions, std::span<warp::Pixel> out) const;

  project::Project project_;
  cv::Size size_;
  Side source_, destination_;
  std::vector<LinePair> pairs_;
  bool local_dissolve_ = false;  ///< some feature dissolves in its own time
  bool has_alpha_ = false;
  warp::Image background_;  ///< empty: nothing behind; 1x1: a colour; else of canvas size
};

}  // namespace morphkit::render
