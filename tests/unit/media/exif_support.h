#pragma once
// Exif data made by hand.

#include "tests/support/temporary_folder.h"

namespace morphkit::test {

/// A TIFF header and a directory with one entry, the orientation.
inline Bytes exif_saying(int orientation, bool is_big) {
  Bytes bytes = {0, 0};
  bytes[0] = bytes[1] = is_big ? 'M' : 'I';
  const auto add = [&](unsigned value, int size) {
    for (int i = 0; i < size; ++i)
      bytes.push_back(static_cast<std::uint8_t>(value >> (8 * (is_big ? size - 1 - i : i))));
  };
  add(42, 2);
  add(8, 4);       // where the directory is
  add(1, 2);       // entries
  add(0x0112, 2);  // the tag of the orientation
  add(3, 2);       // a short
  add(1, 4);       // one of them
  add(static_cast<unsigned>(orientation), 2);
  add(0, 2);
  add(0, 4);  // no other directory
  return bytes;
}

}  // namespace morphkit::test
