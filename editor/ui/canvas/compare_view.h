// Two pictures of one size against each other: beside, divided by a line, mixed, or their difference.
#pragma once

#include "ui/canvas/pixels.h"
#include "ui/canvas/view.h"

namespace lapfx::ui {

enum class CompareKind : std::uint8_t { wipe, side_by_side, onion, difference };

/// Kept by the program; every part may also be set by other controls.
struct CompareState {
    CompareKind kind = CompareKind::wipe;
    double position = 0.5;  ///< wipe: as CompareLook::position
    double angle = 0;       ///< wipe, rad, -pi to pi: as CompareLook::angle
    double mix = 0.5;       ///< onion: share of B
    double gain = 4;        ///< difference, 1 to 100
    bool swapped = false;   ///< B is shown as the first
    ViewState view;         ///< of both
};

struct CompareOptions {
    std::string_view first_label = "A", second_label = "B";
    bool grid = true;
    bool readout = true;
    bool magnifier = false;   ///< in it: of the picture that is seen there
    bool eyedropper = false;  ///< a left click, or Enter, takes a colour instead of panning or moving the line
    int sample_box = 1;
    int decimals = 1;
    /// Builds what lies over the pictures, handles for one, as children of a node that is as large as what shows them:
    /// side by side once over each, in nodes "First" and "Second"; else once, in "First". `with` is `over_with`.
    void (*over)(Ui& ui, const View& view, void* with) = nullptr;
    void* over_with = nullptr;
    Rect keep_off = {};  ///< that the readout never covers, px of the window
    std::string_view tip = {};
    Size width = grow(), height = grow();
};

struct CompareResult {
    bool view_changed = false;
    double zoom = 1;       ///< px of the screen for one of the pictures
    bool flicker = false;  ///< F is held: only the second is shown
    bool has_pick = false;
    glm::ivec2 pick{0};
    glm::vec4 first{0}, second{0};  ///< means of the sample box at the pick, as they are shown
    int under = 0;        ///< 0 or 1: which of the arguments is seen at the pick; where they are mixed, the first shown
    bool picked = false;  ///< the eyedropper was used there
    Edit edit;            ///< of position, angle, mix, gain or swapped
};

/// Does the same as image_view for two pictures. F held shows only the second picture, X swaps them, page keys change
/// gain or mix. The line of the wipe can be dragged anywhere. It has two handles, "Wipe" to move it and "Wipe angle" to
/// turn it about the first. Side by side, the pictures are one above the other where that makes them larger.
CompareResult compare_view(Ui& ui, std::string_view label, const Picture& first, const Picture& second,
                           CompareState& state, const CompareOptions& options = {});

}  // namespace lapfx::ui
