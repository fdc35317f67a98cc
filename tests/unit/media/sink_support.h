#pragma once
// Helpers of the sink tests: a temporary folder, moving pictures, and calls of ffmpeg and ffprobe.

#include <sys/wait.h>

#include <algorithm>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "morph/media/frame_sink.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::test {

/// Sets an environment variable for the lifetime of the object.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    ::setenv(name, value.c_str(), 1);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
  ~Environment() { ::setenv(name_, before_.c_str(), 1); }
  const std::string& before() const { return before_; }

 private:
  const char* name_;
  std::string before_;
};

/// Standard output of a shell command; the test fails if the command does.
inline Bytes output_of(const std::string& command) {
  Bytes bytes;
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) {
    ADD_FAILURE() << "cannot start " << command;
    return bytes;
  }
  std::uint8_t buffer[65536];
  for (std::size_t got = 0; (got = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;)
    bytes.insert(bytes.end(), buffer, buffer + got);
  EXPECT_EQ(::pclose(pipe), 0) << command;
  return bytes;
}

/// ffprobe's report on the only video stream, with every frame decoded and counted.
inline std::map<std::string, std::string> probe(const std::filesystem::path& file) {
  const Bytes text =
      output_of("ffprobe -v error -count_frames -select_streams v -show_streams '" + file.string() + "'");
  std::istringstream lines(std::string(text.begin(), text.end()));
  std::map<std::string, std::string> found;
  for (std::string line; std::getline(lines, line);)
    if (const auto equals = line.find('='); equals != std::string::npos)
      found[line.substr(0, equals)] = line.substr(equals + 1);
  return found;
}

/// All frames, one after the other, in ffmpeg's pixel format `pix_fmt`.
inline Bytes decode(const std::filesystem::path& file, const std::string& pix_fmt, const std::string& decoder = "") {
  const std::string input = decoder.empty() ? " -i '" : " -c:v " + decoder + " -i '";
  return output_of("ffmpeg -nostdin -v error" + input + file.string() +
                   "' -fps_mode passthrough -sws_flags accurate_rnd+full_chroma_int+bicubic -f rawvideo -pix_fmt " +
                   pix_fmt + " -");
}

/// The same in 8-bit RGB or RGBA. `deep` files are decoded to 16 bits and rounded by us: swscale truncates.
inline Bytes decode8(const std::filesystem::path& file, bool alpha, bool deep, const std::string& decoder = "") {
  if (!deep) return decode(file, alpha ? "rgba" : "rgb24", decoder);
  const Bytes codes = decode(file, alpha ? "rgba64le" : "rgb48le", decoder);
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < codes.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(((codes[i] | codes[i + 1] << 8) + 128) / 257));
  return bytes;
}

/// dB of 8-bit codes; infinite when equal, NaN (which fails every comparison) when the sizes differ.
inline double psnr(const Bytes& a, const Bytes& b) {
  if (a.size() != b.size() || a.empty()) return std::nan("");
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (double(a[i]) - b[i]) * (double(a[i]) - b[i]);
  return 10 * std::log10(255.0 * 255.0 * double(a.size()) / sum);
}

/// A smooth picture that moves with `frame`; with alpha, a soft disc on transparency.
inline warp::Image moving_picture(cv::Size size, int frame, bool with_alpha = false) {
  warp::Image image(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const float u = float(x + frame) / float(size.width);
      const float v = float(y) / float(size.height);
      const float from_centre =
          std::hypot(float(x) + 0.5F - 0.5F * float(size.width), float(y) + 0.5F - 0.5F * float(size.height));
      const float a = with_alpha ? std::clamp((0.45F * float(size.height) - from_centre) / 4.0F, 0.0F, 1.0F) : 1.0F;
      image(y, x) = {(0.5F + 0.4F * std::sin(6.0F * u)) * a, (0.1F + 0.8F * v) * a,
                     (0.5F + 0.4F * std::cos(5.0F * (u + v))) * a, a};
    }
  }
  return image;
}

/// Writes frames 0 .. count-1 and finishes.
inline void write_all(media::FrameSink& sink, cv::Size size, int count, bool with_alpha = false) {
  for (int frame = 0; frame < count; ++frame)
    sink.write(frame, sink.encode(frame, moving_picture(size, frame, with_alpha)));
  sink.finish();
}

/// Whether this process has any child, running or not reaped.
inline bool has_children() {
  return ::waitpid(-1, nullptr, WNOHANG | WNOWAIT) != -1;
}

}  // namespace morphkit::test
