#pragma once
// Warping by feature lines: one pass of the field per band serves all pictures.

#include <memory>
#include <string>
#include <vector>

#include "morph/render/inbetween.h"
#include "morph/render/warper.h"

namespace morphkit::render {

class LineWarper : public Warper {
 public:
  /// @param lines  of the moment's features.
  LineWarper(const project::Moment& moment, const std::vector<FeatureLine>& lines, std::vector<WeightRange> weights,
             const Stage& stage);

  void positions(int top, std::span<warp::Map> maps, Pixels pixels, std::span<cv::Mat1f> weights) const override;

 private:
  /// The first one spreads the weights of the last picture; where these are not alike everywhere, one more spreads
  /// those of each picture between the first and the last.
  std::vector<warp::LineField> fields_;
  warp::FieldAccuracy accuracy_;
};

class LinePlan : public Plan {
 public:
  LinePlan(const project::Evaluator& moments, const Stage& stage);

  std::unique_ptr<Warper> at(const project::Moment& moment) const override;
  std::vector<WeightRange> weights(const project::Moment& moment) const override;
  std::string label() const override;

 private:
  using Lines = std::shared_ptr<const std::vector<FeatureLine>>;
  Lines lines_of(const project::Moment& moment) const;

  const Stage& stage_;
  project::Moment first_;
  Lines lines_;  ///< of the first moment's features
};

}  // namespace morphkit::render
