// Pieces of text that HTML and SVG are made of. What they give is well-formed XML too, whatever bytes come in.
//
//     html += "<td>" + escaped(preset.name) + "</td><td>" + digits(value) + "</td>";
//
// Pure functions, any thread; nothing throws.
#pragma once

#include <string>
#include <string_view>

namespace lapfx::match {

/// Text from outside, such as a file's name, for an element's content or a quoted attribute: & < > " ' become
/// references. What is no letter of XML, or would turn the order of the letters around it, and each byte that is no
/// UTF-8, becomes U+FFFD, the sign for a letter that cannot be shown.
std::string escaped(std::string_view text);

/// RFC 4648, section 4: with padding, without line breaks.
std::string base64(std::string_view bytes);
/// The bytes of such a text; empty for any other text.
std::string bytes_of_base64(std::string_view text);

/// Three digits that count, or all before the point: "0.0123", "1250"; "-" for what is no number.
std::string digits(double value);
/// With so many decimals.
std::string decimals(double value, int count);

}  // namespace lapfx::match
