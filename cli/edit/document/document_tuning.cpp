// The numbers and timings of a document.

#include <algorithm>
#include <cmath>

#include "cli/edit/document/document.h"
#include "morph/project/limits.h"

namespace morphkit::edit {
namespace {

using project::Influence;
using project::Project;

std::optional<double>& value_of(Influence& influence, Tuning which) {
  return which == Tuning::kA ? influence.a : which == Tuning::kB ? influence.b : influence.p;
}

const std::optional<double>& value_of(const Influence& influence, Tuning which) {
  return which == Tuning::kA ? influence.a : which == Tuning::kB ? influence.b : influence.p;
}

std::optional<motion::Timing>& timing_of(Influence& influence, Progress which) {
  return which == Progress::kShape ? influence.shape : influence.dissolve;
}

const std::optional<motion::Timing>& timing_of(const Influence& influence, Progress which) {
  return which == Progress::kShape ? influence.shape : influence.dissolve;
}

double most(Tuning which) {
  return which == Tuning::kA ? project::kMaxCoordinate : which == Tuning::kB ? project::kMaxFalloff : 1;
}

const project::Feature* first_selected(const Document& document) {
  const auto& selected = document.selection().features;
  return selected.empty() ? nullptr : &document.project().features[static_cast<std::size_t>(selected.front())];
}

Influence effective_of_first(const Document& document) {
  const project::Feature* feature = first_selected(document);
  return feature ? project::effective(document.project(), *feature) : project::effective(document.project());
}

bool within_limits(double value) {
  return std::abs(value) <= project::kMaxCoordinate;
}

/// Whether the project file takes it.
bool acceptable(const motion::Easing& easing) {
  if (motion::problem(easing)) return false;
  if (const auto* bezier = std::get_if<motion::CubicBezierEase>(&easing))
    return within_limits(bezier->y1) && within_limits(bezier->y2);
  if (const auto* keyed = std::get_if<motion::KeysEase>(&easing)) {
    const auto good = [](const motion::KeysEase::Key& key) {
      return within_limits(key.s) && within_limits(key.speed.value_or(0));
    };
    return keyed->keys.size() <= project::kMaxPoints && std::ranges::all_of(keyed->keys, good);
  }
  return true;
}

}  // namespace

double Document::tuning(Tuning which) const {
  return *value_of(effective_of_first(*this), which);
}

bool Document::tuning_is_own(Tuning which) const {
  const project::Feature* feature = first_selected(*this);
  return value_of(feature ? feature->influence : project().influence, which).has_value();
}

void Document::tune(Tuning which, double value) {
  if (std::isnan(value)) return;
  value = std::clamp(value, 0.0, most(which));
  if (selection().features.empty()) {
    change([&](Project& project) { value_of(project.influence, which) = value; });
  } else {
    change_selected([&](project::Feature& feature) { value_of(feature.influence, which) = value; });
  }
}

void Document::untune() {
  change_selected([](project::Feature& feature) {
    Influence& influence = feature.influence;
    influence.a = influence.b = influence.p = std::nullopt;
    influence.shape = influence.dissolve = std::nullopt;
  });
}

motion::Timing Document::timing(Progress which) const {
  return *timing_of(effective_of_first(*this), which);
}

void Document::set_easing(Progress which, const motion::Easing& easing) {
  if (!acceptable(easing)) return;
  const auto set = [&](Influence& influence, const Influence& effective) {
    motion::Timing timing = *timing_of(effective, which);
    timing.easing = easing;
    timing_of(influence, which) = timing;
  };
  change([&](Project& project) {
    if (selection().features.empty()) set(project.influence, project::effective(project));
    for (const int i : selection().features) {
      project::Feature& feature = project.features[static_cast<std::size_t>(i)];
      set(feature.influence, project::effective(project, feature));
    }
  });
}

}  // namespace morphkit::edit
