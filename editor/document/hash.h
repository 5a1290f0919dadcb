// Hashes of bytes (XXH3, 64 bits): equal bytes have equal ones. They are written into files of the state folder, so
// another function would make these unknown.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace lapfx::document {

std::uint64_t hash_of(std::string_view bytes);
/// 16 hexadecimal digits.
std::string hex_of(std::uint64_t hash);

}  // namespace lapfx::document
