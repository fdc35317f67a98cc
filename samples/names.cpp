#include "samples/samples.h"

namespace morphkit::samples {

// A library of its own: a program that only says the names does not link what paints them.
std::vector<Title> titles() {
  return {{"portraits", "A woman becomes a man: curves, groups and timing"},
          {"objects", "A pear becomes a light bulb: transparency"},
          {"scenes", "A lake at noon becomes a desert at night: pictures of different size"},
          {"mesh", "The woman becomes the man by a mesh instead of lines"}};
}

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const Title& sample : titles()) names.push_back(sample.name);
  return names;
}

}  // namespace morphkit::samples
