#include "morph/media/video_sink.h"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "base/error.h"

namespace morphkit::media {

VideoSink::VideoSink(const std::filesystem::path& file, const VideoFormat& format, const SinkOptions& options)
    : file_(file),
      format_(format),
      size_(options.size),
      has_alpha_(options.has_alpha),
      output_(file, options.image.overwrite),
      ffmpeg_(start(options)) {}

Process VideoSink::start(const SinkOptions& options) const {
  const auto command = ffmpeg_command(format_, options, output_.temporary(), file_);
  try {
    return Process(command);
  } catch (const std::system_error& error) {
    if (error.code().value() != ENOENT)
      throw Error(ErrorKind::kIo, file_.string(),
                  fmt::format("the ffmpeg program cannot be started: {}", error.code().message()));
    throw Error(ErrorKind::kIo, file_.string(),
                fmt::format("writing {} needs the ffmpeg program, which is not on PATH; install it (apt-get install "
                            "ffmpeg) or write frames: frame.%04d.png",
                            format_.extension));
  }
}

FrameSink::Packet VideoSink::encode(int frame, const warp::Image& image) {
  if (image.size() != size_)
    throw std::invalid_argument(fmt::format("frame {} is {}x{} px, the video {}x{} px", frame, image.cols, image.rows,
                                            size_.width, size_.height));
  return raw_frame(image, format_.raw(has_alpha_), format_.coded_size(size_));
}

void VideoSink::write(int /*frame*/, Packet packet) {
  if (!ffmpeg_.write(packet)) report_end();
  any_frame_ = true;
}

void VideoSink::finish() {
  if (!any_frame_) {
    ffmpeg_.kill();
    throw Error(ErrorKind::kFailed, file_.string(), "there is no frame to write");
  }
  if (!ffmpeg_.finish().ok()) report_end();
  std::error_code error;
  if (const auto bytes = std::filesystem::file_size(output_.temporary(), error); error || bytes == 0)
    throw Error(ErrorKind::kFailed, file_.string(), "ffmpeg ended well but has written nothing");
  output_.commit();
}

/// Throws the error for an ffmpeg that ended too early or with a failure.
void VideoSink::report_end() {
  const Process::Exit end = ffmpeg_.finish();
  std::string lines = ffmpeg_.last_lines();
  // Disk errors are not ffmpeg's fault; it quotes the messages of the system.
  const bool disk = lines.find(std::strerror(ENOSPC)) != std::string::npos ||
                    lines.find(std::strerror(EDQUOT)) != std::string::npos ||
                    lines.find(std::strerror(EIO)) != std::string::npos;
  const std::string said = lines.empty() ? "it said nothing" : "it said:\n" + lines;
  throw Error(disk ? ErrorKind::kIo : ErrorKind::kFailed, file_.string(),
              fmt::format("ffmpeg {} before the video was complete; {}", end.text(), said));
}

bool VideoSink::has(int /*frame*/) const {
  return false;
}

std::vector<std::filesystem::path> VideoSink::existing(const std::vector<int>& /*frames*/) const {
  std::error_code error;
  if (!std::filesystem::exists(file_, error)) return {};
  return {file_};
}

}  // namespace morphkit::media
