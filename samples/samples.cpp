#include "samples/samples.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "samples/pictures.h"
#include "samples/projects.h"

namespace morphkit::samples {
namespace {

struct Recipe {
  const char* name;
  const char* title;
  struct {
    const char* name;
    Canvas (*paint)();
  } source, destination;
  const char* project;
};

const std::array kRecipes{
    Recipe{"portraits",
           "A woman becomes a man: curves, groups and timing",
           {"woman.png", paint_woman},
           {"man.png", paint_man},
           kPortraitsProject},
    Recipe{"objects",
           "A pear becomes a light bulb: transparency",
           {"pear.png", paint_pear},
           {"bulb.png", paint_bulb},
           kObjectsProject},
    Recipe{"scenes",
           "A lake at noon becomes a desert at night: pictures of different size",
           {"lake.png", paint_lake},
           {"desert.png", paint_desert},
           kScenesProject},
    Recipe{"mesh",
           "The woman becomes the man by a mesh instead of lines",
           {"woman.png", paint_woman},
           {"man.png", paint_man},
           kMeshProject},
};

}  // namespace

Sample paint(const std::string& name) {
  const auto* const recipe =
      std::find_if(kRecipes.begin(), kRecipes.end(), [&](const Recipe& r) { return r.name == name; });
  if (recipe == kRecipes.end()) throw std::invalid_argument("there is no sample \"" + name + "\"");
  return {recipe->name,
          recipe->title,
          {{recipe->source.name, recipe->source.paint().to_8bit()},
           {recipe->destination.name, recipe->destination.paint().to_8bit()}},
          recipe->project};
}

}  // namespace morphkit::samples
