// Text helpers of the parameter table and its documents: values as they are shown in faults and written to
// JSON.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace lapfx::preset {

/// The shortest decimal that reads back as the same double, whatever the locale; -0 is 0. Finite values
/// only.
std::string number_text(double value);

/// Whole text as a double in JSON's spelling or "inf"/"nan"; false when it is anything else or beyond
/// double range.
bool read_number(std::string_view text, double& value);

/// What was found, for a fault: in quotes, as valid UTF-8 and not longer than a line. Bad bytes show as \xNN.
std::string in_quotes(std::string_view text);

/// As in_quotes(), without the quotes.
std::string shown(std::string_view text, std::size_t longest);

/// The candidate with the least edit distance to `key`, the first of equals; empty without candidates.
std::string_view nearest(std::string_view key, std::span<const std::string_view> candidates);

/// The reason why a list of `size` elements is refused.
std::string too_many(std::size_t size, std::size_t most);

/// `pointer` + '/' + key, with '~' and '/' in the key escaped (RFC 6901) and very long keys cut.
std::string join_pointer(const std::string& pointer, std::string_view key);

}  // namespace lapfx::preset
