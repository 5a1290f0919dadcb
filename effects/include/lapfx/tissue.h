// What the organ's colours show about its tissue: where vessels run and where there is fat (paper: figure 9).
// Plain data; any thread.
#pragma once

namespace lapfx {

/// The tissue around a place: means over the tool tip's region of influence (`region`, mm).
struct TissueSample {
    double vessels = 0.0;  ///< 0..1, share of the region that is vessel; 1 where the organ has no colour
    double fat = 0.0;      ///< 0..1, share of the region that is fat; 0 where the organ has no colour
    double bleeds = 0.0;   ///< 0..4, how strongly a cut here bleeds, times the preset's speed; 0: not at all. 1 where
                           ///< the organ has no colour or shows no vessels
    bool known = false;    ///< the organ's own colours tell the density; else vessels and fat stand for "not known"
};

}  // namespace lapfx
