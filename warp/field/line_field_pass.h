#pragma once
// Internal to the Highway kernel of LineField. A pass handles one target or a pair; each has its own source, for each
// takes the compiler a long time.

#include "warp/field/line_field_tables.h"

namespace morphkit::warp::detail {

/// Where a pass writes.
struct FieldOutput {
  std::span<Map> positions;
  cv::Mat1f* values;  ///< null: not asked for
  cv::Rect area;      ///< the area of the maps
};

/// The targets `first` and `first` + 1 over the area, and the values if `with_values`.
/// @return the number of pixels taken from the reference.
int simd_pair(const FieldTables& tables, FieldAccuracy accuracy, int first, bool with_values,
              const FieldOutput& output);

}  // namespace morphkit::warp::detail
