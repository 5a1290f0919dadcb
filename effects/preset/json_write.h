// Writes indented JSON text, in the order of the calls. Values are given as JSON text: number_text(),
// json_string(), ...
#pragma once

#include <string>
#include <string_view>

#include "lapfx/parameter.h"

namespace lapfx::preset {

/// A JSON string with quotes and escapes. `text` is UTF-8.
std::string json_string(std::string_view text);

/// A value as JSON on one line.
std::string json_value(const Parameter& row, const Value& value);

class JsonWriter {
  public:
    /// The outermost object and the elements of an array are opened without a key.
    void open(char bracket, std::string_view key = {});
    void close();
    void value(std::string_view key, std::string_view json);

    /// The text, once everything is closed.
    const std::string& text() const { return text_; }

  private:
    std::string text_;
    std::string open_;      ///< brackets to close
    bool is_empty_ = true;  ///< nothing yet since the last bracket

    void start_member(std::string_view key);
};

}  // namespace lapfx::preset
