#include "morph/render/check.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "base/stop.h"

namespace morphkit::render {
namespace {

using Kind = Finding::Kind;

/// How bad it is, compared with the same problem at another moment.
std::pair<double, double> severity(const Finding& finding) {
  switch (finding.kind) {
    case Kind::kFold:
      return {static_cast<double>(finding.area_px), 0};
    case Kind::kMeshFold:
    case Kind::kBottleneck:
      return {finding.count, finding.area_lost};
    default:
      return {0, 0};
  }
}

/// Lines that move past each other cross somewhere in between: only crossings half way are reported.
bool is_reported(const Finding& finding) {
  return finding.kind != Kind::kCrossing || finding.where != kInBetween || finding.t == 0.5;
}

/// The place of a finding in the report: by kind, then by picture, in between last.
std::pair<int, SideIndex> rank(const Finding& finding, std::size_t sides) {
  SideIndex side = 0;
  while (side < sides && finding.where != name_of(side)) ++side;
  switch (finding.kind) {
    case Kind::kCrossing:
      return {0, side};
    case Kind::kTwins:
      return {1, 0};
    case Kind::kOutsideImage:
    case Kind::kOutsideCanvas:
      return {2, 0};
    case Kind::kMeshFold:
      return {3, side};
    case Kind::kBottleneck:
      return {4, side};
    case Kind::kFold:
      break;
  }
  return {5, side};
}

}  // namespace

std::vector<Finding> check(const Renderer& renderer) {
  std::vector<Finding> findings;
  std::map<std::tuple<Kind, std::string, std::vector<std::string>>, std::size_t> known;
  for (const double t : kMoments) {
    stop_if_asked();
    for (Finding& finding : renderer.warper(renderer.clock().at(t))->problems()) {
      if (!is_reported(finding)) continue;
      // The marks nearest to a fold change over time.
      const auto features = finding.kind == Kind::kFold ? std::vector<std::string>() : finding.features;
      const auto [place, is_new] = known.try_emplace({finding.kind, finding.where, features}, findings.size());
      if (is_new) {
        findings.push_back(std::move(finding));
      } else if (severity(finding) > severity(findings[place->second])) {
        findings[place->second] = std::move(finding);
      }
    }
  }
  const std::size_t sides = renderer.stage().sides.size();
  std::ranges::stable_sort(findings, {}, [&](const Finding& finding) { return rank(finding, sides); });
  return findings;
}

}  // namespace morphkit::render
