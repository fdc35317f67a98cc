#pragma once
// WebP files with chunks of our own.

#include <webp/encode.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core/types.hpp>

#include "tests/support/temporary_folder.h"

namespace morphkit::test {

/// A chunk of RIFF, padded to an even size.
inline Bytes riff_chunk(const std::string& name, const Bytes& data) {
  Bytes result(name.begin(), name.end());
  for (unsigned shift = 0; shift < 32; shift += 8) result.push_back(static_cast<std::uint8_t>(data.size() >> shift));
  result.insert(result.end(), data.begin(), data.end());
  if (data.size() % 2 == 1) result.push_back(0);
  return result;
}

/// A lossless file in the extended format. @param rgb  8 bits. @param chunks  names and data, before the picture.
inline void write_webp(const std::filesystem::path& file, cv::Size size, const Bytes& rgb,
                       const std::vector<std::pair<std::string, Bytes>>& chunks) {
  constexpr std::size_t kRiffHeader = 12;
  std::uint8_t* encoded = nullptr;
  const std::size_t bytes = WebPEncodeLosslessRGB(rgb.data(), size.width, size.height, size.width * 3, &encoded);
  std::uint8_t flags = 0;
  for (const auto& [name, data] : chunks)
    flags = static_cast<std::uint8_t>(flags | (name == "ICCP" ? 0x20 : name == "EXIF" ? 0x08 : 0));
  const auto low = [](int extent) { return static_cast<std::uint8_t>(extent - 1); };
  Bytes body = {'W', 'E', 'B', 'P'};
  const auto add = [&](const Bytes& chunk) { body.insert(body.end(), chunk.begin(), chunk.end()); };
  add(riff_chunk("VP8X", {flags, 0, 0, 0, low(size.width), 0, 0, low(size.height), 0, 0}));
  for (const auto& [name, data] : chunks) add(riff_chunk(name, data));
  body.insert(body.end(), encoded + kRiffHeader, encoded + bytes);
  WebPFree(encoded);
  write_bytes(file, riff_chunk("RIFF", body));
}

}  // namespace morphkit::test
