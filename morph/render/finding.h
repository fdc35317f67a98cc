#pragma once
// What is wrong with a morph at a moment.

#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

namespace morphkit::render {

struct Finding {
  enum class Kind {
    kCrossing,       ///< two lines cross: pixels there are pulled two ways
    kTwins,          ///< two lines lie almost on each other but lead to different places
    kOutsideImage,   ///< a mark lies outside its picture
    kOutsideCanvas,  ///< a feature lies wholly outside the canvas: the fit crops it
    kFold,           ///< the map turns over: a piece of the picture is drawn mirrored or lost
    kMeshFold,       ///< a vertex of the mesh is out of order
    kBottleneck      ///< between the passes of the mesh warp the picture is squeezed
  };
  Kind kind = Kind::kCrossing;
  bool warning = true;                ///< false: a note, information, not a defect
  std::string where;                  ///< "source", "destination" or "in between"
  std::vector<std::string> features;  ///< ids concerned; for a fold the nearest ones
  std::vector<cv::Point> vertices;    ///< of the mesh concerned, (column, row)
  cv::Point2d position;               ///< px: of that side's picture, or of the canvas for "in between" and folds
  double t = 0;                       ///< progress at that moment; for a picture, the one at which it is whole
  int count = 0;                      ///< fold: connected regions; mesh fold, bottleneck: vertices out of order
  std::int64_t area_px = 0;           ///< fold: canvas pixels, all regions
  double area_lost = 0;               ///< bottleneck: see warp::MeshWarp::area_lost
  std::string message;                ///< one sentence for people
};

/// Finding::where of a problem between the pictures.
inline constexpr const char* kInBetween = "in between";

/// The name of a kind in reports: "crossing", "twins", "outside-image", "outside-canvas", "fold",
/// "mesh-fold", "bottleneck".
const char* name_of(Finding::Kind kind);

}  // namespace morphkit::render
