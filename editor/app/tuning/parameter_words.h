// What people call a parameter when they do not know its name: the everyday words that search looks into besides name,
// key and help.
//
//     app::everyday_words("bleeding.max_extent");  // "size spread reach ..."
//
// Any thread.
#pragma once

#include <span>
#include <string_view>
#include <utility>

namespace lapfx::app {

/// Keys of the preset's parameters and groups, of the scene's as "scene.camera.eye", with words between spaces. A
/// group's words hold for all that is in it.
std::span<const std::pair<std::string_view, std::string_view>> parameter_words();

/// The words for a single key; empty: it is found by its name.
std::string_view everyday_words(std::string_view key);

}  // namespace lapfx::app
