#include "samples/samples.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "samples/pictures.h"
#include "samples/projects.h"

namespace morphkit::samples {
namespace {

struct Recipe {
  struct {
    const char* name;
    Canvas (*paint)();
  } source, destination;
  const char* project;
};

/// In the order of `titles`.
const std::array kRecipes{
    Recipe{{"woman.png", paint_woman}, {"man.png", paint_man}, kPortraitsProject},
    Recipe{{"pear.png", paint_pear}, {"bulb.png", paint_bulb}, kObjectsProject},
    Recipe{{"lake.png", paint_lake}, {"desert.png", paint_desert}, kScenesProject},
    Recipe{{"woman.png", paint_woman}, {"man.png", paint_man}, kMeshProject},
};

}  // namespace

Sample paint(const std::string& name) {
  const std::vector<Title> all = titles();
  const auto found = std::ranges::find(all, name, &Title::name);
  if (found == all.end()) throw std::invalid_argument("there is no sample \"" + name + "\"");
  const Recipe& recipe = kRecipes.at(static_cast<std::size_t>(found - all.begin()));
  return {name,
          found->title,
          {{recipe.source.name, recipe.source.paint().to_8bit()},
           {recipe.destination.name, recipe.destination.paint().to_8bit()}},
          recipe.project};
}

}  // namespace morphkit::samples
