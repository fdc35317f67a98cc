#pragma once
// Morphing by feature lines: one pass of the field per scanline serves both pictures.

#include <utility>
#include <vector>

#include "morph/render/inbetween.h"
#include "morph/render/morpher.h"

namespace morphkit::render {

class LineMorpher : public Morpher {
 public:
  LineMorpher(const project::Project& project, const Stage& stage);

  void require(double) const override {}
  warp::Image frame(double t) const override;
  bool shows(SideIndex side, double t) const override;
  warp::Map map(double t, SideIndex side) const override;
  std::size_t scratch_bytes() const override { return 0; }
  std::string description() const override;

 private:
  struct Moment;

  /// The least and the most that any pixel is dissolved at t, in [0, 1].
  std::pair<double, double> dissolve_range(double t) const;
  void render_band(const Moment& moment, int top, warp::Image& out) const;
  void sample_side(const StageSide& side, warp::Map& positions, warp::Image& out) const;

  const project::Project& project_;
  const Stage& stage_;
  std::vector<LinePair> pairs_;
  bool local_dissolve_ = false;  ///< some feature dissolves in its own time
};

}  // namespace morphkit::render
