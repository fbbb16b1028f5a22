#pragma once

#include "verify/check_list.hpp"

namespace reliefbench {

/// What every technique must do, whatever it promises. Each adds its checks to the list.

/// Whether the device can run the technique at all. One that cannot is no failure: the only check says why it was
/// skipped.
bool check_supported(CheckList& list);

/// Both compilations of every stage. Returns whether the others can be run.
bool check_compiles(CheckList& list);

/// The defaults, and with each boolean and choice set to each of its other values: the timed compilation draws what the
/// probed one reports, and hits are finite, in range, and at the depth and distance that their coordinates say.
void check_pictures(CheckList& list);

/// A map that is 1 everywhere is the polygon itself: zero offset.
void check_polygon(CheckList& list);

/// Whoever finds the relief has read it: taps are counted.
void check_work(CheckList& list);

}  // namespace reliefbench
