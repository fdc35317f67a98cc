#include "cli/file_info.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "morph/media/image_file.h"

namespace morphkit::cli {
namespace {

struct ChannelStatistics {
  double minimum = std::numeric_limits<double>::infinity();
  double maximum = -std::numeric_limits<double>::infinity();
  double mean = 0;
};

std::array<ChannelStatistics, 4> statistics(const warp::Image& image) {
  std::array<ChannelStatistics, 4> result;
  for (const warp::Pixel& pixel : image) {
    for (int c = 0; c < 4; ++c) {
      ChannelStatistics& channel = result[static_cast<std::size_t>(c)];
      const auto value = static_cast<double>(pixel[c]);
      channel.minimum = std::min(channel.minimum, value);
      channel.maximum = std::max(channel.maximum, value);
      channel.mean += value;
    }
  }
  for (ChannelStatistics& channel : result) channel.mean /= static_cast<double>(image.total());
  return result;
}

void add_pixels(const media::Picture& picture, FileInfo& info) {
  constexpr std::array<const char*, 4> kNames = {"R", "G", "B", "A"};
  Report pixels;
  info.text += "  pixels       linear light, premultiplied:    minimum     maximum        mean\n";
  const auto channels = statistics(picture.image);
  for (std::size_t c = 0; c < kNames.size(); ++c) {
    info.text += fmt::format("  {:>39} {:>12.6g} {:>11.6g} {:>11.6g}\n", kNames[c], channels[c].minimum,
                             channels[c].maximum, channels[c].mean);
    Report channel;
    channel.set("minimum", channels[c].minimum).set("maximum", channels[c].maximum).set("mean", channels[c].mean);
    pixels.set(kNames[c], channel);
  }
  info.text += fmt::format("  not finite   {} pixels{}\n", picture.nonfinite_pixels,
                           picture.nonfinite_pixels > 0 ? " (NaN or infinity; rendered as transparent)" : "");
  Report warnings = Report::array();
  for (const std::string& sentence : media::warnings_of(picture)) {
    info.text += "  warning      " + sentence + "\n";
    warnings.push(sentence);
  }
  info.report.set("pixels", pixels).set("nonfinite_pixels", picture.nonfinite_pixels).set("warnings", warnings);
}

}  // namespace

FileInfo picture_info(const std::filesystem::path& file, bool pixels) {
  const media::ImageInfo image = media::read_info(file);
  FileInfo info;
  info.text = fmt::format("{}: {}, {}x{}, {} channels of {}{}\n", file.string(), image.format, image.width,
                          image.height, image.channels, image.channel_type, image.has_alpha ? ", with alpha" : "");
  info.text += fmt::format("  colour       {}\n", image.color_told);
  if (image.orientation != 1) {
    info.text += fmt::format("  orientation  EXIF {}: turned upright on reading\n", image.orientation);
  }
  info.text += fmt::format("  file size    {} bytes\n", image.bytes);
  info.report.set("file", file.string()).set("kind", "picture").set("format", image.format);
  info.report.set("width", image.width).set("height", image.height).set("channels", image.channels);
  info.report.set("channel_type", image.channel_type).set("alpha", image.has_alpha);
  info.report.set("color_space", image.color_space)
      .set("color", image.color_told)
      .set("orientation", image.orientation);
  info.report.set("bytes", image.bytes);
  if (pixels) add_pixels(media::read_picture(file), info);
  Report metadata;
  for (const auto& [key, value] : image.metadata) {
    info.text += fmt::format("  {}: {}\n", key, value);
    metadata.set(key, value);
  }
  info.report.set("metadata", metadata);
  return info;
}

}  // namespace morphkit::cli
