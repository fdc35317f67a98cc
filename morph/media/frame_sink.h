#pragma once
// Where rendered frames go: numbered image files, or a video or animation through the ffmpeg program.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "morph/media/frame_pattern.h"
#include "morph/media/image_file.h"
#include "warp/image/image.h"

namespace morphkit::media {

struct SinkOptions {
  cv::Size size;                  ///< px; every frame has it
  int fps_num = 24, fps_den = 1;  ///< rational rate
  WriteOptions image;             ///< for frame files; `image.overwrite` holds for videos too
  int video_quality = -1;         ///< CRF where the codec has one; -1: a good default
  std::string preset;             ///< how long the encoder of a video may think; empty: a good default
  bool has_alpha = false;         ///< whether frames may be transparent; formats without alpha get them over black
};

/// Takes frames. `encode` may run for several frames at once, in any order; `write` is called for one frame after the
/// other in rising order; `finish` once at the end. A sink destroyed without `finish` leaves no half-written file:
/// finished frame files stay, an unfinished video is removed.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  using Packet = std::vector<std::uint8_t>;

  /// @param image  of the sink's size. @throws std::invalid_argument if it is not; Error as encode_image does.
  virtual Packet encode(int frame, const warp::Image& image) = 0;
  /// @param packet  what `encode` gave for this frame.
  /// @throws Error as write_image does; for videos kFailed or kIo with ffmpeg's last lines if it has died.
  virtual void write(int frame, Packet packet) = 0;
  /// @throws Error as write; kFailed if no frame was written to a video.
  virtual void finish() = 0;

  /// Whether the frame is already there, complete (frame files only): what `--resume` skips.
  virtual bool has(int frame) const = 0;
  /// The files that would be overwritten by these frames.
  virtual std::vector<std::filesystem::path> existing(const std::vector<int>& frames) const = 0;
};

/// Opens a sink told by `output`'s extension: a frame pattern of any image format, `.mp4` (H.264), `.webm` (VP9),
/// `.mkv` (FFV1), `.mov` (ProRes), `.gif`, `.apng`; a plain image name for a single frame (`single_frame`).
/// video_format.h says how each kind of video is made.
/// @throws Error kUsage for an unknown kind, a name without a place for the frame number, or an option that the kind
///         has not (quality, preset, depth, compression); kIo if ffmpeg is missing, the folder is missing or cannot be
///         written, or the video exists and `options.image.overwrite` is off. Frame files that exist are refused one by
///         one, by `write`.
std::unique_ptr<FrameSink> open_sink(const std::filesystem::path& output, const SinkOptions& options,
                                     bool single_frame);

}  // namespace morphkit::media
