#pragma once
// Events of the mouse, and requests to the editor.

#include <opencv2/core/types.hpp>

namespace morphkit::edit {

struct Mouse {
  enum class What { kMove, kPress, kRelease, kDoubleClick, kWheel };
  enum class Button { kNone, kLeft, kMiddle, kRight };
  What what = What::kMove;
  Button button = Button::kNone;
  cv::Point position;  ///< canvas px; may lie outside
  bool shift = false, ctrl = false, alt = false;
  double notches = 0;  ///< wheel; positive: away from the user, which zooms in
};

/// What only the editor can do.
enum class EditorRequest { kSave, kClose };

}  // namespace morphkit::edit
