#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <functional>
#include <memory>
#include <system_error>

#include "base/atomic_file.h"
#include "base/descriptor.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "morph/media/image_file.h"
#include "morph/media/image_format.h"
#include "morph/media/image_reader.h"
#include "morph/media/metadata.h"
#include "morph/media/pixel_codec.h"
#include "morph/media/webp_codec.h"

namespace morphkit::media {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

constexpr float kLargestHalf = 65504.0F;

constexpr int kMostCompression = 9;

/// libpng's row filters, for "png:filter".
constexpr int kPngAverage = 64, kPngAllFilters = 8 + 16 + 32 + 64 + 128;

/// zlib's usual levels for EXR and TIFF. TIFF: 6 takes 1.6 times as long for 1 % less; EXR hardly differs.
constexpr int kExrLevel = 4, kTiffLevel = 1;

const WritableFormat& format_of(const fs::path& name) {
  if (const WritableFormat* format = writable_format(name)) return *format;
  throw Error(ErrorKind::kUnsupported, name.string(),
              fmt::format("no image format has the extension \"{}\"; use one of {}", name.extension().string(),
                          writable_extensions()));
}

Depth resolve_depth(const fs::path& name, const WritableFormat& format, Depth wanted) {
  if (wanted == Depth::kAuto) return format.depths.front();
  if (std::find(format.depths.begin(), format.depths.end(), wanted) != format.depths.end()) return wanted;
  std::string known;
  for (const Depth depth : format.depths) known += (known.empty() ? "" : " or ") + shown_depth(depth);
  throw Error(ErrorKind::kUnsupported, name.string(),
              fmt::format("{} cannot hold {} samples, only {}", format.shown, shown_depth(wanted), known));
}

void check_compression(const fs::path& name, const WritableFormat& format, int level) {
  if (level < 0) return;
  if (!format.compression) {
    throw Error(ErrorKind::kUnsupported, name.string(),
                fmt::format("{} has no levels of compression; PNG, TIFF and EXR have them", format.shown));
  }
  if (level > kMostCompression) {
    throw Error(ErrorKind::kUnsupported, name.string(),
                fmt::format("compression {} is not in 0 (none) to {} (smallest)", level, kMostCompression));
  }
}

void check_quality(const fs::path& name, int quality) {
  if (quality >= 1 && quality <= 100) return;
  throw Error(ErrorKind::kUnsupported, name.string(), fmt::format("quality {} is not in 1..100", quality));
}

void check_writable(const fs::path& name, const WritableFormat& format, int width, int height) {
  if (width < 1 || height < 1) throw Error(ErrorKind::kUnsupported, name.string(), "the image has no pixels");
  if (width > format.largest_side || height > format.largest_side) {
    throw Error(ErrorKind::kUnsupported, name.string(),
                fmt::format("{} x {} pixels are too many for {}, which holds at most {} on a side", width, height,
                            format.shown, format.largest_side));
  }
}

bool is_opaque(const warp::Image& image) {
  return std::all_of(image.begin(), image.end(), [](const warp::Pixel& pixel) { return pixel[3] == 1.0F; });
}

struct Samples {
  SampleType type = SampleType::kU8;
  int channels = 3;
  Bytes bytes;
};

Samples encode_samples(const warp::Image& image, SampleType type, int channels) {
  const PixelEncoder encoder(type, channels);
  Samples result{type, channels, {}};
  const std::size_t row_bytes =
      static_cast<std::size_t>(image.cols) * static_cast<std::size_t>(channels) * sample_bytes(type);
  result.bytes.resize(row_bytes * static_cast<std::size_t>(image.rows));
  for_rows(image.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      encoder.encode(image[y], image.cols, result.bytes.data() + row_bytes * static_cast<std::size_t>(y));
    }
  });
  return result;
}

/// The largest half float is 65504; larger finite values must not become infinite.
void clamp_to_half(Samples& samples) {
  auto* values = reinterpret_cast<float*>(samples.bytes.data());
  const std::size_t count = samples.bytes.size() / sizeof(float);
  for (std::size_t i = 0; i < count; ++i) {
    if (std::isfinite(values[i])) values[i] = std::clamp(values[i], -kLargestHalf, kLargestHalf);
  }
}

SampleType sample_type(Depth depth) {
  if (depth == Depth::k8) return SampleType::kU8;
  return depth == Depth::k16 ? SampleType::kU16 : SampleType::kFloat;
}

OIIO::TypeDesc stored_type(Depth depth) {
  switch (depth) {
    case Depth::k16:
      return OIIO::TypeDesc::UINT16;
    case Depth::kHalf:
      return OIIO::TypeDesc::HALF;
    case Depth::kFloat:
      return OIIO::TypeDesc::FLOAT;
    default:
      return OIIO::TypeDesc::UINT8;
  }
}

OIIO::TypeDesc given_type(SampleType type) {
  if (type == SampleType::kU8) return OIIO::TypeDesc::UINT8;
  return type == SampleType::kU16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::FLOAT;
}

[[noreturn]] void encoder_failed(const fs::path& name, OIIO::ImageOutput* output) {
  std::string complaint = output != nullptr ? output->geterror() : "";
  const std::string of_thread = OIIO::geterror();
  if (complaint.empty()) complaint = of_thread;
  throw Error(ErrorKind::kFailed, name.string(), fmt::format("the image cannot be encoded ({})", complaint));
}

/// A file in memory with a name. OpenImageIO 2.4 leaves tags out of a TIFF (its width and height) when it writes
/// through a proxy, but not when it writes to a name.
class MemoryFile {
 public:
  explicit MemoryFile(const fs::path& shown) : shown_(shown), descriptor_(::memfd_create("morphkit", MFD_CLOEXEC)) {
    if (descriptor_.get() < 0) fail();
  }

  std::string name() const { return fmt::format("/proc/self/fd/{}", descriptor_.get()); }

  Bytes bytes() const {
    const off_t size = ::lseek(descriptor_.get(), 0, SEEK_END);
    if (size < 0) fail();
    Bytes result(static_cast<std::size_t>(size));
    for (std::size_t done = 0; done < result.size();) {
      const ssize_t got =
          ::pread(descriptor_.get(), result.data() + done, result.size() - done, static_cast<off_t>(done));
      if (got <= 0) fail();
      done += static_cast<std::size_t>(got);
    }
    return result;
  }

 private:
  [[noreturn]] void fail() const {
    throw Error(ErrorKind::kFailed, shown_.string(),
                "no memory for the encoded image: " + std::generic_category().message(errno));
  }

  fs::path shown_;
  Descriptor descriptor_;
};

Bytes encode_with_oiio(const fs::path& name, const std::string& plugin, const OIIO::ImageSpec& spec,
                       OIIO::TypeDesc type, const void* samples) {
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(plugin);
  if (!output) encoder_failed(name, nullptr);
  output->threads(1);
  const auto write = [&](const std::string& target) {
    const auto asks = [](void* question, float) { return (*static_cast<StopQuestion*>(question))(); };
    StopQuestion question = stop_question();
    const bool written =
        output->open(target, spec) && output->write_image(type, samples, OIIO::AutoStride, OIIO::AutoStride,
                                                          OIIO::AutoStride, question ? +asks : nullptr, &question);
    stop_if_asked();
    if (!written || !output->close()) encoder_failed(name, output.get());
  };
  if (plugin == "tiff") {
    const MemoryFile memory(name);
    write(memory.name());
    return memory.bytes();
  }
  Bytes bytes;
  OIIO::Filesystem::IOVecOutput proxy(bytes);
  output->set_ioproxy(&proxy);
  write(name.filename().string());
  return bytes;
}

void set_compression(const WritableFormat& format, int level, OIIO::ImageSpec& spec) {
  if (format.plugin == "targa") spec["compression"] = "rle";
  if (format.plugin == "png") {
    // In photographs nearly all the gain comes from the row filter. zlib's runs and Huffman codes after one fixed
    // filter take half the time of level 2 after the best filter of each row, for files of the same size.
    spec["compression"] = level < 0 ? "rle" : "filtered";
    spec["png:filter"] = level < 0 ? kPngAverage : kPngAllFilters;
    spec["png:compressionLevel"] = level < 0 ? 1 : level;
  }
  if (format.plugin == "tiff") {
    spec["compression"] = level == 0 ? "none" : "zip";
    spec["tiff:zipquality"] = level < 0 ? kTiffLevel : level;
  }
  if (format.plugin == "openexr") {
    spec["compression"] = level == 0 ? "none" : fmt::format("zip:{}", level < 0 ? kExrLevel : level);
  }
}

OIIO::ImageSpec make_spec(const WritableFormat& format, cv::Size size, int channels, Depth depth,
                          const WriteOptions& options) {
  OIIO::ImageSpec spec(size.width, size.height, channels, stored_type(depth));
  // An empty date keeps OpenImageIO from writing today's: the same picture gives the same bytes.
  spec["DateTime"] = "";
  if (options.metadata) options.metadata->apply(spec);
  if (!options.software.empty()) spec["Software"] = options.software;
  const bool is_float = sample_type(depth) == SampleType::kFloat;
  spec["Orientation"] = 1;
  spec["oiio:ColorSpace"] = is_float ? "Linear" : "sRGB";
  // Float files hold premultiplied colour (associated alpha), the others unpremultiplied colour.
  if (!is_float) spec["oiio:UnassociatedAlpha"] = 1;
  set_compression(format, options.compression, spec);
  if (format.plugin == "jpeg") {
    spec["compression"] = fmt::format("jpeg:{}", options.quality);
    spec["jpeg:subsampling"] = "4:4:4";
  }
  return spec;
}

void save(const fs::path& file, bool overwrite, const std::function<Bytes()>& encode) {
  AtomicFile target(file, overwrite);  // first, so that nothing is encoded in vain
  target.write(encode());
  target.commit();
}

}  // namespace

void check_write_options(const fs::path& name, const WriteOptions& options) {
  const WritableFormat& format = format_of(name);
  resolve_depth(name, format, options.depth);
  check_compression(name, format, options.compression);
  check_quality(name, options.quality);
}

Bytes encode_image(const fs::path& name, const warp::Image& image, const WriteOptions& options) {
  check_write_options(name, options);
  const WritableFormat& format = format_of(name);
  const Depth depth = resolve_depth(name, format, options.depth);
  check_writable(name, format, image.cols, image.rows);
  const bool with_alpha = format.alpha && (options.alpha.has_value() ? *options.alpha : !is_opaque(image));
  Samples samples = encode_samples(image, sample_type(depth), with_alpha ? 4 : 3);
  if (depth == Depth::kHalf) clamp_to_half(samples);
  if (format.plugin == "webp") {
    return encode_webp(name, samples.bytes, image.cols, image.rows, samples.channels, options.quality);
  }
  const OIIO::ImageSpec spec = make_spec(format, image.size(), samples.channels, depth, options);
  return encode_with_oiio(name, format.plugin, spec, given_type(samples.type), samples.bytes.data());
}

void write_image(const fs::path& file, const warp::Image& image, const WriteOptions& options) {
  check_write_options(file, options);
  save(file, options.overwrite, [&] { return encode_image(file, image, options); });
}

void write_map(const fs::path& file, const warp::Map& map, bool overwrite) {
  const WritableFormat& format = format_of(file);
  if (format.plugin != "openexr") {
    throw Error(ErrorKind::kUnsupported, file.string(), "a map needs 32-bit float samples; name it .exr");
  }
  check_writable(file, format, map.cols, map.rows);
  const warp::Map packed = map.isContinuous() ? map : warp::Map(map.clone());
  OIIO::ImageSpec spec(map.cols, map.rows, 2, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"R", "G"};
  spec["DateTime"] = "";
  spec["compression"] = "zip";
  save(file, overwrite,
       [&] { return encode_with_oiio(file, format.plugin, spec, OIIO::TypeDesc::FLOAT, packed.data); });
}

}  // namespace morphkit::media
