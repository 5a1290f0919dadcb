// Burns of contacts, for the tests of smoke.
#pragma once

#include "smoke/burns.h"
#include "support/logged.h"

namespace lapfx::smoke {

/// Tissue everywhere, so fat all over.
inline BurnList burns_of(std::span<const ToolContact> contacts, double fat = 0.0) {
    BurnList burns([](const glm::dvec3&) { return true; }, [fat](const glm::dvec3&) { return fat; });
    burns.update(test::log_of(contacts));
    return burns;
}

}  // namespace lapfx::smoke
