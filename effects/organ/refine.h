// Whether an organ's triangles are too large for the values at its vertices, and the result of splitting them.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "lapfx/refine.h"
#include "work/stages.h"

namespace lapfx::organ {

/// Edges longer than this are split, mm: about the radius of a burn of one second, by default, and half a lobe of the
/// noise at the edge of the blood.
constexpr double longest_wanted = 2.0;
/// At most this many triangles are added. An organ needs fewer; a room or a wrong unit would need more.
constexpr std::size_t most_added = 300'000;
/// On edges longer than this, mm, a burn is a tenth smaller or more: it is told where half of the surface has such
/// edges. Half of a whole abdomen has shorter ones.
constexpr double told_from = 4.0;

/// The longest edges that are left. Where most_added is not enough for longest_wanted, edges that are long in the file
/// already (a wall, a floor, the back of a liver) stay longer: what was modelled finely is what is looked at.
struct LongestEdge {
    double whole_up_to =
        std::numeric_limits<double>::infinity();  ///< mm in the file; these are split to longest_wanted
    /// mm2, from the squared length in the file, mm2. It grows as the root of the length.
    double squared_for(double in_file2) const {
        return longest_wanted * longest_wanted * std::max(1.0, std::sqrt(in_file2) / whole_up_to);
    }
};

struct RefinePlan {
    LongestEdge longest = {};
    double length = longest_wanted;  ///< mm; no edge is longer after splitting
    double usual = longest_wanted;   ///< mm; half of the surface has no longer edges after splitting
    std::size_t triangles = 0;       ///< triangles after splitting
    bool splits = false;             ///< there is anything to split
    int counts = 0;                  ///< lengths for which triangles were counted
    bool bounded() const { return length > longest_wanted; }  ///< most_added was not enough for longest_wanted
    bool is_told() const { return usual > told_from; }
};
/// Every organ that is used comes through here, so it is checked here: throws Error (bad_input) where it is not
/// complete.
RefinePlan plan_refine(const Organ& organ, const work::Stages& stages = {});

/// The organ before splitting. All members are empty if it was not split.
struct Unsplit {
    std::vector<glm::uvec2> midpoints;   ///< as RefinedOrgan::midpoints
    std::vector<std::uint32_t> indices;  ///< the triangles before splitting
    std::vector<Part> parts;             ///< of those
    std::size_t memory() const {         ///< bytes
        return midpoints.size() * sizeof(glm::uvec2) + indices.size() * sizeof(std::uint32_t);
    }
};
struct SplitOrgan {
    Organ organ;
    Unsplit from;
};
SplitOrgan refine(Organ organ, const RefinePlan& plan, const work::Stages& stages = {});

/// An organ that is fine enough for blood: the given one, or a copy whose long triangles are split.
class FineOrgan {
  public:
    /// Keeps a reference to `organ`.
    explicit FineOrgan(const Organ& organ);

    const Organ& organ() const { return split_ ? split_->organ : given_; }
    Unsplit take_unsplit() { return split_ ? std::move(split_->from) : Unsplit(); }

  private:
    const Organ& given_;
    std::optional<SplitOrgan> split_;
};

}  // namespace lapfx::organ
