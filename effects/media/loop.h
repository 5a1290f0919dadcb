#pragma once

namespace lapfx::media {

/// Consecutive frames of a clip, first..last, that start over.
struct Loop {
    int first = 0;
    int last = 0;

    friend bool operator==(const Loop&, const Loop&) = default;
    /// The frame `steps` (at least 1) later. A frame outside counts as the one before the first.
    int after(int index, int steps = 1) const {
        const int from = index >= first && index <= last ? index : first - 1;
        return first + (from - first + steps) % length();
    }
    int length() const { return last - first + 1; }
};

}  // namespace lapfx::media
