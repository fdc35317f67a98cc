#pragma once
// Undo and redo without limit. States share what they have in common, so that a step costs what it changed.

#include <cstddef>
#include <memory>
#include <vector>

#include "morph/project/project.h"

namespace morphkit::edit {

struct Selection {
  std::vector<int> features;  ///< indices, rising
  std::vector<int> vertices;  ///< of the mesh, rising
  bool empty() const noexcept { return features.empty() && vertices.empty(); }
  bool operator==(const Selection&) const = default;
};

struct State {
  project::Project project;
  Selection selection;
};

/// What a history holds.
struct HistorySize {
  std::size_t states = 0;
  std::size_t parts = 0;  ///< objects that the states are made of, each counted once however many states share it
};

class History {
 public:
  /// Remembers `state` as what a coming `undo` returns to; what could be redone is forgotten. The project's `file` and
  /// `original` are not remembered: where it is saved is no state of it.
  void push(const State& state);

  bool can_undo() const noexcept { return !past_.empty(); }
  bool can_redo() const noexcept { return !future_.empty(); }

  /// @param now  goes to the other side. @pre can_undo() / can_redo().
  State undo(const State& now);
  State redo(const State& now);

  /// Cost: all states times their features; for tests and figures.
  HistorySize size() const;

 private:
  /// A state taken apart: parts that are equal to those of its neighbour are the same objects.
  struct Stored;
  using Side = std::vector<std::shared_ptr<const Stored>>;
  static std::shared_ptr<const Stored> store(const State& state, const Stored* neighbour);
  static State restore(const Stored& stored);
  const Stored* nearest() const;
  State step(const State& now, Side& from, Side& to);

  Side past_, future_;
  std::shared_ptr<const Stored> restored_;  ///< what the last undo or redo gave, until the next push
};

}  // namespace morphkit::edit
