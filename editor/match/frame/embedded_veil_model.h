// The text of veil_model.json, which is built into the library.
#pragma once

#include <string_view>

namespace lapfx::match {

extern const std::string_view embedded_veil_model;

}  // namespace lapfx::match
