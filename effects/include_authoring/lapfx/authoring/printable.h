// Text from outside (names in files, names of files) as a terminal, a page or a table can show it on one line.
//
//     std::cout << lapfx::printable(organ.name) << '\n';
#pragma once

#include <string>
#include <string_view>

namespace lapfx {

/// Control characters, those that break lines or turn the direction of text, and bytes that are not UTF-8 are escaped:
/// \x1b, \u202e. All other text stays as it is.
std::string printable(std::string_view text);

}  // namespace lapfx
