#pragma once
// The document at one moment: plain values. What renders, checks, draws and carries points takes these.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "morph/project/clock.h"
#include "morph/project/project.h"

namespace morphkit::project {

/// How much of each picture something takes, in the order of the pictures.
struct Weights {
  std::vector<double> shape;     ///< of the places; they sum to 1, and may lie outside [0, 1]
  std::vector<double> dissolve;  ///< of the colours; each in [0, 1], they sum to 1
};

/// A feature: where it lies and how it pulls.
struct MomentFeature {
  std::string id;
  Mark mark;
  std::vector<Points> places;  ///< one per picture, px of it
  warp::LineWeight weight;     ///< `unit` is 1
  warp::LineScale scale = warp::LineScale::kAlong;
  Between between = Between::kEndpoints;
  double turns = 0;
};

/// The mesh: where it lies.
struct MomentMesh {
  int columns = 0, rows = 0;
  std::vector<Points> vertices;    ///< one list per picture, px of it; an empty one: evenly spaced over the picture
  std::vector<std::size_t> group;  ///< per vertex: index into Moment::mesh_weights
};

/// Features and mesh are shared by the moments of one Evaluator while they stay as they are: equal pointers mean equal
/// values.
struct Moment {
  Time time;
  Method method;
  Weights whole;                                               ///< of what has no timing of its own
  std::shared_ptr<const std::vector<MomentFeature>> features;  ///< in the order of the document; never null
  std::vector<Weights> feature_weights;                        ///< of each feature
  std::shared_ptr<const MomentMesh> mesh;                      ///< null: the document has none
  std::vector<Weights> mesh_weights;                           ///< of the vertices outside all groups, then per group
};

/// Evaluates one document at many moments. Immutable, keeps a copy of what it needs.
/// Cost: O(features + vertices) to make one, O(features) per moment.
class Evaluator {
 public:
  explicit Evaluator(const Project& project);

  const Clock& clock() const noexcept { return clock_; }
  Moment at(Time time) const;

 private:
  Clock clock_;
  Method method_;
  Pace whole_;
  std::shared_ptr<const std::vector<MomentFeature>> features_;
  std::vector<Pace> feature_paces_;
  std::shared_ptr<const MomentMesh> mesh_;
  std::vector<Pace> mesh_paces_;
};

/// The document at one moment.
Moment evaluate(const Project& project, Time time);

}  // namespace morphkit::project
