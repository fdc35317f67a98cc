#pragma once
// The kinds of video and animation, and the ffmpeg command for each. Internal to morph/media.

#include <filesystem>
#include <string>
#include <vector>

#include "morph/media/frame_sink.h"
#include "morph/media/raw_frame.h"

namespace morphkit::media {

/// One kind of video file.
///
/// | extension | codec, pixels                                   | transparent frames | quality                |
/// |-----------|-------------------------------------------------|--------------------|------------------------|
/// | .mp4      | H.264, 4:2:0 8 bit; odd sizes grow by one pixel | over black         | CRF 0..51, default 18  |
/// | .webm     | VP9, 4:2:0 8 bit                                | kept               | CRF 0..63, default 24  |
/// | .mkv      | FFV1, RGB 16 bit, lossless                      | kept               |                        |
/// | .mov      | ProRes 422 HQ 10 bit; with alpha 4444           | kept               |                        |
/// | .gif      | 256 colours per frame, for ever                 | kept, on or off    |                        |
/// | .apng     | RGB 8 bit, lossless, for ever                   | kept               | compression 0..9       |
///
/// Presets have ffmpeg's names: those of x264 for .mp4 (ultrafast .. placebo, default veryfast), the deadlines of
/// libvpx for .webm (realtime, the default, good, best).
struct VideoFormat {
  const char* extension;  ///< lower case, with the dot
  const char* muxer;      ///< ffmpeg's -f
  RawFormat opaque;       ///< piped format of opaque frames
  RawFormat alpha;        ///< piped format of frames that may be transparent; `opaque` if the format has no alpha
  bool even_size;         ///< whether width and height must be even
  int default_crf;        ///< -1: the codec has no such scale
  int worst_crf;          ///< largest CRF
  int max_fps;            ///< 0: any

  RawFormat raw(bool has_alpha) const { return has_alpha ? alpha : opaque; }
  /// Size of the piped frames, px.
  cv::Size coded_size(cv::Size size) const;
};

/// The kind for the extension, in upper or lower case; nullptr if there is none.
const VideoFormat* find_video_format(const std::filesystem::path& file);

/// ".mp4, .webm, ...": for messages.
std::string video_extensions();

/// ffmpeg and its arguments: raw frames on standard input, the video in `file`. The same options and the same frames
/// give the same bytes.
/// @throws Error kUnsupported, naming `shown`, for an unsupported quality, preset, compression or frame rate.
std::vector<std::string> ffmpeg_command(const VideoFormat& format, const SinkOptions& options,
                                        const std::filesystem::path& file, const std::filesystem::path& shown);

}  // namespace morphkit::media
