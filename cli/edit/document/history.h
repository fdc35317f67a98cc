#pragma once
// Undo and redo without limit. States share equal parts, so a step costs only its changes.

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

/// The size of a history.
struct HistorySize {
  std::size_t states = 0;
  std::size_t parts = 0;  ///< objects in all states; shared objects count once
};

class History {
 public:
  /// Stores `state` for a later `undo` and forgets all redo states. The project's `file` and `original` are not stored:
  /// they are not part of a state.
  void push(const State& state);

  bool can_undo() const noexcept { return !past_.empty(); }
  bool can_redo() const noexcept { return !future_.empty(); }

  /// @param now  goes to the other side. @pre can_undo() / can_redo().
  State undo(const State& now);
  State redo(const State& now);

  /// Cost: all states times their features; for tests and figures.
  HistorySize size() const;

 private:
  /// A state in parts: parts equal to those of its neighbour are the same objects.
  struct Stored;
  using Side = std::vector<std::shared_ptr<const Stored>>;
  static std::shared_ptr<const Stored> store(const State& state, const Stored* neighbour);
  static State restore(const Stored& stored);
  const Stored* nearest() const;
  State step(const State& now, Side& from, Side& to);

  Side past_, future_;
  std::shared_ptr<const Stored> restored_;  ///< the result of the last undo or redo, until the next push
};

}  // namespace morphkit::edit
