#include "morph/media/video_format.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/words.h"

namespace morphkit::media {
namespace {

// GIF counts hundredths of a second, and players treat a delay below 2 as "unspecified" and show 10 frames a second.
constexpr int kGifMaxFps = 50;

constexpr std::array<VideoFormat, 6> kFormats = {{
    {".mp4", "mp4", RawFormat::kYuv420p, RawFormat::kYuv420p, true, 18, 51, 0},
    {".webm", "webm", RawFormat::kYuv420p, RawFormat::kYuva420p, false, 24, 63, 0},
    {".mkv", "matroska", RawFormat::kRgb48, RawFormat::kRgba64, false, -1, 0, 0},
    {".mov", "mov", RawFormat::kYuv422p10, RawFormat::kYuva444p10, false, -1, 0, 0},
    {".gif", "gif", RawFormat::kRgb24, RawFormat::kRgba, false, -1, 0, kGifMaxFps},
    {".apng", "apng", RawFormat::kRgb24, RawFormat::kRgba, false, -1, 0, 0},
}};

using Arguments = std::vector<std::string>;

void append(Arguments& arguments, std::initializer_list<std::string_view> more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
}

// Colour tags for the encoder and the file: BT.709 primaries and the sRGB curve, which the codes really have
// (warp/image/color.h). A tag for BT.709's curve would be wrong: players that manage colour (mpv, macOS) would show the
// video darker than the same frame as PNG. Other players ignore both tags.
// The filter tags the frames, which some encoders read; the options tag the encoder's context and the container.
constexpr std::string_view kYuvTags =
    "setparams=range=tv:color_primaries=bt709:color_trc=iec61966-2-1:colorspace=bt709";
constexpr std::string_view kRgbTags = "setparams=range=pc:color_primaries=bt709:color_trc=iec61966-2-1:colorspace=gbr";

void append_tags(Arguments& arguments, bool yuv) {
  append(arguments, {"-vf", yuv ? kYuvTags : kRgbTags, "-color_range", yuv ? "tv" : "pc", "-colorspace",
                     yuv ? "bt709" : "rgb", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1"});
}

// Presets, by their speed; the first is the default. Figures: 48 frames of a 1080p morph of photographs at the default
// CRF, with the codec's CPU time per frame.
//   x264: ultrafast 16 ms, 3.6 MB, 48.1 dB; superfast 26, 1.5, 48.4; veryfast 45, 0.95, 47.6; medium 101, 0.96, 48.7.
//   VP9: realtime (cpu-used 6) 37 ms, 0.86 MB, 47.8 dB; good (cpu-used 4) 164, 0.61, 47.8.
constexpr std::array<std::string_view, 10> kX264Presets = {"veryfast", "ultrafast", "superfast", "faster",   "fast",
                                                           "medium",   "slow",      "slower",    "veryslow", "placebo"};
constexpr std::array<std::string_view, 3> kVpxDeadlines = {"realtime", "good", "best"};

std::span<const std::string_view> presets_of(const VideoFormat& format) {
  const std::string_view kind = format.extension;
  if (kind == ".mp4") return kX264Presets;
  if (kind == ".webm") return kVpxDeadlines;
  return {};
}

void append_h264(Arguments& arguments, const std::string& crf, std::string_view preset) {
  append(arguments, {"-c:v", "libx264", "-crf", crf, "-preset", preset, "-chroma_sample_location", "left", "-movflags",
                     "+faststart"});
  append_tags(arguments, true);
}

void append_vp9(Arguments& arguments, const std::string& crf, std::string_view deadline, bool has_alpha) {
  // -b:v 0 makes the quality constant; cpu-used 4 is the fastest of "good" without loss of features.
  append(arguments, {"-c:v", "libvpx-vp9", "-crf", crf, "-b:v", "0", "-deadline", deadline, "-cpu-used",
                     deadline == "realtime" ? "6" : "4", "-row-mt", "1", "-chroma_sample_location", "left"});
  // libvpx codes alpha as a second stream, which cannot have invisible reference frames.
  if (has_alpha) append(arguments, {"-auto-alt-ref", "0"});
  append_tags(arguments, true);
}

void append_ffv1(Arguments& arguments) {
  // Every frame alone, in four slices with checksums: seekable, decodable in parallel, and damage is detected.
  append(arguments, {"-c:v", "ffv1", "-level", "3", "-g", "1", "-slices", "4", "-slicecrc", "1"});
  append_tags(arguments, false);
}

void append_prores(Arguments& arguments, bool has_alpha) {
  append(arguments, {"-c:v", "prores_ks", "-profile:v", has_alpha ? "4444" : "hq", "-vendor", "apl0"});
  if (has_alpha) append(arguments, {"-alpha_bits", "16"});
  append_tags(arguments, true);
}

void append_gif(Arguments& arguments, bool has_alpha) {
  // A palette for each frame: one for all would need all frames in memory first.
  append(arguments, {"-filter_complex",
                     has_alpha ? "[0:v]split[a][b];[b]palettegen=stats_mode=single[p];[a][p]paletteuse=new=1"
                               : "[0:v]split[a][b];[b]palettegen=stats_mode=single:reserve_transparent=0[p];"
                                 "[a][p]paletteuse=new=1",
                     "-c:v", "gif", "-loop", "0"});
}

void append_apng(Arguments& arguments, int compression) {
  // As for still PNG: one filter and little search, unless the user asks for compression.
  append(arguments, {"-c:v", "apng", "-pred", compression < 0 ? "avg" : "mixed", "-compression_level",
                     std::to_string(compression < 0 ? 1 : compression), "-plays", "0"});
  append_tags(arguments, false);
}

void append_codec(Arguments& arguments, const VideoFormat& format, const SinkOptions& options) {
  const std::string crf = std::to_string(options.video_quality < 0 ? format.default_crf : options.video_quality);
  const std::string_view kind = format.extension;
  const std::span<const std::string_view> presets = presets_of(format);
  const std::string_view preset = options.preset.empty() && !presets.empty() ? presets.front() : options.preset;
  if (kind == ".mp4") append_h264(arguments, crf, preset);
  if (kind == ".webm") append_vp9(arguments, crf, preset, options.has_alpha);
  if (kind == ".mkv") append_ffv1(arguments);
  if (kind == ".mov") append_prores(arguments, options.has_alpha);
  if (kind == ".gif") append_gif(arguments, options.has_alpha);
  if (kind == ".apng") append_apng(arguments, options.image.compression);
}

void check_preset(const VideoFormat& format, const std::string& preset, const std::filesystem::path& shown) {
  const std::span<const std::string_view> presets = presets_of(format);
  if (preset.empty() || std::find(presets.begin(), presets.end(), preset) != presets.end()) return;
  throw Error(ErrorKind::kUnsupported, shown.string(),
              presets.empty() ? fmt::format("{} has no presets; they are for .mp4 and .webm", format.extension)
                              : fmt::format("'{}' is no preset of {}; use one of {}", preset, format.extension,
                                            fmt::join(presets, ", ")));
}

void check_compression(const VideoFormat& format, int compression, const std::filesystem::path& shown) {
  constexpr int kSmallest = 9;
  if (compression < 0) return;
  if (std::string_view(format.extension) != ".apng")
    throw Error(ErrorKind::kUnsupported, shown.string(),
                fmt::format("{} has no levels of compression; PNG, TIFF, EXR and .apng have them", format.extension));
  if (compression > kSmallest)
    throw Error(ErrorKind::kUnsupported, shown.string(),
                fmt::format("compression {} is not in 0 (none) to {} (smallest)", compression, kSmallest));
}

void check_options(const VideoFormat& format, const SinkOptions& options, const std::filesystem::path& shown) {
  if (options.fps_num < 1 || options.fps_den < 1)
    throw Error(
        ErrorKind::kUnsupported, shown.string(),
        fmt::format("a frame rate of {}/{} makes no sense; it must be above 0", options.fps_num, options.fps_den));
  check_preset(format, options.preset, shown);
  check_compression(format, options.image.compression, shown);
  if (format.default_crf >= 0 && options.video_quality > format.worst_crf)
    throw Error(ErrorKind::kUnsupported, shown.string(),
                fmt::format("the quality of {} is a CRF from 0 (best) to {}, not {}", format.extension,
                            format.worst_crf, options.video_quality));
  if (format.max_fps > 0 && options.fps_num > std::int64_t{format.max_fps} * options.fps_den)
    throw Error(ErrorKind::kUnsupported, shown.string(),
                fmt::format("players show a {} with at most {} frames per second, not {}/{}; lower the rate or write "
                            ".apng, .webm or .mp4",
                            format.extension, format.max_fps, options.fps_num, options.fps_den));
}

}  // namespace

cv::Size VideoFormat::coded_size(cv::Size size) const {
  return even_size ? cv::Size(size.width + size.width % 2, size.height + size.height % 2) : size;
}

const VideoFormat* find_video_format(const std::filesystem::path& file) {
  const std::string extension = lower(file.extension().string());
  const auto* found = std::find_if(kFormats.begin(), kFormats.end(),
                                   [&](const VideoFormat& format) { return extension == format.extension; });
  return found == kFormats.end() ? nullptr : found;
}

std::string video_extensions() {
  std::string all;
  for (const auto& format : kFormats) all += (all.empty() ? "" : ", ") + std::string(format.extension);
  return all;
}

std::vector<std::string> ffmpeg_command(const VideoFormat& format, const SinkOptions& options,
                                        const std::filesystem::path& file, const std::filesystem::path& shown) {
  check_options(format, options, shown);
  const cv::Size size = format.coded_size(options.size);
  Arguments arguments = {"ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-y", "-xerror"};
  const std::string rate = fmt::format("{}/{}", options.fps_num, options.fps_den);
  append(arguments, {"-f", "rawvideo", "-pix_fmt", pix_fmt(format.raw(options.has_alpha)), "-video_size",
                     fmt::format("{}x{}", size.width, size.height), "-framerate", rate, "-i", "pipe:0"});
  append_codec(arguments, format, options);
  if (!options.comment.empty()) append(arguments, {"-metadata", "comment=" + options.comment});
  // -r again, for the output: ffmpeg otherwise guesses the input's rate from its times and takes 120000/1001 for 120.
  append(arguments, {"-r", rate});
  // Without bitexact, containers hold dates, random identifiers and version numbers. x264's bytes depend on the number
  // of threads, so it must not depend on the machine.
  append(arguments, {"-threads", "4", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-f", format.muxer});
  // With "file:", ffmpeg does not read the name "a:b.mp4" as a protocol or "-x.mp4" as an option.
  arguments.push_back("file:" + file.string());
  return arguments;
}

}  // namespace morphkit::media
