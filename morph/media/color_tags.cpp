#include "morph/media/color_tags.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "base/words.h"

namespace morphkit::media {
namespace {

/// Before PNG had a tag for sRGB, gAMA 1/2.2 marked such files.
constexpr float kGammaOfSrgb = 2.2F;
constexpr float kGammaTolerance = 0.05F;

/// The transfer function that the file states, if we support it. Rec.709 material is shown on sRGB screens as if it
/// were sRGB, and is read in the same way.
std::optional<Transfer> tagged_transfer(const OIIO::ImageSpec& spec) {
  const std::string tag = lower(std::string(spec.get_string_attribute("oiio:ColorSpace")));
  float gamma = spec.get_float_attribute("oiio:Gamma", 0.0F);
  if (gamma == 0.0F && tag.starts_with("gamma")) {
    gamma = std::strtof(tag.c_str() + std::string_view("gamma").size(), nullptr);
  }
  if (tag == "srgb" || tag == "rec709") return Transfer{Transfer::Kind::kSrgb};
  if (tag == "linear" || tag == "lin_srgb" || tag == "scene_linear") return Transfer{Transfer::Kind::kLinear};
  if (!(gamma > 0.1F && gamma < 10.0F)) return std::nullopt;
  if (std::abs(gamma - kGammaOfSrgb) < kGammaTolerance) return Transfer{Transfer::Kind::kSrgb};
  if (gamma == 1.0F) return Transfer{Transfer::Kind::kLinear};
  return Transfer{Transfer::Kind::kGamma, gamma};
}

Transfer transfer_of(const OIIO::ImageSpec& spec, ColorSpace space) {
  if (space == ColorSpace::kSrgb) return {Transfer::Kind::kSrgb};
  if (space == ColorSpace::kLinear) return {Transfer::Kind::kLinear};
  if (const std::optional<Transfer> tagged = tagged_transfer(spec)) return *tagged;
  return {spec.format.is_floating_point() ? Transfer::Kind::kLinear : Transfer::Kind::kSrgb};
}

std::string name_of(const Transfer& transfer) {
  switch (transfer.kind) {
    case Transfer::Kind::kSrgb:
      return "sRGB";
    case Transfer::Kind::kLinear:
      return "linear";
    case Transfer::Kind::kGamma:
      break;
  }
  return fmt::format("gamma {:g}", transfer.gamma);
}

std::span<const std::uint8_t> profile_bytes(const OIIO::ImageSpec& spec) {
  const OIIO::ParamValue* found = spec.find_attribute("ICCProfile");
  if (found == nullptr || found->type().basetype != OIIO::TypeDesc::UINT8) return {};
  return {static_cast<const std::uint8_t*>(found->data()), static_cast<std::size_t>(found->datasize())};
}

void use_profile(std::span<const std::uint8_t> icc, int colors, ColorReading& reading) {
  const Profile profile = read_profile(icc, colors);
  const std::string found =
      lower(profile.name).find("profile") == std::string::npos ? profile.name + " profile" : profile.name;
  if (!profile.problem.empty()) {
    reading.warning =
        fmt::format("{} is not applied, for {}; the picture is read as {}", found, profile.problem, reading.space);
    reading.told = fmt::format("{}, not applied ({}); read as {}", found, profile.problem, reading.space);
  } else if (profile.is_srgb) {
    reading.conversion.transfer = {Transfer::Kind::kSrgb};
    reading.space = "sRGB";
    reading.told = found + ", read as sRGB";
  } else {
    reading.conversion.profile = profile.transform;
    reading.space = profile.name;
    reading.told = found + ", converted";
  }
}

}  // namespace

ColorReading color_reading(const OIIO::ImageSpec& spec, int colors, ColorSpace space) {
  ColorReading result;
  result.conversion.transfer = transfer_of(spec, space);
  result.space = name_of(result.conversion.transfer);
  result.told = "read as " + result.space;
  const std::span<const std::uint8_t> icc = profile_bytes(spec);
  if (space == ColorSpace::kAuto && !icc.empty()) use_profile(icc, colors, result);
  return result;
}

}  // namespace morphkit::media
