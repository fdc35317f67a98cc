#include "morph/media/frame_sink.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/whole_file.h"
#include "morph/media/image_format.h"
#include "morph/media/made_from.h"
#include "morph/media/process.h"
#include "morph/media/video_format.h"
#include "morph/media/video_sink.h"

namespace morphkit::media {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& output) {
  return output.has_parent_path() ? output.parent_path() : fs::path(".");
}

/// One image file per frame; or, without a pattern, one file for the only frame.
class FileSink final : public FrameSink {
 public:
  FileSink(fs::path name, std::optional<FramePattern> pattern, SinkOptions options)
      : name_(std::move(name)), pattern_(std::move(pattern)), options_(std::move(options)) {
    if (pattern_) {
      remove_leftovers(folder_of(name_), [this](const std::string& found) { return pattern_->names(found); });
    }
  }

  Packet encode(int frame, const warp::Image& image) override {
    if (image.size() != options_.size)
      throw std::invalid_argument(fmt::format("frame {} is {}x{} px, the sink {}x{} px", frame, image.cols, image.rows,
                                              options_.size.width, options_.size.height));
    WriteOptions write = options_.image;
    write.software = mark(frame);
    return encode_image(file(frame), image, write);
  }

  void write(int frame, Packet packet) override {
    AtomicFile target(file(frame), options_.image.overwrite, pattern_ ? Leftovers::kKeep : Leftovers::kRemove);
    target.write(packet);
    target.commit();
  }

  void finish() override {}

  bool has(int frame) const override {
    const fs::path name = file(frame);
    std::error_code error;
    if (!fs::is_regular_file(name, error)) return false;
    try {
      const Picture picture = read_picture(name);
      return picture.image.size() == options_.size && (!carries_mark() || says(picture.info, mark(frame)));
    } catch (const Error&) {
      return false;
    }
  }

  std::vector<fs::path> existing(const std::vector<int>& frames) const override {
    std::vector<fs::path> found;
    for (const int frame : frames) {
      std::error_code error;
      if (fs::path name = file(frame); fs::exists(name, error)) found.push_back(std::move(name));
    }
    return found;
  }

 private:
  bool carries_mark() const {
    const WritableFormat* format = writable_format(name_);
    return options_.made_from && format != nullptr && format->carries_software;
  }

  /// What the file of a frame says about what it was made from; empty: nothing.
  std::string mark(int frame) const {
    if (!carries_mark()) return "";
    const WriteOptions& write = options_.image;
    return made_from_mark(fmt::format("{}\ndepth {} compression {} quality {} alpha {}", options_.made_from(frame),
                                      static_cast<int>(write.depth), write.compression, write.quality,
                                      write.alpha ? static_cast<int>(*write.alpha) : -1));
  }

  static bool says(const ImageInfo& info, const std::string& mark) {
    return std::ranges::any_of(info.metadata, [&](const auto& entry) { return entry.second == mark; });
  }

  fs::path file(int frame) const { return pattern_ ? (*pattern_)(frame) : name_; }

  fs::path name_;
  std::optional<FramePattern> pattern_;
  SinkOptions options_;
};

void check_folder(const fs::path& output) {
  const fs::path folder = folder_of(output);
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status))
    throw Error(ErrorKind::kIo, output.string(), fmt::format("the folder {} does not exist", folder.string()));
  if (!fs::is_directory(status))
    throw Error(ErrorKind::kIo, output.string(), fmt::format("{} is not a folder", folder.string()));
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0)
    throw Error(
        ErrorKind::kIo, output.string(),
        fmt::format("the folder {} cannot be written: {}", folder.string(), std::generic_category().message(errno)));
}

/// What a video says about what it was made from; empty: nothing.
std::string video_mark(const SinkOptions& options) {
  if (!options.made_from) return "";
  std::string all =
      fmt::format("{}x{} at {}/{} quality {} preset {} alpha {}", options.size.width, options.size.height,
                  options.fps_num, options.fps_den, options.video_quality, options.preset, options.has_alpha);
  for (const int frame : options.frames) all += "\n" + options.made_from(frame);
  return made_from_mark(all);
}

/// Whether ffmpeg decodes all of a file without complaint.
bool decodes(const fs::path& video) {
  try {
    Process ffmpeg({"ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-i", "file:" + video.string(), "-f",
                    "null", "-"});
    return ffmpeg.finish().ok() && ffmpeg.last_lines().empty();
  } catch (const std::system_error&) {
    return false;
  }
}

[[noreturn]] void refuse_kind(const fs::path& output) {
  const std::string extension = output.extension().string();
  throw Error(ErrorKind::kUnsupported, output.string(),
              fmt::format("{}; write a video ({}), or numbered images such as frame.%04d.png",
                          extension.empty() ? "the name has no extension that would tell the kind of output"
                                            : fmt::format("'{}' is no kind of output that is known", extension),
                          video_extensions()));
}

}  // namespace

std::unique_ptr<FrameSink> open_sink(const fs::path& output, const SinkOptions& options, bool single_frame) {
  if (options.size.empty())
    throw std::invalid_argument(fmt::format("a sink of {}x{} px", options.size.width, options.size.height));
  const bool numbered = FramePattern::matches(output);
  const VideoFormat* video = find_video_format(output);
  if (video != nullptr && numbered && !is_image_extension(output))
    throw Error(ErrorKind::kUnsupported, output.string(),
                "a video is one file: leave the place for the frame number out of its name");
  if (video == nullptr && !is_image_extension(output)) refuse_kind(output);
  if (video == nullptr && !numbered && !single_frame)
    throw Error(ErrorKind::kUnsupported, output.string(),
                fmt::format("one image cannot hold several frames; write {}, or a video ({})",
                            (output.stem() += ".%04d" + output.extension().string()).string(), video_extensions()));
  std::optional<FramePattern> pattern;
  if (numbered) pattern.emplace(output);
  check_folder(output);
  // A .gif is an animation unless its name has a frame number.
  if (video != nullptr && !numbered) {
    SinkOptions with_comment = options;
    with_comment.comment = video_mark(options);
    return std::make_unique<VideoSink>(output, *video, with_comment);
  }
  if (!options.preset.empty())
    throw Error(ErrorKind::kUnsupported, output.string(), "images have no presets; they are for .mp4 and .webm");
  check_write_options(output, options.image);
  return std::make_unique<FileSink>(output, std::move(pattern), options);
}

bool is_complete_video(const fs::path& output, const SinkOptions& options) {
  std::error_code error;
  if (find_video_format(output) == nullptr || !fs::is_regular_file(output, error)) return false;
  const std::string mark = video_mark(options);
  return !mark.empty() && read_file(output, "video").find(mark) != std::string::npos && decodes(output);
}

}  // namespace morphkit::media
