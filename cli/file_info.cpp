#include "cli/file_info.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/error.h"
#include "morph/media/image_file.h"
#include "morph/project/project.h"

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
  info.report.set("pixels", pixels).set("nonfinite_pixels", picture.nonfinite_pixels);
}

/// The size of a picture that a project names, or why it has none.
void add_side(const char* label, const project::Project& project, const project::Picture& side, FileInfo& info) {
  Report report;
  report.set("image", side.image.string());
  std::string what;
  try {
    const media::ImageInfo image = media::read_info(project::resolve(project, side.image));
    what = fmt::format("{}x{}", image.width, image.height);
    report.set("width", image.width).set("height", image.height);
  } catch (const Error& error) {
    what = fmt::format("cannot be read: {}", error.message());
    report.set("error", error.message());
  }
  info.text += fmt::format("  {:<12} {}, {}\n", label, side.image.string(), what);
  info.report.set(label, report);
}

std::string fps_text(const project::Output& output) {
  return output.fps.den == 1 ? fmt::format("{}", output.fps.num) : fmt::format("{}/{}", output.fps.num, output.fps.den);
}

const char* fit_name(project::Fit fit) {
  switch (fit) {
    case project::Fit::kContain:
      return "contain";
    case project::Fit::kCover:
      return "cover";
    case project::Fit::kStretch:
      return "stretch";
    case project::Fit::kNone:
      return "none";
  }
  return "";
}

void add_features(const project::Project& project, FileInfo& info) {
  const auto count = [&]<typename Kind>(Kind) {
    return std::count_if(project.features.begin(), project.features.end(),
                         [](const project::Feature& feature) { return std::holds_alternative<Kind>(feature.mark); });
  };
  const auto lines = count(project::Line{});
  const auto points = count(project::Point{});
  const auto curves = count(project::Curve{});
  info.text += fmt::format("  features     {}: {} lines, {} points, {} curves\n", project.features.size(), lines,
                           points, curves);
  Report features;
  features.set("total", project.features.size()).set("lines", lines).set("points", points).set("curves", curves);
  info.report.set("features", features);

  if (project.mesh) {
    info.text += fmt::format("  mesh         {} x {} vertices\n", project.mesh->columns, project.mesh->rows);
    info.report.set("mesh", Report().set("columns", project.mesh->columns).set("rows", project.mesh->rows));
  }
  const bool by_mesh = project::method_name_of(project) == project::MethodName::kMesh;
  info.text += fmt::format("  method       {}\n", by_mesh ? "mesh" : "lines");
  info.report.set("method", by_mesh ? "mesh" : "lines");

  Report groups = Report::array();
  std::string names;
  for (const project::Group& group : project.groups) {
    groups.push(group.id);
    names += (names.empty() ? "" : ", ") + group.id;
  }
  if (!names.empty()) info.text += fmt::format("  groups       {}\n", names);
  info.report.set("groups", groups);
}

void add_output(const project::Output& output, FileInfo& info) {
  const std::string size =
      output.size ? fmt::format("{}x{}", output.size->width, output.size->height) : "the size of the source";
  const double duration_s = static_cast<double>(output.frames) * output.fps.den / output.fps.num;
  info.text += fmt::format("  output       {}, {}; frames {}-{} at {} fps ({:.2f} s)\n", size, fit_name(output.fit),
                           output.start, output.start + output.frames - 1, fps_text(output), duration_s);
  Report report;
  if (output.size) report.set("width", output.size->width).set("height", output.size->height);
  report.set("fit", fit_name(output.fit)).set("frames", output.frames).set("start", output.start);
  report.set("fps", fps_text(output));
  info.report.set("output", report);
}

}  // namespace

FileInfo picture_info(const std::filesystem::path& file, bool pixels) {
  const media::ImageInfo image = media::read_info(file);
  FileInfo info;
  info.text = fmt::format("{}: {}, {}x{}, {} channels of {}{}\n", file.string(), image.format, image.width,
                          image.height, image.channels, image.channel_type, image.has_alpha ? ", with alpha" : "");
  info.text += fmt::format("  colour       read as {}\n", image.color_space);
  if (image.orientation != 1) {
    info.text += fmt::format("  orientation  EXIF {}: turned upright on reading\n", image.orientation);
  }
  info.text += fmt::format("  file size    {} bytes\n", image.bytes);
  info.report.set("file", file.string()).set("kind", "picture").set("format", image.format);
  info.report.set("width", image.width).set("height", image.height).set("channels", image.channels);
  info.report.set("channel_type", image.channel_type).set("alpha", image.has_alpha);
  info.report.set("color_space", image.color_space).set("orientation", image.orientation);
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

FileInfo project_info(const std::filesystem::path& file) {
  const project::Project project = project::load(file);
  FileInfo info;
  info.text = fmt::format("{}: morphkit project\n", file.string());
  info.report.set("file", file.string()).set("kind", "project");
  add_side("source", project, project.pictures[project::kSource], info);
  add_side("destination", project, project.pictures[project::kDestination], info);
  add_features(project, info);
  add_output(project.output, info);
  return info;
}

}  // namespace morphkit::cli
