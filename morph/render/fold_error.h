#pragma once
// A mesh that folds, where that cannot be rendered.

#include <string>
#include <utility>

#include "base/error.h"

namespace morphkit::render {

/// Of the kind kBadInput. With RendererOptions::allow_folds the rest of the mesh can be rendered.
class FoldError : public Error {
 public:
  FoldError(std::string place, std::string message)
      : Error(ErrorKind::kBadInput, std::move(place), std::move(message)) {}
};

}  // namespace morphkit::render
