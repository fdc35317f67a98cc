#pragma once
// Draws the model.

#include <memory>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "cli/edit/view/model.h"
#include "cli/edit/view/preview.h"
#include "cli/edit/view/pyramid.h"
#include "cli/edit/view/text.h"
#include "morph/render/inbetween.h"

namespace morphkit::edit {

/// Draws the canvas. Caches the scaled pictures and the lines of features.
class Canvas {
 public:
  /// The pyramids outlive it.
  Canvas(const Pyramid& source, const Pyramid& destination) : source_(source), destination_(destination) {}

  /// @param preview  the newest one. Without an image its `problem` is shown.
  /// @return BGR of model.canvas_size; valid until the next call.
  const cv::Mat3b& draw(const Model& model, const PreviewPicture& preview);

 private:
  /// A picture in its view, without marks.
  struct Shown {
    View view;
    cv::Mat3b pixels;
  };

  void draw_picture(const Model& model, const Panes& panes, SideIndex side);
  void draw_result(const Model& model, const Panes& panes, const PreviewPicture& preview);
  const std::vector<render::FeatureLine>& lines_of(const Model& model, const project::Moment& moment);

  const Pyramid& source_;
  const Pyramid& destination_;
  Type type_;
  cv::Mat3b canvas_;
  std::optional<Shown> shown_[2];
  std::shared_ptr<const std::vector<project::MomentFeature>> features_;
  std::vector<render::FeatureLine> lines_;  ///< of those features
};

}  // namespace morphkit::edit
