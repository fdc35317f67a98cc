// Bends a painted board with two feature lines and writes it as a PPM.
//   link_warp OUT.ppm
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <vector>

#include "warp/field/line_field.h"
#include "warp/image/color.h"
#include "warp/sample/sample.h"

using namespace morphkit::warp;

namespace {

/// A board of 20 px squares. Images are RGBA in linear light, premultiplied by alpha.
Image board(int width, int height) {
  Image image(height, width);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool dark = (x / 20 + y / 20) % 2 == 0;
      image(y, x) = dark ? Pixel(0.05f, 0.08f, 0.2f, 1) : Pixel(0.9f, 0.8f, 0.6f, 1);
    }
  }
  return image;
}

/// A line of the output, and where in the source it comes from. Coordinates are px from the top left corner.
FieldLine feature(Line output, Line source) {
  FieldLine line;
  line.output = output;
  line.targets = {source};
  return line;
}

bool write_ppm(const char* file, const Image& image) {
  std::vector<char> bytes;
  for (const Pixel& pixel : image) {
    for (int c = 0; c < 3; ++c) {
      bytes.push_back(static_cast<char>(static_cast<std::uint8_t>(255 * srgb_from_linear(pixel[c]) + 0.5f)));
    }
  }
  std::ofstream stream(file, std::ios::binary);
  stream << "P6\n" << image.cols << ' ' << image.rows << "\n255\n";
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
  return stream.good();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: link_warp OUT.ppm\n");
    return 2;
  }
  const Image source = board(320, 240);

  // The left edge stays where it is; the line in the middle turns.
  const std::vector<FieldLine> lines = {feature({{20, 20}, {20, 220}}, {{20, 20}, {20, 220}}),
                                        feature({{120, 80}, {220, 160}}, {{110, 120}, {210, 120}})};
  const LineField field(lines, 1);

  // A map says for every output pixel where in the source its colour lies.
  Map map(source.size());
  field.evaluate({0, 0, map.cols, map.rows}, FieldAccuracy::kAdaptive, {&map, 1});
  const Image bent = sample(source, map, {Filter::kArea, Border::kClamp});

  if (write_ppm(argv[1], bent)) return 0;
  std::fprintf(stderr, "cannot write %s\n", argv[1]);
  return 1;
}
