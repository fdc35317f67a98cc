#include "morph/media/webp_codec.h"

#include <fmt/format.h>
#include <webp/decode.h>
#include <webp/encode.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include "base/error.h"
#include "base/stop.h"
#include "morph/media/exif_orientation.h"

namespace morphkit::media {
namespace {

constexpr int kLossless = 100;
constexpr int kLosslessEffort = 4;  // 0..9 of libwebp; above, twice the time for a few per cent
constexpr int kChannels = 4;

WebPBitstreamFeatures features_of(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
  WebPBitstreamFeatures features;
  const VP8StatusCode status = WebPGetFeatures(bytes.data(), bytes.size(), &features);
  if (status != VP8_STATUS_OK) {
    throw Error(ErrorKind::kBadInput, file.string(),
                status == VP8_STATUS_NOT_ENOUGH_DATA ? "the WebP file is cut short" : "the WebP file is damaged");
  }
  if (features.has_animation != 0) {
    throw Error(ErrorKind::kUnsupported, file.string(), "is an animated WebP; only stills can be read");
  }
  return features;
}

/// The data of the first chunk of that name; empty if there is none.
/// RIFF: a header of 12 bytes, then chunks of a name, a size (little endian) and the data, padded to an even size.
std::span<const std::uint8_t> find_chunk(std::span<const std::uint8_t> bytes, std::string_view name) {
  constexpr std::size_t kFileHeader = 12, kChunkHeader = 8;
  for (std::size_t at = kFileHeader; at + kChunkHeader <= bytes.size();) {
    const auto chunk = bytes.subspan(at);
    const std::size_t size = chunk[4] | chunk[5] << 8U | chunk[6] << 16U | static_cast<std::size_t>(chunk[7]) << 24U;
    if (size > chunk.size() - kChunkHeader) return {};
    if (std::equal(name.begin(), name.end(), chunk.begin())) return chunk.subspan(kChunkHeader, size);
    at += kChunkHeader + size + size % 2;
  }
  return {};
}

}  // namespace

WebpHeader webp_header(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
  const WebPBitstreamFeatures features = features_of(file, bytes);
  return {features.width, features.height, features.has_alpha != 0};
}

std::span<const std::uint8_t> webp_profile(std::span<const std::uint8_t> bytes) {
  return find_chunk(bytes, "ICCP");
}

int webp_orientation(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kOfJpeg("Exif\0\0", 6);  // some writers put it before the data, as JPEG does
  std::span<const std::uint8_t> exif = find_chunk(bytes, "EXIF");
  if (exif.size() >= kOfJpeg.size() && std::equal(kOfJpeg.begin(), kOfJpeg.end(), exif.begin()))
    exif = exif.subspan(kOfJpeg.size());
  return exif_orientation(exif).value_or(1);
}

std::vector<std::uint8_t> decode_webp(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
  const WebPBitstreamFeatures features = features_of(file, bytes);
  const std::size_t stride = static_cast<std::size_t>(features.width) * kChannels;
  std::vector<std::uint8_t> samples(stride * static_cast<std::size_t>(features.height));
  if (WebPDecodeRGBAInto(bytes.data(), bytes.size(), samples.data(), samples.size(), static_cast<int>(stride)) ==
      nullptr) {
    throw Error(ErrorKind::kBadInput, file.string(), "the WebP file is damaged or cut short");
  }
  return samples;
}

std::vector<std::uint8_t> encode_webp(const std::filesystem::path& file, std::span<const std::uint8_t> samples,
                                      int width, int height, int channels, int quality) {
  WebPConfig config;
  bool ok = WebPConfigPreset(&config, WEBP_PRESET_PHOTO, static_cast<float>(quality)) != 0;
  if (quality >= kLossless) {
    ok = ok && WebPConfigLosslessPreset(&config, kLosslessEffort) != 0;
    config.exact = 1;  // keep the colour of transparent pixels
  } else {
    config.use_sharp_yuv = 1;
  }
  WebPMemoryWriter writer;
  WebPMemoryWriterInit(&writer);
  WebPPicture picture;
  ok = ok && WebPPictureInit(&picture) != 0;
  const std::unique_ptr<WebPPicture, void (*)(WebPPicture*)> picture_owner(&picture, &WebPPictureFree);
  const std::unique_ptr<WebPMemoryWriter, void (*)(WebPMemoryWriter*)> writer_owner(&writer, &WebPMemoryWriterClear);
  picture.use_argb = 1;
  picture.width = width;
  picture.height = height;
  picture.writer = WebPMemoryWrite;
  picture.custom_ptr = &writer;
  picture.progress_hook = [](int, const WebPPicture*) { return stop_question() && stop_question()() ? 0 : 1; };
  const int stride = width * channels;
  ok = ok && (channels == kChannels ? WebPPictureImportRGBA(&picture, samples.data(), stride)
                                    : WebPPictureImportRGB(&picture, samples.data(), stride)) != 0;
  if (!ok || WebPEncode(&config, &picture) == 0) {
    stop_if_asked();
    throw Error(ErrorKind::kFailed, file.string(),
                fmt::format("the WebP encoder gave up (libwebp's error {})", static_cast<int>(picture.error_code)));
  }
  return {writer.mem, writer.mem + writer.size};
}

}  // namespace morphkit::media
