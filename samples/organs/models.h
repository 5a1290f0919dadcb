// The models that make_sample_organs writes. `size`: pixels on a side of the largest texture.
#pragma once

#include <filesystem>

namespace organs {

void make_lagb(const std::filesystem::path& folder, int size);

}  // namespace organs
