#pragma once
// The document: pictures, what corresponds to what, how the change is timed, and what comes out.
// A plain value. Only morph/project knows its JSON form (docs/project-file.md).

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include <opencv2/core/types.hpp>

#include "morph/motion/curve.h"
#include "morph/motion/easing.h"
#include "warp/field/line_field.h"
#include "warp/mesh/mesh_warp.h"
#include "warp/sample/sample.h"

namespace morphkit::project {

/// How an in-between line is formed.
enum class Between {
  kEndpoints,  ///< each end moves straight; a line that turns shrinks meanwhile (the paper)
  kCentre      ///< centre and length move straight, the angle turns
};

/// Positions, px of the picture that they lie on.
using Points = std::vector<cv::Point2d>;

/// Index of a picture in Project::pictures; its places in features and meshes have the same index.
using SideIndex = std::size_t;
inline constexpr SideIndex kSource = 0, kDestination = 1;

/// How a feature pulls. May be set per project, per group and per feature; the nearest one given wins.
struct Pull {
  std::optional<double> a, b, p;  ///< warp::LineWeight
  std::optional<warp::LineScale> scale;
  std::optional<Between> between;
  std::optional<double> turns;  ///< whole extra turns on the way, kCentre only; positive is clockwise on screen
  bool operator==(const Pull&) const = default;
};

/// When a feature or a vertex moves and dissolves. Set and inherited as Pull is.
struct Pace {
  std::optional<motion::Timing> shape;
  std::optional<motion::Timing> dissolve;
  bool operator==(const Pace&) const = default;
};

/// Two ends.
struct Line {
  bool operator==(const Line&) const = default;
};

/// One position.
struct Point {
  bool operator==(const Point&) const = default;
};

/// As many points as `kind` needs; a side may have another number of points than its partner.
struct Curve {
  motion::CurveKind kind = motion::CurveKind::kCatmullRom;
  bool closed = false;
  bool operator==(const Curve&) const = default;
};

using Mark = std::variant<Line, Point, Curve>;

/// What corresponds to what: one mark on every picture.
struct Feature {
  std::string id;     ///< unique, not empty
  std::string group;  ///< id of a group, or empty
  Mark mark;
  std::vector<Points> places = std::vector<Points>(2);  ///< one per picture, in the order of the pictures
  Pull pull;
  Pace pace;
  bool operator==(const Feature&) const = default;
};

struct Group {
  std::string id;
  Pull pull;
  Pace pace;
  bool operator==(const Group&) const = default;
};

struct Picture {
  std::string id;
  std::filesystem::path image;  ///< as written; relative paths resolve against the project file
  std::string colorspace;       ///< empty: from the file; "srgb" | "linear"
  bool operator==(const Picture&) const = default;
};

/// Vertices of the mesh that take the timing of a group.
struct MeshGroup {
  std::string group;                ///< id of a group
  std::vector<cv::Point> vertices;  ///< (column, row); a vertex is in one group at most
  bool operator==(const MeshGroup&) const = default;
};

/// A grid on every picture, vertex to vertex, row by row, in pixels of the image of each side.
struct Mesh {
  int columns = 0, rows = 0;                              ///< vertices in a row and in a column, >= 2
  std::vector<Points> vertices = std::vector<Points>(2);  ///< per picture columns * rows; none: evenly spaced over it
  std::vector<MeshGroup> groups;
  bool operator==(const Mesh&) const = default;
};

/// Feature lines pull (Beier and Neely).
struct LinesMethod {
  static constexpr std::string_view kName = "lines";
  static constexpr bool kPulls = true;    ///< uses "a", "b", ... of "warp", see Pull
  static constexpr bool kFilters = true;  ///< uses "filter" of "warp"

  warp::FieldAccuracy field = warp::FieldAccuracy::kAdaptive;
  bool operator==(const LinesMethod&) const = default;
};

/// The mesh, in two passes, which average what they cover.
struct MeshMethod {
  static constexpr std::string_view kName = "mesh";
  static constexpr bool kPulls = false;
  static constexpr bool kFilters = false;

  warp::MeshSpline spline = warp::MeshSpline::kMonotone;
  warp::PassOrder order = warp::PassOrder::kAuto;
  bool operator==(const MeshMethod&) const = default;
};

/// How space is bent, with the settings of that method alone: what renders sees this, not Warp. To add a method: its
/// settings here, its keys in describe.h, its plan in render/warper.cpp.
using Method = std::variant<LinesMethod, MeshMethod>;

/// In the order of Method.
enum class MethodName { kLines, kMesh };

template <typename>
struct AllOf;
template <typename... T>
struct AllOf<std::variant<T...>> {
  using Tuple = std::tuple<T...>;
};

/// What the document says, for every method: also what the present one does not use (see unused_settings).
struct Warp {
  std::optional<MethodName> method;  ///< nothing: see method_name_of
  AllOf<Method>::Tuple settings;     ///< of every method
  warp::Filter filter = warp::Filter::kArea;
  /// nullopt: clamp if the picture covers the canvas, else transparent.
  std::optional<warp::Border> border;

  /// The settings of one method.
  template <typename T>
  T& of() {
    return std::get<T>(settings);
  }
  template <typename T>
  const T& of() const {
    return std::get<T>(settings);
  }
  bool operator==(const Warp&) const = default;
};

enum class Blend {
  kLinear,  ///< mixes light
  kDisplay  ///< mixes display-referred (sRGB) values, the look of old tools
};

enum class Fit { kContain, kCover, kStretch, kNone };

/// Unpremultiplied display-referred sRGB and alpha, each in [0, 1].
struct Color {
  double r = 0, g = 0, b = 0, a = 0;
  bool operator==(const Color&) const = default;
};

/// The background: a colour (alpha 0: transparency) or an image, placed with `cover`.
using Background = std::variant<Color, std::filesystem::path>;

/// Frames per second as a fraction; terms of at least 1.
struct Rate {
  int num = 24, den = 1;
  bool operator==(const Rate&) const = default;
};

/// "24", "25/2", or a decimal like "29.97", which means the exact rate of video (30000/1001).
/// @return nullopt if it is not a valid rate.
std::optional<Rate> parse_rate(const std::string& text);

struct Output {
  std::optional<cv::Size> size;  ///< px; nothing: the size of the source image
  Fit fit = Fit::kCover;
  int frames = 48;  ///< >= 1
  int start = 1;    ///< number of the first frame
  Rate fps;
  Background background = Color{};
  bool operator==(const Output&) const = default;
};

/// The whole document. Defaults at the end of the chain: a = 1, b = 2, p = 0, along, endpoints, 0 turns; linear shape
/// and dissolve.
struct Project {
  std::vector<Picture> pictures{{"source", {}, {}}, {"destination", {}, {}}};
  std::vector<Feature> features;
  std::vector<Group> groups;
  std::optional<Mesh> mesh;
  Warp warp;
  Pull pull;  ///< "warp" (a, b, p, scale, between, turns) of the project
  Pace pace;  ///< "transition" (shape, dissolve)
  Blend blend = Blend::kLinear;
  Output output;

  std::filesystem::path file;  ///< where it was loaded from; empty for one made in memory

  /// The text it was loaded from, so that saving keeps order, number spelling and explicit defaults.
  std::shared_ptr<const std::string> original;
};

/// Whether both have equal values; file and spelling do not count.
bool same_document(const Project& a, const Project& b);

/// The method of the project: its own if set; else the mesh if it has a mesh and no features, else lines.
MethodName method_name_of(const Project& project);

/// That method with its settings.
Method method_of(const Project& project);

/// A sentence for each setting of the document that its method does not use, in the order of the document.
std::vector<std::string> unused_settings(const Project& project);

/// A path of the document (an image), relative to the current directory.
std::filesystem::path resolve(const Project& project, const std::filesystem::path& path);

/// What applies to `feature`, resolved through its group and the project to the defaults: no member is empty.
Pull effective_pull(const Project& project, const Feature& feature);
Pace effective_pace(const Project& project, const Feature& feature);

/// What applies to members of the group `id` (empty: of none), resolved likewise.
Pull effective_pull(const Project& project, const std::string& group);
Pace effective_pace(const Project& project, const std::string& group);

/// The settings of the project itself, resolved to the defaults.
Pull effective_pull(const Project& project);
Pace effective_pace(const Project& project);

/// Reads and validates a project.
/// @throws Error kIo if it cannot be read, kBadInput naming file and JSON pointer (syntax errors: line and column)
///         otherwise.
Project load(const std::filesystem::path& file);

/// The same from text; `name` stands for the file in messages and relative paths resolve against its folder.
Project parse(const std::string& text, const std::filesystem::path& name);

/// The document as text that `parse` reads back as an equal document. With an `original`, only changed values are
/// written anew: order, spelling, explicit defaults and spacing of the rest stay. Without one, defaults are left out.
/// @pre `parse` accepts the values. @throws std::invalid_argument on a number that is not finite, Error kBadInput on a
/// name that is not UTF-8.
std::string to_text(const Project& project);

/// Writes to_text atomically (temporary name, sync, rename). A symbolic link is followed.
/// @throws Error kIo, also if the file exists and `overwrite` is false; the file is then what it was before.
void save(const Project& project, const std::filesystem::path& file, bool overwrite = true);

/// Loads only the correspondences into `project`. The file is a project, or just {"morphkit": 1, "features": [...],
/// "mesh": {...}, "groups": [...]} with at least "features" or "mesh". Images and output of `project` stay; "warp" and
/// "transition" are taken if the file has them. For `morph A B --features F`.
/// @throws Error as load; `project` is then unchanged.
void load_features(Project& project, const std::filesystem::path& file);

/// The JSON Schema (2020-12); tests compare the loader with it.
std::string schema_text();

}  // namespace morphkit::project
