// The models that make_sample_organs writes. `size`: pixels on a side of the largest texture.
#pragma once

#include <filesystem>

namespace organs {

void make_lagb(const std::filesystem::path& folder, int size);
void make_liver_lobe(const std::filesystem::path& folder, int size);
void make_hook_cautery(const std::filesystem::path& folder);

}  // namespace organs
