#pragma once
// Type on pictures. The only file that knows FreeType.

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <opencv2/core.hpp>

namespace cv::freetype {
class FreeType2;
}

namespace morphkit::edit {

/// Draws lines of text, and remembers how they look.
class Type {
 public:
  /// Looks for DejaVu Sans. Without it, what is drawn comes from OpenCV's own strokes, which know ASCII alone.
  Type();

  /// @param text  UTF-8, one line. @param height  of the type, px.
  int width(std::string_view text, int height) const;

  /// @param left_baseline  where the line begins, px; what does not fit on the picture is cut.
  void draw(cv::Mat3b& picture, std::string_view text, cv::Point left_baseline, int height,
            const cv::Vec3b& color) const;

  /// As much of the text as fits into `room` px, with an ellipsis if that is not all.
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
