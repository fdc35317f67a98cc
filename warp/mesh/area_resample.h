#pragma once
// Resamples a line of pixels onto another line by area: the inner loop of both mesh passes.

#include <span>

#include "warp/image/image.h"

namespace morphkit::warp {

/// The source intervals of the pixels of an output line. Output pixel k is the mean of the source line over
/// [edges[k], edges[k + 1]], times the part of [k, k + 1] that lies in [begin, end].
struct LineEdges {
  std::span<const double>
      edges;  ///< one more than output pixels; source px in [0, source pixels]; a falling interval is empty
  double begin = 0, end = 0;  ///< the covered part of the output line, px; pixels outside are transparent black
};

/// Resamples `source` into `out`. The running sum of the source line is interpolated by Catmull-Rom between pixel edges
/// (the edge pixels go on beyond the ends), so the reconstruction is continuous and keeps the mean of every source
/// pixel. An interval shorter than 1/1000 px counts as 1/1000 px. Alpha is clamped to [0, 1].
/// Source pixels that are not finite give finite but arbitrary colours up to three pixels around.
/// Accuracy: class T against reference_resample_line, kResampleTolerance of the largest source magnitude; equal to the
/// source bit for bit where edges are consecutive whole numbers. Cost: O(source + out). Thread-safe.
/// @pre source not empty; edges.size() == out.size() + 1.
void resample_line(std::span<const Pixel> source, const LineEdges& line, std::span<Pixel> out) noexcept;

/// The specification: the same in plain scalar double arithmetic.
void reference_resample_line(std::span<const Pixel> source, const LineEdges& line, std::span<Pixel> out) noexcept;

inline constexpr double kResampleTolerance = 4e-6;

}  // namespace morphkit::warp
