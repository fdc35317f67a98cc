// The numbers and timings of a document.

#include <algorithm>
#include <cmath>

#include "cli/edit/document.h"
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

/// Whether the project file takes it. As there, a sum of 1 in decimals may exceed it by a rounding error in binary.
bool acceptable(const motion::Timing& timing) {
  if (motion::problem(timing.easing)) return false;
  if (const auto* bezier = std::get_if<motion::CubicBezierEase>(&timing.easing);
      bezier && !(within_limits(bezier->y1) && within_limits(bezier->y2)))
    return false;
  if (const auto* keyed = std::get_if<motion::KeysEase>(&timing.easing)) {
    const auto good = [](const motion::KeysEase::Key& key) {
      return within_limits(key.s) && within_limits(key.speed.value_or(0));
    };
    if (keyed->keys.size() > project::kMaxPoints || !std::ranges::all_of(keyed->keys, good)) return false;
  }
  const bool in_unit = timing.delay >= 0 && timing.delay <= 1 && timing.duration >= 0 && timing.duration <= 1;
  constexpr double kRounding = 1e-9;
  return in_unit && timing.delay + timing.duration <= 1 + kRounding;
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
  change_selected([](project::Feature& feature) { feature.influence = {}; });
}

motion::Timing Document::timing(Progress which) const {
  const Influence influence = effective_of_first(*this);
  return which == Progress::kShape ? *influence.shape : *influence.dissolve;
}

void Document::set_timing(Progress which, const motion::Timing& timing) {
  if (!acceptable(timing)) return;
  const auto set = [&](Influence& influence) {
    (which == Progress::kShape ? influence.shape : influence.dissolve) = timing;
  };
  if (selection().features.empty()) {
    change([&](Project& project) { set(project.influence); });
  } else {
    change_selected([&](project::Feature& feature) { set(feature.influence); });
  }
}

}  // namespace morphkit::edit
