#include "media/image.h"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <vector>

#include "lapfx/authoring/file.h"
#include "lapfx/authoring/file_guard.h"
#include "lapfx/authoring/picture.h"
#include "lapfx/error.h"
#include "media/jpeg.h"
#include "media/libav.h"
#include "media/png.h"

namespace lapfx::media {

namespace {

bool begins(std::span<const std::uint8_t> file, std::string_view mark) {
    return file.size() >= mark.size() && std::equal(mark.begin(), mark.end(), file.begin(), [](char a, std::uint8_t b) {
               return static_cast<std::uint8_t>(a) == b;
           });
}

/// WebP and BMP through FFmpeg: OpenCV's reader writes to stderr.
bool decode_with_ffmpeg(std::span<const std::uint8_t> file, AVCodecID id, Image& image, ImageFacts& facts, int factor) {
    const AVCodec* codec = avcodec_find_decoder(id);
    if (codec == nullptr) return false;
    const libav::Codec context(libav::made(avcodec_alloc_context3(codec)));
    const libav::Packet packet(libav::made(av_packet_alloc()));
    const libav::Frame frame(libav::made(av_frame_alloc()));
    context->thread_count = 1;
    context->max_pixels = maximum_image_pixels;
    if (av_new_packet(packet.get(), static_cast<int>(file.size())) < 0) throw std::bad_alloc();
    std::copy(file.begin(), file.end(), packet->data);
    if (avcodec_open2(context.get(), codec, nullptr) < 0 || avcodec_send_packet(context.get(), packet.get()) < 0 ||
        avcodec_receive_frame(context.get(), frame.get()) < 0)
        return false;
    const auto format = static_cast<AVPixelFormat>(frame->format);
    const AVPixFmtDescriptor* about = av_pix_fmt_desc_get(format);
    const int width = (frame->width + factor - 1) / factor, height = (frame->height + factor - 1) / factor;
    const int filter = factor > 1 ? SWS_AREA : SWS_BICUBIC;
    const libav::Scaler scaler(sws_getContext(frame->width, frame->height, format, width, height, AV_PIX_FMT_RGBA,
                                              filter | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT, nullptr, nullptr,
                                              nullptr));
    if (about == nullptr || !scaler) return false;
    image.width = width;
    image.height = height;
    image.pixels.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
    std::uint8_t* const into[] = {image.pixels.data()};
    const int stride[] = {4 * image.width};
    sws_scale(scaler.get(), frame->data, frame->linesize, 0, frame->height, into, stride);
    const bool palette = (about->flags & AV_PIX_FMT_FLAG_PAL) != 0, alpha = (about->flags & AV_PIX_FMT_FLAG_ALPHA) != 0;
    facts = {.channels = palette ? 3 : static_cast<int>(about->nb_components), .bits = 8};
    // The lowest bytes of a palette's colours are no opacity, whatever they hold.
    if (palette || !alpha)
        for (std::size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] = 255;
    return true;
}

std::string size_fault(const ImageSize& size) {
    const std::string text = std::to_string(size.width) + "x" + std::to_string(size.height);
    if (size.width < 1 || size.height < 1) return "its header says " + text + " pixels";
    const bool large = size.width > maximum_image_side || size.height > maximum_image_side ||
                       size.width * size.height > maximum_image_pixels;
    return large ? text + " pixels are more than the limit of 16384 a side" : "";
}

}  // namespace

int shrink_factor(const ImageSize& size, int longest) {
    int factor = 1;
    while (std::max(size.width, size.height) > std::int64_t{longest} * factor) factor *= 2;
    return factor;
}

std::string decode_image(std::span<const std::uint8_t> file, Image& image, ImageFacts& facts, int longest) {
    ImageSize size;
    if (!image_size(file, size)) return "not a PNG, JPEG, WebP or BMP image";
    if (std::string fault = size_fault(size); !fault.empty()) return fault;
    if (is_animated_webp(file)) return animated_webp;
    if (file.size() > (std::size_t{1} << 30)) return "is larger than 1 GiB";
    be_quiet();
    const int by = shrink_factor(size, longest);
    const bool decoded = begins(file, "\x89PNG")        ? decode_png(file, image, facts, by)
                         : begins(file, "\xff\xd8\xff") ? decode_jpeg(file, image, facts, by)
                         : begins(file, "BM")           ? decode_with_ffmpeg(file, AV_CODEC_ID_BMP, image, facts, by)
                                                        : decode_with_ffmpeg(file, AV_CODEC_ID_WEBP, image, facts, by);
    return decoded ? "" : "cannot be decoded";
}

std::string decode_image(std::span<const std::uint8_t> file, Image& image, int longest) {
    ImageFacts facts;
    return decode_image(file, image, facts, longest);
}

}  // namespace lapfx::media

namespace lapfx {

bool is_animated_picture(const std::filesystem::path& path) {
    constexpr std::size_t enough = 1 << 16;
    std::ifstream file(path, std::ios::binary);
    std::vector<std::uint8_t> head(enough);
    file.read(reinterpret_cast<char*>(head.data()), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    return media::is_animated_png(head) || media::is_animated_webp(head);
}

ImageFile read_image(const std::filesystem::path& path) {
    note_read(path);
    const std::string bytes = read_file(path, std::size_t{1} << 30);
    ImageFile made;
    media::ImageFacts facts;
    const std::string fault =
        media::decode_image({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, made.image, facts);
    if (!fault.empty()) throw Error(Failure::bad_input, Fault{.file = path.string(), .place = "", .reason = fault});
    made.channels = facts.channels;
    made.bits = facts.bits;
    return made;
}

}  // namespace lapfx
