#include "morph/media/made_from.h"

#include <OpenImageIO/hash.h>
#include <fmt/format.h>

namespace morphkit::media {

std::string digest_of(std::string_view bytes) {
  return fmt::format("{:016x}", OIIO::xxhash::XXH64(bytes.data(), bytes.size(), 0));
}

std::string made_from_mark(std::string_view made_from) {
  return fmt::format("morphkit, from {}", digest_of(made_from));
}

}  // namespace morphkit::media
