#include "media/png.h"

#include <png.h>

#include <csetjmp>
#include <cstring>
#include <new>
#include <vector>

namespace lapfx::media {

namespace {

[[noreturn]] void stop(png_structp png, png_const_charp) {
    png_longjmp(png, 1);
}
void be_silent(png_structp, png_const_charp) {}

void take(png_structp png, png_bytep into, std::size_t count) {
    auto& left = *static_cast<std::span<const std::uint8_t>*>(png_get_io_ptr(png));
    if (count > left.size()) stop(png, "");
    std::memcpy(into, left.data(), count);
    left = left.subspan(count);
}

struct Reader {
    Reader() {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, stop, be_silent);
        if (png != nullptr) info = png_create_info_struct(png);
        if (info == nullptr) png_destroy_read_struct(&png, nullptr, nullptr);
        if (info == nullptr) throw std::bad_alloc();
    }
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    png_structp png = nullptr;
    png_infop info = nullptr;
};

}  // namespace

bool decode_png(std::span<const std::uint8_t> file, Image& image, ImageFacts& facts) {
    const Reader reader;
    const png_structp png = reader.png;
    const png_infop info = reader.info;
    std::vector<png_bytep> rows;
    // What libpng refuses comes back here. Nothing that has a destructor lies between here and there.
    if (setjmp(png_jmpbuf(png)) != 0) {  // NOLINT: that is how it reports
        image.pixels.clear();
        return false;
    }
    png_set_read_fn(png, &file, take);
    png_read_info(png, info);
    facts = {.channels = png_get_channels(png, info), .bits = std::max<int>(8, png_get_bit_depth(png, info))};
    if (png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE) facts.channels = 3;
    if (png_get_valid(png, info, PNG_INFO_tRNS) != 0) ++facts.channels;
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    const std::size_t width = png_get_image_width(png, info), height = png_get_image_height(png, info);
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    image.pixels.resize(width * height * 4);
    rows.resize(height);
    for (std::size_t y = 0; y < height; ++y) rows[y] = image.pixels.data() + y * width * 4;
    png_read_image(png, rows.data());
    return true;
}

}  // namespace lapfx::media
