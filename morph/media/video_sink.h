#pragma once
// Writes frames to a video or animation file through the ffmpeg program. Internal to morph/media.

#include <filesystem>
#include <vector>

#include "base/atomic_file.h"
#include "morph/media/frame_sink.h"
#include "morph/media/process.h"
#include "morph/media/video_format.h"

namespace morphkit::media {

/// `encode` makes raw pixels, `write` pipes them to ffmpeg, which writes to a temporary file beside the target;
/// `finish` renames it. Memory: one pipe buffer, and the codec's look-ahead.
class VideoSink final : public FrameSink {
 public:
  /// @throws Error as open_sink does.
  VideoSink(const std::filesystem::path& file, const VideoFormat& format, const SinkOptions& options);

  Packet encode(int frame, const warp::Image& image) override;
  void write(int frame, Packet packet) override;
  void finish() override;
  bool has(int frame) const override;
  std::vector<std::filesystem::path> existing(const std::vector<int>& frames) const override;

 private:
  Process start(const SinkOptions& options) const;
  [[noreturn]] void report_end();

  std::filesystem::path file_;
  const VideoFormat& format_;
  cv::Size size_;
  bool has_alpha_;
  bool any_frame_ = false;
  AtomicFile output_;  ///< outlives ffmpeg: the file is removed only after its last write
  Process ffmpeg_;
};

}  // namespace morphkit::media
