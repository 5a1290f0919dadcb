// Cells of a CSV file (RFC 4180).
//
//     csv += ',', append_csv(csv, file_name);
//
// Any thread.
#pragma once

#include <string>
#include <string_view>

namespace lapfx::ui {

/// Text with a comma, a quote or a line break comes in quotes.
void append_csv(std::string& csv, std::string_view cell);

}  // namespace lapfx::ui
