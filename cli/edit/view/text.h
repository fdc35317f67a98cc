#pragma once
// Draws text. The only file that uses FreeType.

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <opencv2/core.hpp>

namespace cv::freetype {
class FreeType2;
}

namespace morphkit::edit {

/// Draws lines of text. Caches rendered lines.
class Type {
 public:
  /// Looks for DejaVu Sans. Without it, OpenCV's stroke font is used, which has ASCII only.
  Type();

  /// @param text  UTF-8, one line. @param height  of the type, px.
  int width(std::string_view text, int height) const;

  /// @param left_baseline  start of the line, px; the text is cut at the borders of the picture.
  void draw(cv::Mat3b& picture, std::string_view text, cv::Point left_baseline, int height,
            const cv::Vec3b& color) const;

  /// The text, shortened to `room` px with an ellipsis if it is longer.
  std::string fitted(std::string_view text, int height, int room) const;

 private:
  /// Coverage of a line, with its baseline.
  struct Line {
    cv::Mat1b mask;
    int baseline = 0;  ///< row of the mask
    int advance = 0;   ///< px
  };
  const Line& line(std::string_view text, int height) const;
  Line rendered(const std::string& text, int height) const;

  cv::Ptr<cv::freetype::FreeType2> font_;
  mutable std::map<std::pair<std::string, int>, Line> lines_;
};

}  // namespace morphkit::edit
