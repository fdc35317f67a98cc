// Every kind of video, written, probed and decoded again. These tests need ffmpeg and fail without it.

#include <string>

#include <gtest/gtest.h>

#include "morph/media/raw_frame.h"
#include "tests/unit/media/sink_support.h"

namespace morphkit::media {
namespace {

namespace fs = std::filesystem;
using test::Bytes;
using test::decode;
using test::decode8;
using test::moving_picture;
using test::probe;
using test::psnr;
using test::read_bytes;
using test::TemporaryFolder;
using test::write_all;

constexpr int kFrames = 12;

SinkOptions options(cv::Size size, bool has_alpha = false) {
  SinkOptions result;
  result.size = size;
  result.fps_num = 30000;
  result.fps_den = 1001;
  result.has_alpha = has_alpha;
  return result;
}

fs::path write_video(const fs::path& file, const SinkOptions& how, int frames = kFrames) {
  const auto sink = open_sink(file, how, false);
  write_all(*sink, how.size, frames, how.has_alpha);
  return file;
}

/// The original frames in one of our raw formats.
Bytes originals(RawFormat format, cv::Size size, bool has_alpha, int frames = kFrames) {
  Bytes all;
  for (int frame = 0; frame < frames; ++frame) {
    const Bytes one = raw_frame(moving_picture(size, frame, has_alpha), format, size);
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

/// Unpremultiplied RGBA over black, in codes.
Bytes over_black(const Bytes& rgba) {
  Bytes rgb;
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4)
    for (int c = 0; c < 3; ++c) rgb.push_back(static_cast<std::uint8_t>((rgba[i + c] * rgba[i + 3] + 127) / 255));
  return rgb;
}

/// The top left `size` of enlarged frames.
Bytes cropped(const Bytes& rgb, cv::Size grown, cv::Size size) {
  Bytes all;
  const std::size_t stride = 3 * static_cast<std::size_t>(grown.width);
  const std::size_t rows = rgb.size() / stride;
  for (std::size_t row = 0; row < rows; ++row)
    if (static_cast<int>(row % grown.height) < size.height)
      all.insert(all.end(), rgb.begin() + static_cast<std::ptrdiff_t>(row * stride),
                 rgb.begin() + static_cast<std::ptrdiff_t>(row * stride) + 3 * size.width);
  return all;
}

struct Kind {
  const char* extension;
  bool alpha;
  const char* codec;
  const char* pix_fmt;  ///< as ffprobe sees it: FFV1 stores RGB as planes, ProRes decodes to 12 bits
  const char* decoder;  ///< when ffmpeg's own choice loses alpha
  const char* matrix;   ///< ffprobe's color_space; empty: the format does not say
  const char* range;
  bool deep;        ///< more than 8 bits
  double least_db;  ///< 8-bit RGB, whole sequence
};

// At most 1.5 dB below the measured values. Lossless kinds are exact; mkv loses only by our rounding to 8 bits, twice.
const Kind kKinds[] = {
    {".mp4", false, "h264", "yuv420p", "", "bt709", "tv", false, 37},
    {".webm", false, "vp9", "yuv420p", "", "bt709", "tv", false, 38},
    {".webm", true, "vp9", "yuv420p", "libvpx-vp9", "bt709", "tv", false, 40},
    {".mov", false, "prores", "yuv422p10le", "", "bt709", "tv", true, 41},
    {".mov", true, "prores", "yuva444p12le", "", "bt709", "tv", true, 52},
    {".mkv", false, "ffv1", "gbrp16le", "", "gbr", "pc", true, 1000},
    {".mkv", true, "ffv1", "gbrap16le", "", "gbr", "pc", true, 1000},
    {".gif", false, "gif", "bgra", "", "", "", false, 32},
    {".apng", false, "apng", "rgb24", "", "", "pc", false, 1000},
    {".apng", true, "apng", "rgba", "", "", "pc", false, 1000},
};

class VideoKinds : public testing::TestWithParam<Kind> {};

INSTANTIATE_TEST_SUITE_P(All, VideoKinds, testing::ValuesIn(kKinds), [](const auto& kind) {
  return std::string(kind.param.extension + 1) + (kind.param.alpha ? "_alpha" : "");
});

TEST_P(VideoKinds, HasTheRightCodecSizeAndTags) {
  const Kind& kind = GetParam();
  const TemporaryFolder folder;
  const fs::path file = write_video(folder / (std::string("v") + kind.extension), options({64, 48}, kind.alpha));
  auto found = probe(file);
  EXPECT_EQ(found["codec_name"], kind.codec);
  EXPECT_EQ(found["pix_fmt"], kind.pix_fmt);
  EXPECT_EQ(found["width"], "64");
  EXPECT_EQ(found["height"], "48");
  EXPECT_EQ(found["nb_read_frames"], std::to_string(kFrames));
  if (*kind.range != '\0') {
    EXPECT_EQ(found["color_range"], kind.range);
  }
  if (*kind.matrix != '\0') {
    EXPECT_EQ(found["r_frame_rate"], "30000/1001");
    EXPECT_EQ(found["color_space"], kind.matrix);
    EXPECT_EQ(found["color_primaries"], "bt709");
    EXPECT_EQ(found["color_transfer"], "iec61966-2-1");
  }
  if (std::string(kind.extension) == ".webm") {
    EXPECT_EQ(found["TAG:alpha_mode"], kind.alpha ? "1" : "");
  }
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST_P(VideoKinds, DecodesToTheOriginalPictures) {
  const Kind& kind = GetParam();
  const TemporaryFolder folder;
  // Odd both ways, to show that no kind crops, shifts or smears the last column.
  for (const cv::Size size : {cv::Size(64, 48), cv::Size(63, 47)}) {
    const fs::path file =
        write_video(folder / (std::to_string(size.width) + kind.extension), options(size, kind.alpha));
    Bytes decoded = decode8(file, kind.alpha, kind.deep, kind.decoder);
    if (std::string(kind.extension) == ".mp4") decoded = cropped(decoded, {64, 48}, size);
    const Bytes wanted = originals(kind.alpha ? RawFormat::kRgba : RawFormat::kRgb24, size, kind.alpha);
    if (!kind.alpha) {
      EXPECT_GE(psnr(decoded, wanted), kind.least_db) << size;
      continue;
    }
    EXPECT_GE(psnr(over_black(decoded), over_black(wanted)), kind.least_db) << size;
    Bytes decoded_alpha;
    Bytes wanted_alpha;
    for (std::size_t i = 3; i < decoded.size(); i += 4) decoded_alpha.push_back(decoded[i]);
    for (std::size_t i = 3; i < wanted.size(); i += 4) wanted_alpha.push_back(wanted[i]);
    EXPECT_GE(psnr(decoded_alpha, wanted_alpha), kind.least_db) << size;
  }
}

TEST_P(VideoKinds, TheSameFramesGiveTheSameBytes) {
  const Kind& kind = GetParam();
  const TemporaryFolder folder;
  const Bytes first =
      read_bytes(write_video(folder / (std::string("one") + kind.extension), options({96, 64}, kind.alpha)));
  const Bytes second =
      read_bytes(write_video(folder / (std::string("two") + kind.extension), options({96, 64}, kind.alpha)));
  EXPECT_FALSE(first.empty());
  EXPECT_TRUE(first == second);
}

TEST_P(VideoKinds, HoldsOneFrame) {
  const Kind& kind = GetParam();
  const TemporaryFolder folder;
  const fs::path file = write_video(folder / (std::string("v") + kind.extension), options({2, 2}, kind.alpha), 1);
  EXPECT_EQ(probe(file)["nb_read_frames"], "1");
}

TEST(Video, MkvIsLossless) {
  const TemporaryFolder folder;
  for (const bool alpha : {false, true}) {
    const cv::Size size(63, 47);
    const fs::path file = write_video(folder / (alpha ? "a.mkv" : "o.mkv"), options(size, alpha));
    EXPECT_TRUE(decode(file, alpha ? "rgba64le" : "rgb48le") ==
                originals(alpha ? RawFormat::kRgba64 : RawFormat::kRgb48, size, alpha));
  }
}

TEST(Video, FormatsWithoutAlphaGetFramesOverBlack) {
  const TemporaryFolder folder;
  const cv::Size size(32, 32);
  const auto sink = open_sink(folder / "v.mp4", options(size, true), false);
  const warp::Image half(size, warp::Pixel(0.25F, 0.1F, 0.05F, 0.5F));
  for (int frame = 0; frame < kFrames; ++frame) sink->write(frame, sink->encode(frame, half));
  sink->finish();
  const Bytes wanted = raw_frame(half, RawFormat::kRgb24, size);
  const Bytes decoded = decode8(folder / "v.mp4", false, false);
  ASSERT_EQ(decoded.size(), kFrames * wanted.size());
  // A step of chroma is up to 2.2 steps of RGB; half of it, and half a step of luma.
  for (std::size_t i = 0; i < decoded.size(); ++i) ASSERT_NEAR(decoded[i], wanted[i % wanted.size()], 2) << i;
}

TEST(Video, GifKeepsTransparencyOnOrOff) {
  const TemporaryFolder folder;
  const fs::path file = write_video(folder / "v.gif", options({64, 48}, true));
  const Bytes decoded = decode8(file, true, false);
  const Bytes wanted = originals(RawFormat::kRgba, {64, 48}, true);
  ASSERT_EQ(decoded.size(), wanted.size());
  Bytes decoded_opaque;
  Bytes wanted_opaque;
  for (std::size_t i = 0; i < wanted.size(); i += 4) {
    ASSERT_EQ(decoded[i + 3], wanted[i + 3] >= 128 ? 255 : 0) << i / 4;
    if (wanted[i + 3] < 128) continue;
    decoded_opaque.insert(decoded_opaque.end(), decoded.begin() + i, decoded.begin() + i + 3);
    wanted_opaque.insert(wanted_opaque.end(), wanted.begin() + i, wanted.begin() + i + 3);
  }
  EXPECT_GE(psnr(decoded_opaque, wanted_opaque), 36.0);
}

TEST(Video, AnimationsLoopForEver) {
  const TemporaryFolder folder;
  const Bytes gif = read_bytes(write_video(folder / "v.gif", options({16, 16})));
  const std::string loop = std::string("NETSCAPE2.0\x03\x01\0\0", 15);
  EXPECT_NE(std::search(gif.begin(), gif.end(), loop.begin(), loop.end()), gif.end());
  const Bytes apng = read_bytes(write_video(folder / "v.apng", options({16, 16})));
  const std::string control = std::string("acTL\0\0\0\x0C\0\0\0\0", 12);
  EXPECT_NE(std::search(apng.begin(), apng.end(), control.begin(), control.end()), apng.end());
  // fcTL: the delay of a frame is 1001/30000 s, in its bytes 20 to 23 after the chunk's name.
  const std::string name = "fcTL";
  const auto frame = std::search(apng.begin(), apng.end(), name.begin(), name.end());
  ASSERT_GT(apng.end() - frame, 28);
  EXPECT_EQ(Bytes(frame + 24, frame + 28), (Bytes{1001 >> 8, 1001 & 255, 30000 >> 8, 30000 & 255}));
}

TEST(Video, RatesAreRational) {
  const TemporaryFolder folder;
  struct Rate {
    int num, den;
  };
  for (const Rate rate : {Rate{24000, 1001}, Rate{25, 2}, Rate{1, 3}, Rate{120000, 1001}}) {
    SinkOptions how = options({16, 16});
    how.fps_num = rate.num;
    how.fps_den = rate.den;
    const std::string exact = std::to_string(rate.num) + "/" + std::to_string(rate.den);
    auto mp4 = probe(write_video(folder / (std::to_string(rate.num) + ".mp4"), how));
    EXPECT_EQ(mp4["avg_frame_rate"], exact);
    EXPECT_EQ(mp4["nb_read_frames"], std::to_string(kFrames)) << exact;
    // Matroska holds the duration of a frame in whole nanoseconds; ffprobe makes the nearest fraction of it.
    auto mkv = probe(write_video(folder / (std::to_string(rate.num) + ".mkv"), how));
    double num = 0;
    double den = 0;
    char slash = 0;
    std::istringstream(mkv["avg_frame_rate"]) >> num >> slash >> den;
    EXPECT_NEAR(num / den * rate.den / rate.num, 1.0, 1e-6) << exact;
    EXPECT_EQ(mkv["nb_read_frames"], std::to_string(kFrames)) << exact;
  }
}

TEST(Video, QualityIsTheCrf) {
  const TemporaryFolder folder;
  for (const char* extension : {".mp4", ".webm"}) {
    std::uintmax_t bytes[2];
    for (const int i : {0, 1}) {
      SinkOptions how = options({64, 48});
      how.video_quality = i == 0 ? 10 : 45;
      bytes[i] = fs::file_size(write_video(folder / (std::to_string(i) + extension), how));
    }
    EXPECT_GT(bytes[0], bytes[1]);
  }
}

TEST(Video, PresetsTradeTimeForSize) {
  const TemporaryFolder folder;
  const auto size_with = [&](const std::string& name, const std::string& preset, int compression) {
    SinkOptions how = options({320, 180});
    how.preset = preset;
    how.image.compression = compression;
    return fs::file_size(write_video(folder / name, how));
  };
  EXPECT_GT(size_with("a.mp4", "ultrafast", -1), size_with("b.mp4", "slow", -1));
  EXPECT_EQ(size_with("c.mp4", "veryfast", -1), size_with("d.mp4", "", -1));
  EXPECT_NE(size_with("a.webm", "good", -1), size_with("b.webm", "realtime", -1));
  EXPECT_GT(size_with("a.apng", "", 0), size_with("b.apng", "", -1));
  EXPECT_GT(size_with("c.apng", "", 0), size_with("d.apng", "", 9));
}

TEST(Video, NamesAreTakenLiterally) {
  const TemporaryFolder folder;
  for (const char* name : {"pipe:1.mp4", "-y.mp4", "it's 100% \"$HOME\" `x`;.mp4", "concat:a|b.MP4", "äöü.mkv"}) {
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    write_video(name, options({16, 16}), 2);
    fs::current_path(before);
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  }
  EXPECT_EQ(folder.names().size(), 5U);
}

}  // namespace
}  // namespace morphkit::media
