#include "media/png.h"

#include <png.h>

#include <algorithm>
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

/// Rows of pixels, as they come from a file, become an image of means over squares.
class Shrinking {
  public:
    /// `in_order`: rows are whole and come from the top, so that the sums of one row of squares are enough.
    void begin(Image& image, std::size_t width, std::size_t height, std::size_t factor, bool in_order) {
        image_ = &image;
        size_ = {width, height};
        factor_ = factor;
        in_order_ = in_order;
        shrunk_ = {(width + factor - 1) / factor, (height + factor - 1) / factor};
        image.width = static_cast<int>(shrunk_.x);
        image.height = static_cast<int>(shrunk_.y);
        image.pixels.resize(shrunk_.x * shrunk_.y * 4);
        sums_.assign(shrunk_.x * (in_order ? 1 : shrunk_.y) * 4, 0);
    }

    /// `count` pixels of the row `y`, the first at `x`, `step` apart.
    void add(const std::uint8_t* pixels, std::size_t y, std::size_t x, std::size_t step, std::size_t count) {
        std::uint16_t* const row = sums_.data() + (in_order_ ? 0 : y / factor_ * shrunk_.x * 4);
        for (std::size_t i = 0; i < count; ++i, x += step, pixels += 4)
            for (std::size_t c = 0; c < 4; ++c) {
                std::uint16_t& sum = row[x / factor_ * 4 + c];
                sum = static_cast<std::uint16_t>(sum + pixels[c]);
            }
        if (in_order_ && (y % factor_ == factor_ - 1 || y + 1 == size_.y)) write(y / factor_);
    }

    void end() {
        for (std::size_t y = 0; !in_order_ && y < shrunk_.y; ++y) write(y);
    }

  private:
    struct Size {
        std::size_t x = 0, y = 0;
    };

    /// One row of means; those at the right and lower edge are of fewer pixels.
    void write(std::size_t y) {
        std::uint16_t* const sums = sums_.data() + (in_order_ ? 0 : y * shrunk_.x * 4);
        const std::size_t rows = std::min(factor_, size_.y - y * factor_);
        for (std::size_t x = 0; x < shrunk_.x; ++x) {
            const std::size_t count = rows * std::min(factor_, size_.x - x * factor_);
            for (std::size_t c = 0; c < 4; ++c)
                image_->pixels[(y * shrunk_.x + x) * 4 + c] =
                    static_cast<std::uint8_t>((sums[x * 4 + c] + count / 2) / count);
        }
        std::fill(sums, sums + shrunk_.x * 4, std::uint16_t{0});
    }

    Image* image_ = nullptr;
    Size size_, shrunk_;
    std::size_t factor_ = 1;
    bool in_order_ = true;
    std::vector<std::uint16_t> sums_;  // each is that of 16 x 16 bytes at most
};

/// Row by row; an interlaced file has seven images of every eighth, fourth or second pixel.
void read_shrunk(png_structp png, bool interlaced, png_uint_32 width, png_uint_32 height, Shrinking& shrinking,
                 std::uint8_t* row) {
    for (int pass = 0; interlaced && pass < PNG_INTERLACE_ADAM7_PASSES; ++pass) {
        const auto first = static_cast<std::size_t>(PNG_PASS_START_COL(pass)),
                   step = std::size_t{1} << PNG_PASS_COL_SHIFT(pass);
        const png_uint_32 columns = PNG_PASS_COLS(width, pass), rows = PNG_PASS_ROWS(height, pass);
        for (png_uint_32 r = 0; columns > 0 && r < rows; ++r) {
            png_read_row(png, row, nullptr);
            shrinking.add(row, PNG_ROW_FROM_PASS_ROW(r, pass), first, step, columns);
        }
    }
    for (std::size_t y = 0; !interlaced && y < height; ++y) {
        png_read_row(png, row, nullptr);
        shrinking.add(row, y, 0, 1, width);
    }
    shrinking.end();
}

}  // namespace

bool decode_png(std::span<const std::uint8_t> file, Image& image, ImageFacts& facts, int factor) {
    const Reader reader;
    const png_structp png = reader.png;
    const png_infop info = reader.info;
    std::vector<png_bytep> rows;
    std::vector<std::uint8_t> row;
    Shrinking shrinking;
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
    if (factor == 1) png_set_interlace_handling(png);
    png_read_update_info(png, info);
    const std::size_t width = png_get_image_width(png, info), height = png_get_image_height(png, info);
    if (factor > 1) {
        const bool interlaced = png_get_interlace_type(png, info) == PNG_INTERLACE_ADAM7;
        row.resize(width * 4);
        shrinking.begin(image, width, height, static_cast<std::size_t>(factor), !interlaced);
        read_shrunk(png, interlaced, png_get_image_width(png, info), png_get_image_height(png, info), shrinking,
                    row.data());
        return true;
    }
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    image.pixels.resize(width * height * 4);
    rows.resize(height);
    for (std::size_t y = 0; y < height; ++y) rows[y] = image.pixels.data() + y * width * 4;
    png_read_image(png, rows.data());
    return true;
}

}  // namespace lapfx::media
