// JSON text as a tree that keeps what a strict reader needs: the order of keys, and keys that occur twice.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lapfx::preset {

struct Json {
    enum class Type { null, boolean, number, text, list, object };

    Type type = Type::null;
    bool boolean = false;
    double number = 0.0;
    std::string text = {};
    std::vector<Json> items = {};        ///< elements of a list, values of an object
    std::vector<std::string> keys = {};  ///< object: keys[i] belongs to items[i]

    /// Value of the first member with this key, or null.
    const Json* find(std::string_view key) const;
    /// The value as a fault shows it: -3, "fast", an array.
    std::string shown() const;
};

constexpr std::size_t longest_document = 4 << 20;  ///< bytes
constexpr std::size_t most_values = 100'000;
constexpr std::size_t deepest_level = 32;

/// Strict RFC 8259 within the limits above. Throws Error (bad_input) with place "LINE:COLUMN"; `name` is
/// the file.
Json parse_json(std::string_view text, const std::string& name);

}  // namespace lapfx::preset
