#include "morph/render/finding.h"

#include <array>
#include <cstddef>

namespace morphkit::render {

const char* name_of(Finding::Kind kind) {
  constexpr std::array kNames{"crossing", "twins",     "outside-image", "outside-canvas",
                              "fold",     "mesh-fold", "bottleneck"};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace morphkit::render
