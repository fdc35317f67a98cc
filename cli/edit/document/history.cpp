#include "cli/edit/document/history.h"

#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace morphkit::edit {

using Features = std::vector<std::shared_ptr<const project::Feature>>;
using Groups = std::vector<project::Group>;

struct History::Stored {
  std::shared_ptr<const project::Project> rest;  ///< without features, groups and mesh
  std::shared_ptr<const Features> features;
  std::shared_ptr<const Groups> groups;
  std::shared_ptr<const project::Mesh> mesh;  ///< null if there is none
  Selection selection;
};

namespace {

/// The neighbour's part if it is equal, else a new one.
template <typename T>
std::shared_ptr<const T> shared(const std::shared_ptr<const T>& neighbour, const T& part) {
  if (neighbour && *neighbour == part) return neighbour;
  return std::make_shared<const T>(part);
}

/// The project less the parts that are kept apart. All other members stay, also those that are added one day.
std::shared_ptr<const project::Project> shared_rest(const std::shared_ptr<const project::Project>& neighbour,
                                                    project::Project rest) {
  rest.features.clear();
  rest.groups.clear();
  rest.mesh.reset();
  rest.file.clear();
  rest.original.reset();
  const bool same = neighbour && project::same_document(*neighbour, rest);
  return same ? neighbour : std::make_shared<const project::Project>(std::move(rest));
}

/// Where one was erased or put in, the others have moved: they are known by their ids.
std::shared_ptr<const Features> shared_features(const std::shared_ptr<const Features>& neighbour,
                                                const std::vector<project::Feature>& features) {
  if (!neighbour) return shared_features(std::make_shared<const Features>(), features);
  auto result = std::make_shared<Features>();
  result->reserve(features.size());
  std::unordered_map<std::string_view, std::size_t> by_id;
  bool all_there = features.size() == neighbour->size();
  for (std::size_t i = 0; i < features.size(); ++i) {
    std::size_t at = i;
    if (i >= neighbour->size() || (*neighbour)[i]->id != features[i].id) {
      all_there = false;
      if (by_id.empty()) {
        for (std::size_t k = 0; k < neighbour->size(); ++k) by_id.emplace((*neighbour)[k]->id, k);
      }
      const auto found = by_id.find(features[i].id);
      at = found == by_id.end() ? neighbour->size() : found->second;
    }
    result->push_back(shared(at < neighbour->size() ? (*neighbour)[at] : nullptr, features[i]));
    all_there = all_there && result->back() == (*neighbour)[i];
  }
  if (all_there) return neighbour;
  return result;
}

}  // namespace

std::shared_ptr<const History::Stored> History::store(const State& state, const Stored* neighbour) {
  static const Stored kNone;
  const Stored& near = neighbour ? *neighbour : kNone;
  auto stored = std::make_shared<Stored>();
  stored->rest = shared_rest(near.rest, state.project);
  stored->features = shared_features(near.features, state.project.features);
  stored->groups = shared(near.groups, state.project.groups);
  if (state.project.mesh) stored->mesh = shared(near.mesh, *state.project.mesh);
  stored->selection = state.selection;
  return stored;
}

State History::restore(const Stored& stored) {
  State state{*stored.rest, stored.selection};
  state.project.features.reserve(stored.features->size());
  for (const auto& feature : *stored.features) state.project.features.push_back(*feature);
  state.project.groups = *stored.groups;
  if (stored.mesh) state.project.mesh = *stored.mesh;
  return state;
}

void History::push(const State& state) {
  past_.push_back(store(state, nearest()));
  future_.clear();
  restored_.reset();
}

State History::undo(const State& now) {
  return step(now, past_, future_);
}

State History::redo(const State& now) {
  return step(now, future_, past_);
}

const History::Stored* History::nearest() const {
  return restored_ ? restored_.get() : past_.empty() ? nullptr : past_.back().get();
}

State History::step(const State& now, Side& from, Side& to) {
  to.push_back(store(now, nearest()));
  restored_ = std::move(from.back());
  from.pop_back();
  return restore(*restored_);
}

HistorySize History::size() const {
  std::unordered_set<const void*> parts;
  for (const Side* side : {&past_, &future_}) {
    for (const auto& stored : *side) {
      parts.insert({stored->rest.get(), stored->features.get(), stored->groups.get()});
      if (stored->mesh) parts.insert(stored->mesh.get());
      for (const auto& feature : *stored->features) parts.insert(feature.get());
    }
  }
  return {past_.size() + future_.size(), parts.size()};
}

}  // namespace morphkit::edit
