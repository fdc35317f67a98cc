// The numbers and timings of a document.

#include <algorithm>
#include <cmath>

#include "cli/edit/document/document.h"
#include "morph/project/limits.h"

namespace morphkit::edit {
namespace {

using project::Pace;
using project::Project;
using project::Pull;

std::optional<double>& value_of(Pull& pull, Tuning which) {
  return which == Tuning::kA ? pull.a : which == Tuning::kB ? pull.b : pull.p;
}

const std::optional<double>& value_of(const Pull& pull, Tuning which) {
  return which == Tuning::kA ? pull.a : which == Tuning::kB ? pull.b : pull.p;
}

std::optional<motion::Timing>& timing_of(Pace& pace, TimingKind which) {
  return which == TimingKind::kShape ? pace.shape : pace.dissolve;
}

const std::optional<motion::Timing>& timing_of(const Pace& pace, TimingKind which) {
  return which == TimingKind::kShape ? pace.shape : pace.dissolve;
}

double most(Tuning which) {
  return which == Tuning::kA ? project::kMaxCoordinate : which == Tuning::kB ? project::kMaxFalloff : 1;
}

const project::Feature* first_selected(const Document& document) {
  const auto& selected = document.selection().features;
  return selected.empty() ? nullptr : &document.project().features[static_cast<std::size_t>(selected.front())];
}

Pull pull_of_first(const Document& document) {
  const project::Feature* feature = first_selected(document);
  return feature ? project::effective_pull(document.project(), *feature) : project::effective_pull(document.project());
}

Pace pace_of_first(const Document& document) {
  const project::Feature* feature = first_selected(document);
  return feature ? project::effective_pace(document.project(), *feature) : project::effective_pace(document.project());
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
  return *value_of(pull_of_first(*this), which);
}

bool Document::tuning_is_own(Tuning which) const {
  const project::Feature* feature = first_selected(*this);
  return value_of(feature ? feature->pull : project().pull, which).has_value();
}

void Document::tune(Tuning which, double value) {
  if (std::isnan(value)) return;
  value = std::clamp(value, 0.0, most(which));
  if (selection().features.empty()) {
    change([&](Project& project) { value_of(project.pull, which) = value; });
  } else {
    change_selected([&](project::Feature& feature) { value_of(feature.pull, which) = value; });
  }
}

void Document::reset_tuning() {
  change_selected([](project::Feature& feature) {
    feature.pull.a = feature.pull.b = feature.pull.p = std::nullopt;
    feature.pace = {};
  });
}

motion::Timing Document::timing(TimingKind which) const {
  return *timing_of(pace_of_first(*this), which);
}

void Document::set_easing(TimingKind which, const motion::Easing& easing) {
  if (!acceptable(easing)) return;
  const auto set = [&](Pace& pace, const Pace& effective) {
    motion::Timing timing = *timing_of(effective, which);
    timing.easing = easing;
    timing_of(pace, which) = timing;
  };
  change([&](Project& project) {
    if (selection().features.empty()) set(project.pace, project::effective_pace(project));
    for (const int i : selection().features) {
      project::Feature& feature = project.features[static_cast<std::size_t>(i)];
      set(feature.pace, project::effective_pace(project, feature));
    }
  });
}

}  // namespace morphkit::edit
