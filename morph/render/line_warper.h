#pragma once
// Warping by feature lines: one pass of the field per band serves all pictures.

#include <vector>

#include "morph/render/inbetween.h"
#include "morph/render/warper.h"

namespace morphkit::render {

class LineWarper : public Warper {
 public:
  /// @param lines  of the moment, canvas px; one target per side.
  LineWarper(std::span<const warp::FieldLine> lines, warp::FieldAccuracy accuracy, DissolveRange dissolve,
             const Stage& stage);

  void positions(int top, std::span<warp::Map> maps, Pixels pixels, cv::Mat1f* dissolve) const override;

 private:
  warp::LineField field_;
  warp::FieldAccuracy accuracy_;
};

class LinePlan : public Plan {
 public:
  LinePlan(const project::Project& project, const project::LinesMethod& method, const Stage& stage);

  std::unique_ptr<Warper> at(double t) const override;
  DissolveRange dissolve(double t) const override;
  std::string label() const override;

 private:
  const project::Project& project_;
  const project::LinesMethod method_;
  const Stage& stage_;
  std::vector<LinePair> pairs_;
  bool local_dissolve_ = false;  ///< some feature dissolves in its own time
};

}  // namespace morphkit::render
