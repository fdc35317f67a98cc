#pragma once
// The sample pairs: pictures painted by our own program and hand-made projects, all inside the binary, so that
// `morphkit demo` needs no other file.

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace morphkit::samples {

/// An 8-bit, display-referred sRGB, straight-alpha picture: CV_8UC4, RGBA order.
struct PaintedPicture {
  std::string name;  ///< file name, "day.png"
  cv::Mat4b pixels;
};

struct Sample {
  std::string name;                      ///< "faces"
  std::string title;                     ///< one line for people
  std::vector<PaintedPicture> pictures;  ///< source, destination
  std::string project;                   ///< text of the project file, to lie beside the pictures as <name>.json
};

/// Names of all samples, the first is the demo's default.
std::vector<std::string> names();

/// Paints one sample; the same bytes every time. @throws std::invalid_argument for an unknown name.
Sample paint(const std::string& name);

}  // namespace morphkit::samples
