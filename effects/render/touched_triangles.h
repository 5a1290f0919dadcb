// The triangles with blood or marks: the few that the costly program has to draw. They are kept as runs of neighbouring
// triangles, so that a few calls draw them; a run may include untouched ones. Allocates nothing after construction.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lapfx::render {

class TouchedTriangles {
  public:
    explicit TouchedTriangles(std::size_t triangles) : touched_(triangles / run + 1, 0) {}

    void touch(std::uint32_t triangle) noexcept { touched_[triangle / run] = 1; }

    /// Calls visit(begin, end) for the runs of touched triangles within [begin, end).
    template <class Visit>
    void for_each(std::size_t begin, std::size_t end, const Visit& visit) const {
        for (std::size_t at = begin; at < end;) {
            std::size_t r = at / run;
            if (touched_[r] == 0) {
                at = (r + 1) * run;
                continue;
            }
            while (r < touched_.size() && touched_[r] != 0) ++r;
            visit(at, std::min(end, r * run));
            at = r * run;
        }
    }

  private:
    static constexpr std::size_t run = 128;
    std::vector<char> touched_;  // per run
};

}  // namespace lapfx::render
