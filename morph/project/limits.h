#pragma once
// The limits of the loader: far above any real project, but low enough to keep hostile files cheap.
// The same figures stand in schema_text(), which a test compares, and in docs/project-file.md.

#include <cstddef>

namespace morphkit::project {

inline constexpr std::size_t kMaxFeatures = 100'000;
inline constexpr std::size_t kMaxPoints = 100'000;  ///< of one side of a curve; also keys of an easing
inline constexpr int kMaxMeshSize = 1'000;          ///< vertices, each axis of the mesh
inline constexpr int kMaxMeshVertices = 500'000;    ///< of one side; both stay below json::kMaxValues
inline constexpr double kMaxCoordinate = 1e6;       ///< px
inline constexpr int kMaxSize = 65'536;             ///< px, each axis of the output
inline constexpr double kMaxArea = 1 << 30;         ///< px
inline constexpr int kMaxFrames = 10'000'000;
inline constexpr int kMaxStart = 1'000'000'000;
inline constexpr int kMaxFps = 1'000;
inline constexpr int kMaxFpsTerm = 1'000'000;  ///< numerator and denominator
inline constexpr int kMaxTurns = 1'000;
inline constexpr double kMaxFalloff = 8;  ///< b

}  // namespace morphkit::project
