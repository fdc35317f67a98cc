#pragma once
// The sample pairs: pictures painted by our own code and hand-made projects. All are in the binary, so `morphkit demo`
// needs no other files.

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace morphkit::samples {

/// An 8-bit, display-referred sRGB, unpremultiplied picture: CV_8UC4, RGBA order.
struct PaintedPicture {
  std::string name;  ///< file name, "day.png"
  cv::Mat4b pixels;
};

struct Sample {
  std::string name;  ///< as in Title
  std::string title;
  std::vector<PaintedPicture> pictures;  ///< source, destination
  std::string project;                   ///< text of the project file, which lies beside the pictures as <name>.json
};

/// What a sample is called and what it shows, in one line for people.
struct Title {
  std::string name;
  std::string title;
};

/// Of all samples, without painting any. The first is the demo's default.
std::vector<Title> titles();
std::vector<std::string> names();

/// Paints one sample; the same bytes every time. @throws std::invalid_argument for an unknown name.
Sample paint(const std::string& name);

}  // namespace morphkit::samples
