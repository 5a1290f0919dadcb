// The tool's contacts as far as they make smoke: hot ones only while the tip touches tissue. Heat in the air burns nothing.
//
// Where a path leaves the tissue its contact is divided; what touches all along is passed on as it is, and so is what is not
// hot: suction clears haze wherever it is. A function of the contacts and the tissue alone. One thread at a time.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lapfx/tool.h"

namespace lapfx::smoke {

class Touching {
  public:
    static constexpr double spacing = 1.0;   ///< mm between the places of a path that are looked at
    static constexpr int most_places = 256;  ///< of one path; then they lie farther apart
    using Touches = std::function<bool(const glm::dvec3&)>;

    /// In the order of `contacts`; hot ones that are not usable (tool.h) are left out. Looks only at what comes after the first
    /// difference from the last call. Valid until the next call.
    std::span<const ToolContact> update(std::span<const ToolContact> contacts, const Touches& touches);

    /// The tissue is another.
    void clear() { contacts_.clear(); }

  private:
    void add(const ToolContact& contact, const Touches& touches);
    void add_part(const ToolContact& contact, double from, double to);

    std::vector<ToolContact> contacts_;
    std::vector<std::size_t> ends_;  // per contact, into parts_
    std::vector<ToolContact> parts_;
};

}  // namespace lapfx::smoke
