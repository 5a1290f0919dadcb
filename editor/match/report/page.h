// What the HTML pages of fits have in common.
//
//     html = page_head("Fit of " + scene) + "<body>\n<main>\n<h1>Fit of " + name_element(scene) + ...
//
// Pure functions, any thread; nothing throws.
#pragma once

#include <string>
#include <string_view>

namespace lapfx::match {

/// All before <body>: the title, which may hold anything, the style (report_style.h) and then `more_style`, and a
/// policy that forbids whatever is not in the file.
std::string page_head(const std::string& title, std::string_view more_style = {});

/// A name from outside; it keeps its own direction of letters to itself.
std::string name_element(const std::string& name);

}  // namespace lapfx::match
