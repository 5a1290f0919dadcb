#pragma once

namespace lapfx::smoke {

/// Frames of a clip that follow each other and start over: first..last.
struct Loop {
    int first = 0;
    int last = 0;

    friend bool operator==(const Loop&, const Loop&) = default;
    int after(int index) const { return index >= first && index < last ? index + 1 : first; }
    int length() const { return last - first + 1; }
};

}  // namespace lapfx::smoke
