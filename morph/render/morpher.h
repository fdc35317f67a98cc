#pragma once
// What turns one placed picture into the other. One implementation per method.

#include <cstddef>
#include <memory>
#include <string>

#include "morph/project/project.h"
#include "morph/render/stage.h"
#include "warp/image/image.h"

namespace morphkit::render {

/// The moments at which a morph is looked at before it is rendered.
inline constexpr double kMoments[] = {0, 0.25, 0.5, 0.75, 1};

/// Immutable: any number of threads may use one at once. The project and the stage outlive it.
class Morpher {
 public:
  virtual ~Morpher() = default;
  Morpher(const Morpher&) = delete;
  Morpher& operator=(const Morpher&) = delete;

  /// @throws Error kBadInput if the moment t cannot be rendered, naming what is in the way.
  virtual void require(double t) const = 0;

  /// Both pictures warped to the moment t in [0, 1] and mixed, without the background; parallel inside.
  /// @throws Error as `require`.
  virtual warp::Image frame(double t) const = 0;

  /// Whether anything of that side's picture is in the frame at t.
  virtual bool shows(SideIndex side, double t) const = 0;

  /// Source positions for every canvas pixel at t, px of that side's image file. Folds of lines show as they are;
  /// what is out of order in a mesh is squashed, as in the frame.
  virtual warp::Map map(double t, SideIndex side) const = 0;

  /// Memory that `frame` takes beside its result and a few rows for every thread.
  virtual std::size_t scratch_bytes() const = 0;

  /// What does the work, in a few words for --verbose.
  virtual std::string description() const = 0;

 protected:
  Morpher() = default;
};

/// The morpher of project::method_name_of(project).
/// @param allow_folds  render meshes that fold as far as that goes.
/// @throws Error kBadInput if the project's mesh does not fit its pictures, or folds and must not.
std::unique_ptr<Morpher> make_morpher(const project::Project& project, const Stage& stage, bool allow_folds);

}  // namespace morphkit::render
