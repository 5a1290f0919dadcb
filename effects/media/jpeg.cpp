#include "media/jpeg.h"

#include <cstddef>
#include <cstdio>  // jpeglib.h needs it

#include <jpeglib.h>

#include <csetjmp>

namespace lapfx::media {

namespace {

constexpr int most_scans = 500;  // a progressive file has no more; each one costs as much as a whole picture

struct Reader {
    Reader() {
        // The structure's first member, so that the callbacks find the rest.
        about.err = jpeg_std_error(&errors);
        errors.error_exit = stop;
        errors.output_message = be_silent;
        progress.progress_monitor = count_scans;
    }
    ~Reader() { jpeg_destroy_decompress(&about); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    [[noreturn]] static void stop(j_common_ptr about) {
        std::longjmp(*static_cast<std::jmp_buf*>(about->client_data), 1);
    }
    static void be_silent(j_common_ptr) {}
    static void count_scans(j_common_ptr about) {
        if (reinterpret_cast<j_decompress_ptr>(about)->input_scan_number > most_scans) stop(about);
    }

    jpeg_decompress_struct about{};
    jpeg_error_mgr errors{};
    jpeg_progress_mgr progress{};
    std::jmp_buf back{};
};

/// In place, from four inks, which Adobe's programs store inverted, to RGBA.
void to_rgba(std::uint8_t* pixel, std::size_t count, bool inverted) {
    for (std::size_t i = 0; i < count; ++i, pixel += 4) {
        const auto light = [&](int ink) { return inverted ? pixel[ink] : 255 - pixel[ink]; };
        const int black = light(3);
        for (int ink = 0; ink < 3; ++ink) pixel[ink] = static_cast<std::uint8_t>(light(ink) * black / 255);
        pixel[3] = 255;
    }
}

}  // namespace

bool decode_jpeg(std::span<const std::uint8_t> file, Image& image, ImageFacts& facts, int factor) {
    Reader reader;
    jpeg_decompress_struct& about = reader.about;
    // What libjpeg refuses comes back here. Nothing that has a destructor lies between here and there.
    if (setjmp(reader.back) != 0) {  // NOLINT: that is how it reports
        image.pixels.clear();
        return false;
    }
    about.client_data = &reader.back;
    jpeg_create_decompress(&about);
    about.progress = &reader.progress;
    jpeg_mem_src(&about, file.data(), file.size());
    jpeg_read_header(&about, TRUE);
    facts = {.channels = about.num_components, .bits = about.data_precision};
    const bool inks = about.jpeg_color_space == JCS_CMYK || about.jpeg_color_space == JCS_YCCK;
    about.out_color_space = inks ? JCS_CMYK : JCS_EXT_RGBA;
    about.scale_num = 1;
    about.scale_denom = static_cast<unsigned>(factor);
    jpeg_start_decompress(&about);
    const std::size_t width = about.output_width, height = about.output_height;
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    image.pixels.resize(width * height * 4);
    while (about.output_scanline < about.output_height) {
        JSAMPROW row = image.pixels.data() + about.output_scanline * width * 4;
        jpeg_read_scanlines(&about, &row, 1);
    }
    if (inks) to_rgba(image.pixels.data(), width * height, about.saw_Adobe_marker != 0);
    return true;
}

}  // namespace lapfx::media
