#include "cli/edit/view/text.h"

#include <algorithm>
#include <filesystem>

#include <opencv2/freetype.hpp>
#include <opencv2/imgproc.hpp>

namespace morphkit::edit {
namespace {

constexpr const char* kFonts[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                  "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                                  "/usr/share/fonts/TTF/DejaVuSans.ttf"};
constexpr std::size_t kMaxLines = 4096;    ///< kept; then all are forgotten
constexpr double kStrokeScale = 1 / 30.0;  ///< of OpenCV's strokes, per px of height

/// The beginning of the last character in `text` before `end`: only whole characters may be cut off.
std::size_t previous_character(std::string_view text, std::size_t end) {
  while (end > 0 && (static_cast<unsigned char>(text[end - 1]) & 0xC0) == 0x80) --end;
  return end > 0 ? end - 1 : 0;
}

}  // namespace

Type::Type() {
  for (const char* file : kFonts) {
    if (!std::filesystem::exists(file)) continue;
    font_ = cv::freetype::createFreeType2();
    font_->loadFontData(file, 0);
    return;
  }
}

Type::Line Type::rendered(const std::string& text, int height) const {
  int below = 0;
  const cv::Size size = font_ ? font_->getTextSize(text, height, -1, &below)
                              : cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, height * kStrokeScale, 1, &below);
  Line line;
  line.advance = size.width;
  line.baseline = height + 2;
  // Wide enough for glyphs that extend beyond their advance.
  cv::Mat3b drawn(line.baseline + height, size.width + height, cv::Vec3b(0, 0, 0));
  const cv::Point start(2, line.baseline);
  if (font_) {
    font_->putText(drawn, text, start, height, cv::Scalar::all(255), -1, cv::LINE_AA, true);
  } else {
    cv::putText(drawn, text, start, cv::FONT_HERSHEY_SIMPLEX, height * kStrokeScale, cv::Scalar::all(255), 1,
                cv::LINE_AA);
  }
  cv::extractChannel(drawn, line.mask, 0);
  return line;
}

const Type::Line& Type::line(std::string_view text, int height) const {
  const std::pair key(std::string(text), height);
  const auto found = lines_.find(key);
  if (found != lines_.end()) return found->second;
  if (lines_.size() >= kMaxLines) lines_.clear();
  return lines_.emplace(key, rendered(key.first, height)).first->second;
}

int Type::width(std::string_view text, int height) const {
  return text.empty() ? 0 : line(text, height).advance;
}

void Type::draw(cv::Mat3b& picture, std::string_view text, cv::Point left_baseline, int height,
                const cv::Vec3b& color) const {
  if (text.empty()) return;
  const Line& drawn = line(text, height);
  const cv::Point origin = left_baseline - cv::Point(2, drawn.baseline);
  const cv::Rect target = cv::Rect(origin, drawn.mask.size()) & cv::Rect({0, 0}, picture.size());
  for (int y = target.y; y < target.br().y; ++y)
    for (int x = target.x; x < target.br().x; ++x) {
      const int cover = drawn.mask(y - origin.y, x - origin.x);
      if (cover == 0) continue;
      cv::Vec3b& pixel = picture(y, x);
      for (int c = 0; c < 3; ++c)
        pixel[c] = static_cast<uchar>((pixel[c] * (255 - cover) + color[c] * cover + 127) / 255);
    }
}

std::string Type::fitted(std::string_view text, int height, int room) const {
  if (width(text, height) <= room) return std::string(text);
  const std::string_view ellipsis = "\u2026";
  std::size_t end = text.size();
  std::string cut;
  do {
    end = previous_character(text, end);
    cut = std::string(text.substr(0, end)).append(ellipsis);
  } while (end > 0 && width(cut, height) > room);
  return cut;
}

}  // namespace morphkit::edit
