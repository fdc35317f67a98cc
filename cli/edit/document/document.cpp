#include "cli/edit/document/document.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "cli/edit/document/counterpart.h"
#include "cli/edit/document/groups.h"
#include "cli/edit/document/marks.h"
#include "morph/project/limits.h"

namespace morphkit::edit {
namespace {

using project::Feature;
using project::Project;

/// Rising, each once, below `count`.
std::vector<int> sorted_unique(std::vector<int> indices, std::size_t count) {
  std::erase_if(indices, [&](int i) { return i < 0 || static_cast<std::size_t>(i) >= count; });
  std::ranges::sort(indices);
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  return indices;
}

std::vector<int> first_numbers(std::size_t count) {
  std::vector<int> numbers(count);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = static_cast<int>(i);
  return numbers;
}

std::size_t vertex_count(const Project& project) {
  return project.mesh ? static_cast<std::size_t>(project.mesh->columns) * static_cast<std::size_t>(project.mesh->rows)
                      : 0;
}

/// A mesh does not support mirrored borders, and removing the last feature may switch the method to the mesh.
void drop_unsupported_border(Project& project) {
  const bool mirrors = project.warp.border == warp::Border::kMirror;
  if (mirrors && project::method_name_of(project) == project::MethodName::kMesh) project.warp.border.reset();
}

}  // namespace

Document::Document(Project project, cv::Size source, cv::Size destination)
    : source_(source), destination_(destination), state_{std::move(project), {}}, saved_(state_.project) {}

void Document::touch() {
  ++revision_;
  changed_.reset();
  moments_.reset();
}

const project::Evaluator& Document::moments() const {
  if (!moments_) moments_.emplace(project());
  return *moments_;
}

void Document::change(const std::function<void(Project&)>& edit) {
  State before = state_;
  edit(state_.project);
  drop_unsupported_border(state_.project);
  if (project::same_document(before.project, state_.project)) return;
  touch();
  if (!before_) history_.push(before);
}

void Document::change_selected(const std::function<void(Feature&)>& edit) {
  change([&](Project& project) {
    for (const int i : selection().features) edit(project.features[static_cast<std::size_t>(i)]);
  });
}

/// The file and spelling of a project are not part of an undo step.
void Document::take(State state) {
  state.project.file = saved_.file;
  state.project.original = saved_.original;
  state_ = std::move(state);
  touch();
}

void Document::begin() {
  if (!before_) before_ = state_;
}

void Document::end() {
  if (!before_) return;
  if (!project::same_document(before_->project, state_.project)) history_.push(*before_);
  before_.reset();
}

void Document::cancel() {
  if (before_) take(*std::exchange(before_, std::nullopt));
}

bool Document::undo() {
  if (in_step() || !can_undo()) return false;
  take(history_.undo(state_));
  return true;
}

bool Document::redo() {
  if (in_step() || !can_redo()) return false;
  take(history_.redo(state_));
  return true;
}

bool Document::changed() const {
  if (!changed_) changed_ = !project::same_document(state_.project, saved_);
  return *changed_;
}

void Document::mark_saved(const Project& project) {
  saved_ = project;
  state_.project.file = saved_.file;
  state_.project.original = saved_.original;
  changed_.reset();
}

void Document::replace(Project project) {
  project.file = saved_.file;
  project.original = saved_.original;
  change([&](Project& current) {
    if (project::same_document(current, project)) return;
    current = std::move(project);
    state_.selection = {};
  });
}

void Document::select(Selection selection) {
  state_.selection = {sorted_unique(std::move(selection.features), project().features.size()),
                      sorted_unique(std::move(selection.vertices), vertex_count(project()))};
}

void Document::select_all_features() {
  state_.selection = {first_numbers(project().features.size()), {}};
}

void Document::select_all_vertices() {
  state_.selection = {{}, first_numbers(vertex_count(project()))};
}

std::vector<cv::Point2d> Document::counterparts(SideIndex side, std::span<const cv::Point2d> positions) const {
  return edit::counterparts(project(), moments(), std::array{source_, destination_}, side, positions);
}

cv::Point2d Document::counterpart(SideIndex side, cv::Point2d position) const {
  return counterparts(side, {&position, 1}).front();
}

int Document::add(Feature feature) {
  if (!is_valid(feature) || project().features.size() >= project::kMaxFeatures) return -1;
  const int index = static_cast<int>(project().features.size());
  change([&](Project& project) {
    feature.id = free_id(project, feature.mark);
    project.features.push_back(std::move(feature));
    state_.selection = {{index}, {}};
  });
  return index;
}

/// The other end of a partner with both ends in one place, which happens when both were carried out of the picture: at
/// the same distance from `start` as on the drawn side, inside the picture if there is room.
cv::Point2d Document::partner_end(SideIndex side, cv::Point2d start, cv::Point2d from, cv::Point2d to) const {
  const cv::Size size = picture_size(other(side));
  const cv::Rect2d picture({0, 0}, cv::Size2d(size));
  const cv::Point2d arm = to - from;
  const cv::Point2d middle(size.width / 2.0, size.height / 2.0);
  const bool outwards = arm.dot(middle - start) < 0;
  const cv::Point2d end = clamped(outwards ? start - arm : start + arm);
  // A tiny line disappears by rounding; any length above 0 is good enough.
  return end != start ? end : start + cv::Point2d(start.x < middle.x ? 1 : -1, 0);
}

int Document::add_line(SideIndex side, cv::Point2d from, cv::Point2d to) {
  if (!finite(from) || !finite(to)) return -1;
  from = clamped(from);
  to = clamped(to);
  if (from == to) return -1;
  Feature feature;
  points_of(feature, side) = {from, to};
  const cv::Point2d start = counterpart(side, from);
  cv::Point2d end = counterpart(side, to);
  if (end == start) end = partner_end(side, start, from, to);
  points_of(feature, other(side)) = {start, end};
  return add(std::move(feature));
}

int Document::add_point(SideIndex side, cv::Point2d at) {
  if (!finite(at)) return -1;
  Feature feature;
  feature.mark = project::Point{};
  points_of(feature, side) = {clamped(at)};
  points_of(feature, other(side)) = {counterpart(side, clamped(at))};
  return add(std::move(feature));
}

int Document::add_curve(SideIndex side, const std::vector<cv::Point2d>& points, bool closed) {
  if (!std::ranges::all_of(points, finite)) return -1;
  Feature feature;
  const project::Curve curve{.closed = closed};
  feature.mark = curve;
  Points& here = points_of(feature, side);
  for (const cv::Point2d& point : points) here.push_back(clamped(point));
  if (here.size() > project::kMaxPoints || motion::Curve::problem(curve.kind, here, closed)) return -1;
  Points& there = points_of(feature, other(side));
  there = counterparts(side, here);
  if (!is_valid(feature)) {
    // Carried out of the picture and back to its border, the partner has lost its shape: it gets the one drawn.
    const cv::Point2d by = there.front() - here.front();
    for (std::size_t i = 0; i < here.size(); ++i) there[i] = clamped(here[i] + by);
  }
  return add(std::move(feature));
}

bool Document::move_point(int feature, SideIndex side, int point, cv::Point2d to) {
  if (feature < 0 || static_cast<std::size_t>(feature) >= project().features.size() || point < 0) return false;
  bool done = false;
  change([&](Project& project) {
    Feature& moved = project.features[static_cast<std::size_t>(feature)];
    done = edit::move_point(moved, side, static_cast<std::size_t>(point), to);
  });
  return done;
}

void Document::move_selected(SideIndex side, cv::Point2d by) {
  const bool alone = !in_step();
  begin();
  change_selected([&](Feature& feature) { move_all(feature, side, by); });
  move_vertices(selection().vertices, side, by);
  if (alone) end();
}

void Document::erase_selected() {
  change([&](Project& project) {
    std::vector<bool> goes(project.features.size(), false);
    std::set<std::string> left;
    for (const int i : selection().features) {
      goes[static_cast<std::size_t>(i)] = true;
      left.insert(project.features[static_cast<std::size_t>(i)].group);
    }
    std::size_t i = 0;
    std::erase_if(project.features, [&](const Feature&) { return goes[i++]; });
    remove_unused_groups(project, left);
    state_.selection.features.clear();
  });
}

void Document::duplicate_selected(cv::Point2d by) {
  const std::vector<int> originals = selection().features;
  if (originals.empty() || !finite(by) || project().features.size() + originals.size() > project::kMaxFeatures) return;
  change([&](Project& project) {
    Selection copies;
    for (const int i : originals) {
      Feature copy = project.features[static_cast<std::size_t>(i)];
      copy.id = free_id(project, copy.mark);
      for (SideIndex side = 0; side < copy.places.size(); ++side) move_all(copy, side, by);
      copies.features.push_back(static_cast<int>(project.features.size()));
      project.features.push_back(std::move(copy));
    }
    state_.selection = std::move(copies);
  });
}

void Document::swap_ends_selected() {
  change_selected([](Feature& feature) {
    if (is_closed(feature.mark)) return;
    for (SideIndex side = 0; side < feature.places.size(); ++side) reverse(feature, side);
  });
}

void Document::swap_ends_on(SideIndex side) {
  change_selected([&](Feature& feature) { reverse(feature, side); });
}

std::optional<std::string> Document::rename(int feature, const std::string& id) {
  if (feature < 0 || static_cast<std::size_t>(feature) >= project().features.size()) return "there is no such feature";
  if (std::string problem = problem_of_name(id); !problem.empty()) return problem;
  const auto index = static_cast<std::size_t>(feature);
  if (project().features[index].id == id) return std::nullopt;
  const bool taken = std::ranges::find(project().features, id, &Feature::id) != project().features.end();
  if (taken) return "another feature has that name";
  change([&](Project& project) { project.features[index].id = id; });
  return std::nullopt;
}

std::optional<std::string> Document::group_selected(const std::string& group) {
  if (selection().features.empty()) return std::nullopt;
  if (!group.empty()) {
    if (std::string problem = problem_of_name(group); !problem.empty()) return problem;
  }
  change([&](Project& project) {
    std::set<std::string> left;
    for (const int i : selection().features) {
      Feature& feature = project.features[static_cast<std::size_t>(i)];
      if (feature.group != group) left.insert(std::exchange(feature.group, group));
    }
    add_group(project, group);
    remove_unused_groups(project, left);
  });
  return std::nullopt;
}

}  // namespace morphkit::edit
