#pragma once
// Sinks for rendered frames: numbered image files, or a video or animation through the ffmpeg program.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "morph/media/frame_pattern.h"
#include "morph/media/image_file.h"
#include "warp/image/image.h"

namespace morphkit::media {

struct SinkOptions {
  cv::Size size;                  ///< px, of every frame
  int fps_num = 24, fps_den = 1;  ///< rational rate
  WriteOptions image;             ///< for frame files; `image.overwrite` applies to videos too
  int video_quality = -1;         ///< CRF if the codec has one; -1: a good default
  std::string preset;             ///< speed preset of the video encoder; empty: a good default
  /// Everything that decides the pixels of a frame, as text; with the options above, its digest goes into the file.
  /// Empty: files carry none, and resuming cannot tell what they were made from.
  std::function<std::string(int frame)> made_from;
  std::vector<int> frames;  ///< of a video, for its digest
  std::string comment;      ///< of a video; set by open_sink
  bool has_alpha = false;   ///< whether frames may be transparent; formats without alpha get frames over black
};

/// Takes frames. `encode` may run for several frames at once, in any order. `write` is called for one frame after the
/// other, in rising order, and `finish` once at the end. A sink that is destroyed without `finish` leaves no
/// half-written file: finished frame files stay, an unfinished video is removed.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  using Packet = std::vector<std::uint8_t>;

  /// @param image  of the sink's size. @throws std::invalid_argument if it is not; Error as encode_image does.
  virtual Packet encode(int frame, const warp::Image& image) = 0;
  /// @param packet  the result of `encode` for this frame.
  /// @throws Error as write_image does; for videos kFailed or kIo with ffmpeg's last lines if it has ended.
  virtual void write(int frame, Packet packet) = 0;
  /// @throws Error as write; kFailed if no frame was written to a video.
  virtual void finish() = 0;

  /// Whether a file of the frame exists that decodes to its end, has the right size and was made from the same as the
  /// frame would be (frame files only; WebP and TGA files do not say what they were made from). Cost: decodes the file.
  /// Thread-safe.
  virtual bool has(int frame) const = 0;
  /// The existing files that these frames would overwrite.
  virtual std::vector<std::filesystem::path> existing(const std::vector<int>& frames) const = 0;
};

/// Opens a sink of the kind that the extension of `output` names: a frame pattern of any image format, `.mp4` (H.264),
/// `.webm` (VP9), `.mkv` (FFV1), `.mov` (ProRes), `.gif`, `.apng`; a plain image name for a single frame
/// (`single_frame`). video_format.h says how each kind of video is made.
/// @throws Error kUnsupported for an unknown kind, a name without a place for the frame number, or an option that the
///         kind does not support (quality, preset, depth, compression); kIo if ffmpeg is missing, if the folder is
///         missing or cannot be written, or if the video exists and `options.image.overwrite` is off. Existing frame
///         files are refused one by one, by `write`.
std::unique_ptr<FrameSink> open_sink(const std::filesystem::path& output, const SinkOptions& options,
                                     bool single_frame);

/// Whether `output` is a video that ffmpeg decodes to its end without complaint, and that was made from what `options`
/// say, frames included. GIF and APNG do not say what they were made from: always false. Cost: decodes the file.
bool is_complete_video(const std::filesystem::path& output, const SinkOptions& options);

}  // namespace morphkit::media
