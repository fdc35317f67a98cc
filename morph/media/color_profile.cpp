#include "morph/media/color_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

#include "warp/image/color.h"

#if MORPHKIT_LCMS
#include <lcms2.h>
#endif

namespace morphkit::media {

#if MORPHKIT_LCMS
namespace {

using ProfileHandle = std::unique_ptr<void, decltype([](cmsHPROFILE profile) { cmsCloseProfile(profile); })>;
using TransformHandle = std::unique_ptr<void, decltype([](cmsHTRANSFORM transform) { cmsDeleteTransform(transform); })>;
using CurveHandle = std::unique_ptr<cmsToneCurve, decltype([](cmsToneCurve* curve) { cmsFreeToneCurve(curve); })>;

constexpr int kGray = 1, kRgb = 3, kCmyk = 4;

/// Little CMS measures ink in per cent.
constexpr float kFullInk = 100.0F;

/// A profile counts as sRGB if all of kProbes values per channel come out right within half a step of 8 bits or, near
/// black where steps are small, within kLinearTolerance: writers round curves and primaries.
constexpr int kProbes = 17;
constexpr float kStoredTolerance = 0.5F / 255.0F;
constexpr float kLinearTolerance = 5e-4F;

constexpr cmsUInt32Number pixel_format(cmsUInt32Number space, cmsUInt32Number channels) {
  return FLOAT_SH(1) | COLORSPACE_SH(space) | CHANNELS_SH(channels) | EXTRA_SH(4 - channels) | BYTES_SH(4);
}

ProfileHandle linear_rec709() {
  const cmsCIExyY white = {0.3127, 0.3290, 1.0};
  const cmsCIExyYTRIPLE primaries = {{0.64, 0.33, 1.0}, {0.30, 0.60, 1.0}, {0.15, 0.06, 1.0}};
  const CurveHandle line(cmsBuildGamma(nullptr, 1.0));
  const std::array<cmsToneCurve*, 3> curves = {line.get(), line.get(), line.get()};
  return ProfileHandle(cmsCreateRGBProfile(&white, &primaries, curves.data()));
}

class LcmsTransform final : public ProfileTransform {
 public:
  LcmsTransform(TransformHandle transform, bool gray_as_rgb, bool ink)
      : transform_(std::move(transform)), gray_as_rgb_(gray_as_rgb), ink_(ink) {}

  void apply(std::span<warp::Pixel> pixels) const noexcept override {
    if (gray_as_rgb_)
      for (warp::Pixel& pixel : pixels) pixel[1] = pixel[2] = pixel[0];
    if (ink_)
      for (warp::Pixel& pixel : pixels) pixel *= kFullInk;
    cmsDoTransform(transform_.get(), pixels.data(), pixels.data(), static_cast<cmsUInt32Number>(pixels.size()));
  }

 private:
  TransformHandle transform_;
  bool gray_as_rgb_, ink_;
};

std::string name_of(cmsHPROFILE profile) {
  std::array<char, 256> text{};
  cmsGetProfileInfoASCII(profile, cmsInfoDescription, "en", "US", text.data(), text.size());
  text.back() = '\0';
  std::istringstream words(text.data());
  std::string name, word;
  while (words >> word) name += (name.empty() ? "" : " ") + word;
  return name;
}

std::string shown(cmsColorSpaceSignature space) {
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8)
    text += static_cast<char>((static_cast<unsigned>(space) >> shift) & 0xFF);
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

/// Whether a transform gives what the sRGB curve gives, on a grid of the cube (of the gray axis).
bool gives_srgb(const ProfileTransform& transform, bool gray) {
  std::vector<warp::Pixel> probes;
  const auto value = [](int i) { return static_cast<float>(i) / (kProbes - 1); };
  for (int r = 0; r < kProbes; ++r) {
    for (int g = 0; g < (gray ? 1 : kProbes); ++g) {
      for (int b = 0; b < (gray ? 1 : kProbes); ++b) {
        probes.emplace_back(value(r), value(gray ? r : g), value(gray ? r : b), 1.0F);
      }
    }
  }
  std::vector<warp::Pixel> converted = probes;
  transform.apply(converted);
  for (std::size_t i = 0; i < probes.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const float linear = converted[i][c], stored = probes[i][c];
      if (!(std::abs(linear - warp::linear_from_srgb(stored)) <= kLinearTolerance) &&
          !(std::abs(warp::srgb_from_linear(linear) - stored) <= kStoredTolerance)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

Profile read_profile(std::span<const std::uint8_t> icc, int colors) {
  Profile result{fmt::format("ICC profile of {} bytes", icc.size()), "", false, nullptr};
  const ProfileHandle profile(cmsOpenProfileFromMem(icc.data(), static_cast<cmsUInt32Number>(icc.size())));
  if (!profile) {
    result.problem = "it is damaged";
    return result;
  }
  if (const std::string name = name_of(profile.get()); !name.empty()) result.name = name;

  const cmsColorSpaceSignature space = cmsGetColorSpace(profile.get());
  const bool gray_as_rgb = colors == kGray && space == cmsSigRgbData;
  cmsUInt32Number format = 0;
  if (space == cmsSigRgbData && (colors == kRgb || gray_as_rgb)) format = pixel_format(PT_RGB, kRgb);
  if (space == cmsSigGrayData && colors == kGray) format = pixel_format(PT_GRAY, kGray);
  if (space == cmsSigCmykData && colors == kCmyk) format = pixel_format(PT_CMYK, kCmyk);
  if (format == 0) {
    result.problem = fmt::format("it is for {} and the picture has {} colour channel{}", shown(space), colors,
                                 colors == 1 ? "" : "s");
    return result;
  }
  const ProfileHandle working = linear_rec709();
  TransformHandle transform(cmsCreateTransform(profile.get(), format, working.get(), pixel_format(PT_RGB, kRgb),
                                               INTENT_RELATIVE_COLORIMETRIC,
                                               cmsFLAGS_NOCACHE | cmsFLAGS_BLACKPOINTCOMPENSATION));
  if (!transform) {
    result.problem = "it is damaged or of a kind that Little CMS cannot apply";
    return result;
  }
  auto made = std::make_shared<const LcmsTransform>(std::move(transform), gray_as_rgb, colors == kCmyk);
  result.is_srgb = colors != kCmyk && gives_srgb(*made, colors == kGray);
  if (!result.is_srgb) result.transform = std::move(made);
  return result;
}

#else

Profile read_profile(std::span<const std::uint8_t> icc, int) {
  return {fmt::format("ICC profile of {} bytes", icc.size()), "morphkit was built without Little CMS", false, nullptr};
}

#endif

}  // namespace morphkit::media
