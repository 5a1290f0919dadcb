#include "commands/content_hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cstdio>
#include <fstream>
#include <vector>

#include "lapfx/authoring/clip.h"

namespace lapfx::commands {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t block = std::size_t{1} << 20;  // bytes read at a time

bool is_plain(const fs::path& file) {
    std::error_code error;
    return fs::is_regular_file(file, error);  // opening a pipe would wait
}

}  // namespace

struct ContentHash::State {
    XXH3_state_t hash;

    void add(const void* bytes, std::size_t count) { XXH3_128bits_update(&hash, bytes, count); }
    void end_part(std::uint64_t length) { add(&length, sizeof length); }
    void add_plain(const fs::path& file) {
        std::ifstream in(file, std::ios::binary);
        std::vector<char> bytes(block);
        std::uint64_t length = 0;
        while (in.read(bytes.data(), block), in.gcount() > 0) {
            add(bytes.data(), static_cast<std::size_t>(in.gcount()));
            length += static_cast<std::uint64_t>(in.gcount());
        }
        end_part(length);
    }
};

ContentHash::ContentHash() : state_(std::make_unique<State>()) {
    XXH3_128bits_reset(&state_->hash);
}

ContentHash::~ContentHash() = default;

void ContentHash::add(std::string_view text) {
    state_->add(text.data(), text.size());
    state_->end_part(text.size());
}

void ContentHash::add_file(const fs::path& file) {
    if (is_plain(file)) return state_->add_plain(file);
    const std::vector<fs::path> images = clip_images(file);
    add(images.empty() ? "no such file" : "images");
    for (const fs::path& image : images)
        if (is_plain(image)) state_->add_plain(image);
}

std::string ContentHash::text() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(&state_->hash);
    char text[33];
    std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                  static_cast<unsigned long long>(hash.low64));
    return text;
}

}  // namespace lapfx::commands
