#pragma once
// One function per picture; samples.cpp makes the pairs.

#include "samples/brush.h"

namespace morphkit::samples {

Canvas paint_woman();   ///< 800 x 1000
Canvas paint_man();     ///< 820 x 1000
Canvas paint_pear();    ///< 640 x 640, transparent around
Canvas paint_bulb();    ///< 640 x 640, transparent around
Canvas paint_lake();    ///< 1280 x 720
Canvas paint_desert();  ///< 960 x 800

}  // namespace morphkit::samples
