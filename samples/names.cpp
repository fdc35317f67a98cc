#include "samples/samples.h"

namespace morphkit::samples {

// A library of its own: a program that only says the names does not link what paints them.
std::vector<std::string> names() {
  return {"portraits", "objects", "scenes", "mesh"};
}

}  // namespace morphkit::samples
