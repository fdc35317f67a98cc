#include "morph/project/evaluate.h"

#include <algorithm>
#include <utility>

namespace morphkit::project {
namespace {

/// The two-picture spelling of weights: from the first picture to the second one.
Weights weights_at(const Pace& pace, double t) {
  const double shape = motion::progress(*pace.shape, t);
  const double dissolve = std::clamp(motion::progress(*pace.dissolve, t), 0.0, 1.0);
  return {{1 - shape, shape}, {1 - dissolve, dissolve}};
}

std::vector<Weights> weights_at(const std::vector<Pace>& paces, double t) {
  std::vector<Weights> weights;
  weights.reserve(paces.size());
  for (const Pace& pace : paces) weights.push_back(weights_at(pace, t));
  return weights;
}

MomentFeature feature_of(const Project& project, const Feature& feature) {
  const Pull pull = effective_pull(project, feature);
  return {feature.id,  feature.mark,  feature.places,        {*pull.a, *pull.b, *pull.p},
          *pull.scale, *pull.between, pull.turns.value_or(0)};
}

MomentMesh mesh_of(const Mesh& mesh) {
  MomentMesh result{mesh.columns, mesh.rows, mesh.vertices, {}};
  const auto columns = static_cast<std::size_t>(mesh.columns);
  result.group.assign(columns * static_cast<std::size_t>(mesh.rows), 0);
  for (std::size_t i = 0; i < mesh.groups.size(); ++i)
    for (const cv::Point& vertex : mesh.groups[i].vertices)
      result.group[static_cast<std::size_t>(vertex.y) * columns + static_cast<std::size_t>(vertex.x)] = i + 1;
  return result;
}

}  // namespace

Evaluator::Evaluator(const Project& project)
    : clock_(project.output), method_(method_of(project)), whole_(effective_pace(project)) {
  std::vector<MomentFeature> features;
  features.reserve(project.features.size());
  feature_paces_.reserve(project.features.size());
  for (const Feature& feature : project.features) {
    features.push_back(feature_of(project, feature));
    feature_paces_.push_back(effective_pace(project, feature));
  }
  features_ = std::make_shared<const std::vector<MomentFeature>>(std::move(features));
  if (!project.mesh) return;
  mesh_ = std::make_shared<const MomentMesh>(mesh_of(*project.mesh));
  mesh_paces_.push_back(whole_);
  for (const MeshGroup& group : project.mesh->groups) mesh_paces_.push_back(effective_pace(project, group.group));
}

Moment Evaluator::at(Time time) const {
  return {time,
          method_,
          weights_at(whole_, time.t),
          features_,
          weights_at(feature_paces_, time.t),
          mesh_,
          weights_at(mesh_paces_, time.t)};
}

Moment evaluate(const Project& project, Time time) {
  return Evaluator(project).at(time);
}

}  // namespace morphkit::project
