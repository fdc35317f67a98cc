// Paints all samples into a folder: morphkit_paint DIR. `morphkit demo` does the same and renders them.

#include <cstdio>
#include <exception>
#include <filesystem>

#include "samples/write.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s DIR\n", argv[0]);
    return 2;
  }
  try {
    for (const std::string& name : morphkit::samples::names())
      std::printf("%s\n", morphkit::samples::write(morphkit::samples::paint(name), argv[1], true).c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
