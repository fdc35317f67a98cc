#include "morph/media/image_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <string_view>
#include <system_error>

#include "base/error.h"
#include "base/parallel.h"
#include "base/whole_file.h"
#include "morph/media/color_tags.h"
#include "morph/media/guard/exr_check.h"
#include "morph/media/guard/png_check.h"
#include "morph/media/guard/promise_check.h"
#include "morph/media/image_format.h"
#include "morph/media/metadata.h"
#include "morph/media/webp_codec.h"

namespace morphkit::media {
namespace {

namespace fs = std::filesystem;

/// Rows that are read at once: enough for the threads that convert them, small compared to the picture, and more than
/// the 32 rows that EXR packs together.
constexpr int kBandRows = 64;

constexpr int kLastOrientation = 8;
constexpr int kFirstTurned = 5;  // EXIF orientations 5..8 swap width and height

[[noreturn]] void bad_input(const fs::path& file, const std::string& message) {
  throw Error(ErrorKind::kBadInput, file.string(), message);
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

/// OpenImageIO's error messages of the object and of the thread. Both are cleared, so the next file inherits none.
std::string drain(const OIIO::ImageInput* input) {
  std::string text = input != nullptr ? input->geterror() : "";
  const std::string of_thread = OIIO::geterror();
  if (text.empty()) text = of_thread;
  return text;
}

/// Call while an exception is handled: tells lack of memory from damage.
/// @throws Error  that exception, kFailed if memory ran out, or kBadInput.
[[noreturn]] void fail_reading(const fs::path& file, const std::string& format, const OIIO::ImageSpec& spec) {
  const auto out_of_memory = [&]() -> Error {
    constexpr double kBytesPerGb = 1e9;
    const double bytes = static_cast<double>(spec.width) * spec.height * sizeof(warp::Pixel);
    return {
        ErrorKind::kFailed, file.string(),
        fmt::format("not enough memory for {} x {} pixels ({:.1f} GB)", spec.width, spec.height, bytes / kBytesPerGb)};
  };
  try {
    throw;
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw out_of_memory();
  } catch (const cv::Exception& error) {
    if (error.code == cv::Error::StsNoMem) throw out_of_memory();
    bad_input(file, fmt::format("the {} file is damaged ({})", format, error.what()));
  } catch (const std::exception& error) {
    bad_input(file, fmt::format("the {} file is damaged ({})", format, error.what()));
  }
}

std::vector<std::uint8_t> read_bytes(const fs::path& file) {
  const std::string bytes = read_file(file, "picture");
  return {bytes.begin(), bytes.end()};
}

/// Whether an error message after a "successful" read means damage. libtiff and others leave zeros where they could not
/// read. libjpeg fills a truncated picture with gray, but it also reports harmless oddities.
bool tells_damage(const std::string& format, const std::string& complaint) {
  if (format != "jpeg") return !complaint.empty();
  return complaint.find("remature end") != std::string::npos || complaint.find("bad Huffman") != std::string::npos;
}

warp::Image upright(const warp::Image& stored, int orientation) {
  warp::Image turned;
  switch (orientation) {
    case 2:
      cv::flip(stored, turned, 1);
      return turned;
    case 3:
      cv::rotate(stored, turned, cv::ROTATE_180);
      return turned;
    case 4:
      cv::flip(stored, turned, 0);
      return turned;
    case 5:
      cv::transpose(stored, turned);
      return turned;
    case 6:
      cv::rotate(stored, turned, cv::ROTATE_90_CLOCKWISE);
      return turned;
    case 7:
      cv::transpose(stored, turned);
      cv::rotate(turned, turned, cv::ROTATE_180);
      return turned;
    case 8:
      cv::rotate(stored, turned, cv::ROTATE_90_COUNTERCLOCKWISE);
      return turned;
    default:
      return stored;
  }
}

SampleType sample_type(const OIIO::ImageSpec& spec) {
  if (spec.channelformats.empty() && spec.format == OIIO::TypeDesc::UINT8) return SampleType::kU8;
  if (spec.channelformats.empty() && spec.format == OIIO::TypeDesc::UINT16) return SampleType::kU16;
  return SampleType::kFloat;
}

OIIO::TypeDesc oiio_type(SampleType type) {
  if (type == SampleType::kU8) return OIIO::TypeDesc::UINT8;
  return type == SampleType::kU16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::FLOAT;
}

}  // namespace

void set_up_process() {
  OIIO::attribute("threads", 1);
  OIIO::attribute("exr_threads", -1);
  OIIO::attribute("limits:imagesize_MB", 0);
}

ImageReader::ImageReader(const fs::path& file) : file_(file), format_(sniff_format(file)) {
  try {
    if (format_ == "webp") {
      bytes_ = read_bytes(file_);
      const WebpHeader header = webp_header(file_, bytes_);
      spec_ = OIIO::ImageSpec(header.width, header.height, header.has_alpha ? 4 : 3, OIIO::TypeDesc::UINT8);
      spec_["oiio:UnassociatedAlpha"] = 1;
      if (const std::span<const std::uint8_t> icc = webp_profile(bytes_); !icc.empty())
        spec_.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(icc.size())), icc.data());
      spec_["Orientation"] = webp_orientation(bytes_);
    } else {
      open();
    }
  } catch (...) {
    fail_reading(file_, format_, spec_);
  }
  check();
  orientation_ = spec_.get_int_attribute("Orientation", 1);
  if (orientation_ < 1 || orientation_ > kLastOrientation) orientation_ = 1;
  choose_channels();
}

void ImageReader::open() {
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1;
  input_ = OIIO::ImageInput::create(format_);
  if (!input_) {
    drain(nullptr);
    bad_input(file_, fmt::format("is a {} file, which the installed OpenImageIO cannot read", format_));
  }
  input_->threads(1);
  if (format_ == "openexr") check_exr(file_);
  check_promises(file_, format_);
  if (format_ == "png") {
    bytes_ = read_bytes(file_);
    check_png(file_, bytes_);
    memory_ = std::make_unique<OIIO::Filesystem::IOMemReader>(bytes_.data(), bytes_.size());
    input_->set_ioproxy(memory_.get());
  }
  if (!input_->open(file_.string(), spec_, config)) {
    const std::string complaint = drain(input_.get());
    bad_input(file_, fmt::format("the {} file is damaged or cut short ({})", format_,
                                 complaint.empty() ? "no reason given" : first_line(complaint)));
  }
  drain(input_.get());
}

void ImageReader::check() const {
  check_size(file_, spec_.width, spec_.height, spec_.nchannels);
  if (is_display_window()) check_size(file_, spec_.full_width, spec_.full_height, spec_.nchannels);
  if (spec_.deep) throw Error(ErrorKind::kUnsupported, file_.string(), "is a deep image; flatten it first");
  if (spec_.depth > 1)
    bad_input(file_, fmt::format("is a volume of {} slices; only flat images can be read", spec_.depth));
}

/// EXR pictures are as large as their display window; the stored pixels may be more (overscan) or less (a crop).
bool ImageReader::is_display_window() const {
  return format_ == "openexr" && (spec_.x != spec_.full_x || spec_.y != spec_.full_y ||
                                  spec_.width != spec_.full_width || spec_.height != spec_.full_height);
}

void ImageReader::choose_alpha() {
  declared_alpha_ = declared_alpha(file_, format_);
  const auto named = std::find(spec_.channelnames.begin(), spec_.channelnames.end(), "A");
  a_ = named != spec_.channelnames.end() ? static_cast<int>(named - spec_.channelnames.begin()) : spec_.alpha_channel;
  if (a_ >= spec_.nchannels) a_ = -1;
  if (format_ == "targa" && spec_.nchannels == 2) {
    // OpenImageIO calls gray and alpha red and green.
    r_ = g_ = b_ = 0;
    a_ = 1;
  }
  if (declared_alpha_ == DeclaredAlpha::kNone) a_ = -1;
}

/// By name if there are names (a renderer's EXR has many channels), else by count: 1 gray, 2 gray and alpha, 3 RGB.
void ImageReader::choose_channels() {
  const auto find = [&](std::string_view name) {
    const auto found = std::find(spec_.channelnames.begin(), spec_.channelnames.end(), name);
    return found == spec_.channelnames.end() ? -1 : static_cast<int>(found - spec_.channelnames.begin());
  };
  r_ = find("R");
  g_ = find("G");
  b_ = find("B");
  choose_alpha();
  if (r_ < 0 && g_ < 0 && b_ < 0) {
    const int luminance = find("Y");
    const int colors = spec_.nchannels - (a_ >= 0 ? 1 : 0);
    if (luminance >= 0 || colors < 3) {
      const int first_color = a_ == 0 && spec_.nchannels > 1 ? 1 : 0;
      r_ = g_ = b_ = luminance >= 0 ? luminance : first_color;
    } else {
      r_ = 0, g_ = 1, b_ = 2;
    }
  }
  channel_begin_ = spec_.nchannels;
  for (const int channel : {r_, g_, b_, a_}) {
    if (channel < 0) continue;
    channel_begin_ = std::min(channel_begin_, channel);
    channel_end_ = std::max(channel_end_, channel + 1);
  }
}

ColorReading ImageReader::color(ColorSpace space) const {
  return color_reading(spec_, r_ == g_ ? 1 : 3, space);
}

StoredLayout ImageReader::layout(ColorSpace space) const {
  const auto within = [&](int channel) { return channel < 0 ? -1 : channel - channel_begin_; };
  StoredLayout result;
  result.type = sample_type(spec_);
  result.channels = channel_end_ - channel_begin_;
  result.r = within(r_);
  result.g = within(g_);
  result.b = within(b_);
  result.a = within(a_);
  result.color = color(space).conversion;
  // TIFF and TGA have both kinds of alpha; in other files the format decides.
  const bool is_associated_tiff = format_ == "tiff" && spec_.get_int_attribute("oiio:UnassociatedAlpha", 0) != 1;
  if (format_ == "openexr") {
    result.alpha = AlphaKind::kPremultiplied;
  } else if (is_associated_tiff || declared_alpha_ == DeclaredAlpha::kPremultiplied) {
    const bool is_linear = result.color.transfer.kind == Transfer::Kind::kLinear;
    result.alpha = is_linear ? AlphaKind::kPremultiplied : AlphaKind::kStoredAssociated;
  }
  return result;
}

ImageInfo ImageReader::info(ColorSpace space) const {
  ImageInfo result;
  result.file = file_;
  result.format = format_;
  result.width = is_display_window() ? spec_.full_width : spec_.width;
  result.height = is_display_window() ? spec_.full_height : spec_.height;
  if (orientation_ >= kFirstTurned) std::swap(result.width, result.height);
  result.channels = spec_.nchannels;
  result.has_alpha = a_ >= 0;
  result.ignores_alpha = format_ == "targa" && declared_alpha_ == DeclaredAlpha::kNone && spec_.nchannels % 2 == 0;
  result.channel_type = spec_.format.c_str();
  const ColorReading how = color(space);
  result.color_space = how.space;
  result.color_told = how.told;
  result.color_warning = how.warning;
  result.orientation = orientation_;
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file_, error);
  result.bytes = error ? 0 : static_cast<std::int64_t>(size);
  result.metadata = metadata_text(spec_);
  return result;
}

std::shared_ptr<const Metadata> ImageReader::metadata() const {
  return std::make_shared<const Metadata>(spec_);
}

void ImageReader::read_rows(int begin, int end, const OIIO::TypeDesc& type, void* data) {
  const bool done = spec_.tile_width > 0
                        ? input_->read_tiles(0, 0, spec_.x, spec_.x + spec_.width, begin, end, spec_.z, spec_.z + 1,
                                             channel_begin_, channel_end_, type, data)
                        : input_->read_scanlines(0, 0, begin, end, spec_.z, channel_begin_, channel_end_, type, data);
  const std::string complaint = drain(input_.get());
  if (done && !tells_damage(format_, complaint)) return;
  bad_input(file_, fmt::format("the {} file is damaged or cut short: rows {} to {} of {} cannot be read ({})", format_,
                               begin - spec_.y, end - spec_.y - 1, spec_.height,
                               complaint.empty() ? "the data end too early" : first_line(complaint)));
}

warp::Image ImageReader::read_stored(const PixelDecoder& decoder, PixelFaults& faults) {
  const SampleType type = sample_type(spec_);
  const std::size_t row_bytes = static_cast<std::size_t>(spec_.width) *
                                static_cast<std::size_t>(channel_end_ - channel_begin_) * sample_bytes(type);
  const int tile = std::max(spec_.tile_height, 1);
  const int band = (kBandRows + tile - 1) / tile * tile;
  std::vector<std::byte> rows(row_bytes * static_cast<std::size_t>(std::min(band, spec_.height)));
  warp::Image image(spec_.height, spec_.width);
  std::mutex adding;
  for (int top = 0; top < spec_.height; top += band) {
    const int height = std::min(band, spec_.height - top);
    read_rows(spec_.y + top, spec_.y + top + height, oiio_type(type), rows.data());
    for_rows(height, [&](int begin, int end) {
      PixelFaults found;
      for (int y = begin; y < end; ++y) {
        found += decoder.decode(rows.data() + row_bytes * static_cast<std::size_t>(y), spec_.width, image[top + y]);
      }
      const std::scoped_lock lock(adding);
      faults += found;
    });
  }
  return image;
}

warp::Image ImageReader::read_webp(const PixelDecoder& decoder) {
  const std::vector<std::uint8_t> samples = decode_webp(file_, bytes_);
  warp::Image image(spec_.height, spec_.width);
  const std::size_t row_bytes = samples.size() / static_cast<std::size_t>(spec_.height);
  for_rows(spec_.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      decoder.decode(samples.data() + row_bytes * static_cast<std::size_t>(y), spec_.width, image[y]);
    }
  });
  return image;
}

warp::Image ImageReader::to_display_window(const warp::Image& data_window) const {
  if (!is_display_window()) return data_window;
  warp::Image result(spec_.full_height, spec_.full_width, warp::Pixel(0, 0, 0, 0));
  const cv::Rect data(spec_.x - spec_.full_x, spec_.y - spec_.full_y, spec_.width, spec_.height);
  const cv::Rect common = data & cv::Rect(0, 0, result.cols, result.rows);
  if (!common.empty()) data_window(common - data.tl()).copyTo(result(common));
  return result;
}

warp::Image ImageReader::read(ColorSpace space, PixelFaults& faults) {
  try {
    StoredLayout stored = layout(space);
    if (format_ == "webp") stored.channels = 4;  // decode_webp always gives 4
    const PixelDecoder decoder(stored);
    const warp::Image pixels = format_ == "webp" ? read_webp(decoder) : read_stored(decoder, faults);
    return upright(to_display_window(pixels), orientation_);
  } catch (...) {
    fail_reading(file_, format_, spec_);
  }
}

}  // namespace morphkit::media
