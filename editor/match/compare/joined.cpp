#include "match/compare/joined.h"

namespace lapfx::match {

std::string joined(std::span<const std::string> parts) {
    std::string all;
    for (std::size_t i = 0; i < parts.size(); ++i)
        all += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
    return all;
}

}  // namespace lapfx::match
