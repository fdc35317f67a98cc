// Bends an image by one pair of lines, with morphkit::warp alone. The pair is a shift by (3, 1), so the result is
// known.
#include <cstdio>

#include "warp/field/line_field.h"
#include "warp/sample/sample.h"

using namespace morphkit::warp;

int main() {
  Image source(24, 32);
  for (int y = 0; y < source.rows; ++y) {
    for (int x = 0; x < source.cols; ++x) source(y, x) = {float(x), float(y), float(x * y), 1};
  }

  FieldLine line;
  line.output = {{5, 5}, {20, 15}};
  line.targets = {{{8, 6}, {23, 16}}};
  const LineField field({&line, 1}, 1);

  Map map(source.size());
  field.evaluate({0, 0, map.cols, map.rows}, FieldAccuracy::kExact, {&map, 1});
  const Image bent = sample(source, map, {Filter::kNearest, Border::kTransparent});

  for (int y = 0; y < bent.rows; ++y) {
    for (int x = 0; x < bent.cols; ++x) {
      const bool inside = x + 3 < source.cols && y + 1 < source.rows;
      if (bent(y, x) == (inside ? source(y + 1, x + 3) : Pixel{})) continue;
      std::printf("pixel (%d, %d) is not the one from (%d, %d)\n", x, y, x + 3, y + 1);
      return 1;
    }
  }
  return 0;
}
