#pragma once
// Warping by feature lines: one pass of the field per band serves all pictures.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "morph/render/inbetween.h"
#include "morph/render/warper.h"

namespace morphkit::render {

class LineWarper : public Warper {
 public:
  using Lines = std::shared_ptr<const std::vector<FeatureLine>>;

  /// @param lines  of the moment's features.
  LineWarper(const project::Moment& moment, Lines lines, std::vector<WeightRange> weights, const Stage& stage);

  void positions(int top, std::span<warp::Map> maps, Pixels pixels, std::span<cv::Mat1f> weights) const override;
  std::vector<Finding> problems() const override;
  std::optional<cv::Point2d> carry(SideIndex from, SideIndex to, cv::Point2d point) const override;
  std::string label() const override;

 private:
  std::string name_nearest(Finding& fold) const override;
  std::vector<warp::FieldLine> lines_about(cv::Point2d centre, SideIndex from, SideIndex to) const;

  Lines lines_;
  /// The first one interpolates the weights of the last picture. If the weights vary over the frame, one more field per
  /// picture between the first and the last interpolates that picture's weights.
  std::vector<warp::LineField> fields_;
  warp::FieldAccuracy accuracy_;
};

class LinePlan : public Plan {
 public:
  LinePlan(const project::Evaluator& moments, const Stage& stage);

  std::unique_ptr<Warper> at(const project::Moment& moment) const override;
  std::vector<WeightRange> weights(const project::Moment& moment) const override;

 private:
  LineWarper::Lines lines_of(const project::Moment& moment) const;

  const Stage& stage_;
  project::Moment first_;
  LineWarper::Lines lines_;  ///< of the first moment's features
};

}  // namespace morphkit::render
