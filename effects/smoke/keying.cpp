// Pictures of keying on the CPU.
//
// Choke and feather read places off the middles of pixels. All pixels use the same offsets, so the four weights of a
// place between pixels are the same everywhere: whole planes are moved, one row at a time, instead of looking up single
// places.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/gtc/color_space.hpp>

#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/keying.h"
#include "media/clip_report.h"
#include "smoke/keying_pixel.h"

namespace lapfx {

namespace {

using smoke::Keying;

constexpr float least_transmission = 0.002f;  // as in shaders/plume.frag: an opacity of 1 would be infinite thickness

std::size_t area(glm::ivec2 size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

std::size_t at(glm::ivec2 size, glm::ivec2 pixel) {
    return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(pixel.x);
}

std::uint8_t byte(float value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 255.0f) + 0.5f);
}

std::uint8_t srgb_byte(float linear) {
    return byte(255.0f * glm::convertLinearToSRGB(glm::vec3(glm::clamp(linear, 0.0f, 1.0f))).x);
}

/// sRGB bytes for linear light 0..1, in steps fine enough for a quarter of a code value, because pow() for each pixel
/// is slow.
const std::vector<std::uint8_t>& srgb_table() {
    static const std::vector<std::uint8_t> table = [] {
        std::vector<std::uint8_t> bytes(16385);
        for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = srgb_byte(static_cast<float>(i) / 16384.0f);
        return bytes;
    }();
    return table;
}

std::uint8_t encode(const std::vector<std::uint8_t>& table, float linear) {
    return table[static_cast<std::size_t>(std::clamp(linear, 0.0f, 1.0f) * 16384.0f + 0.5f)];
}

const std::array<float, 256>& linear_table() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < 256; ++i)
            values[i] = glm::convertSRGBToLinear(glm::vec3(static_cast<float>(i) / 255.0f)).x;
        return values;
    }();
    return table;
}

glm::vec3 linear(const glm::dvec3& srgb) {
    return glm::convertSRGBToLinear(glm::vec3(srgb));
}

/// One row of a picture with Cb and Cr at half of the rows and columns, sampled in the middles of full pixels.
void upsample_row(const std::uint8_t* chroma, glm::ivec2 half, int y, int width, float* cb, float* cr) {
    const float row = (static_cast<float>(y) + 0.5f) / 2.0f - 0.5f;
    const int above = static_cast<int>(std::floor(row));
    const float share = row - static_cast<float>(above);
    const auto line = [&](int index) {
        return chroma +
               2 * static_cast<std::size_t>(half.x) * static_cast<std::size_t>(std::clamp(index, 0, half.y - 1));
    };
    const std::uint8_t *a = line(above), *b = line(above + 1);
    const auto sample = [&](int x, int channel) {
        const std::size_t i =
            2 * static_cast<std::size_t>(std::clamp(x, 0, half.x - 1)) + static_cast<std::size_t>(channel);
        return (1.0f - share) * static_cast<float>(a[i]) + share * static_cast<float>(b[i]);
    };
    for (int x = 0; x < width; ++x) {
        const int left = x % 2 == 0 ? x / 2 - 1 : x / 2;
        const float right = x % 2 == 0 ? 0.75f : 0.25f;
        cb[x] = (1.0f - right) * sample(left, 0) + right * sample(left + 1, 0);
        cr[x] = (1.0f - right) * sample(left, 1) + right * sample(left + 1, 1);
    }
}

/// Whole pixels, `high` excluded.
struct FramePart {
    glm::ivec2 low, high;
};

/// `plane` as it is `offset` pixels away, in one row: bilinear, clamped to the edges of `part`.
void moved_row(const std::vector<float>& plane, glm::ivec2 size, const FramePart& part, int y, glm::vec2 offset,
               float* __restrict row) {
    const glm::vec2 first = glm::floor(offset), f = offset - first;
    const auto line = [&](int index) {
        return plane.data() + at(size, {0, std::clamp(index, part.low.y, part.high.y - 1)});
    };
    const float *a = line(y + static_cast<int>(first.y)), *b = line(y + static_cast<int>(first.y) + 1);
    const float wa = 1.0f - f.y, wb = f.y, left = 1.0f - f.x, right = f.x;
    const int dx = static_cast<int>(first.x);
    const auto clamped = [&](int x) {
        const int l = std::clamp(x + dx, part.low.x, part.high.x - 1);
        const int r = std::clamp(x + dx + 1, part.low.x, part.high.x - 1);
        row[x] = left * (wa * a[l] + wb * b[l]) + right * (wa * a[r] + wb * b[r]);
    };
    const int from = std::clamp(part.low.x - dx, 0, size.x), to = std::clamp(part.high.x - 1 - dx, from, size.x);
    for (int x = 0; x < from; ++x) clamped(x);
    const float *al = a + dx, *bl = b + dx;
    for (int x = from; x < to; ++x)
        row[x] = left * (wa * al[x] + wb * bl[x]) + right * (wa * al[x + 1] + wb * bl[x + 1]);
    for (int x = to; x < size.x; ++x) clamped(x);
}

/// Keys rows of a frame, moved by an offset.
class RowKeyer {
  public:
    RowKeyer(const KeyingFrame& frame, const Keying& key, const SmokeClip& clip)
        : frame_(frame),
          key_(key),
          windowed_(smoke::has_window(clip)),
          window_(smoke::window_of(clip, frame.size)),
          part_(windowed_ && window_.fills_view ? FramePart{window_.low, window_.high} : FramePart{{0, 0}, frame.size}),
          chroma_(key.chroma_high > 0.0f),
          luma_row_(static_cast<std::size_t>(frame.size.x)),
          cb_row_(luma_row_.size()),
          cr_row_(luma_row_.size()) {}

    void key(int y, glm::vec2 offset, float* __restrict out) {
        if (frame_.opacity.empty())
            key_codes(y, offset, out);
        else
            moved_row(frame_.opacity, frame_.size, part_, y, offset, out);
        if (windowed_) look_through_window(y, offset, out);
    }

  private:
    void key_codes(int y, glm::vec2 offset, float* __restrict out) {
        const int width = frame_.size.x;
        moved_row(frame_.luma, frame_.size, part_, y, offset, luma_row_.data());
        const float* __restrict luma = luma_row_.data();
        const float flip = key_.dark > 0.5f ? -1.0f : 1.0f, base = key_.dark > 0.5f ? 255.0f : 0.0f;
        const float scale = 1.0f / std::max(key_.luma_high - key_.luma_low, 1e-3f);
        for (int x = 0; x < width; ++x) {
            const float value = (base + flip * luma[x] - key_.luma_low) * scale;
            out[x] = std::min(std::max(value, 0.0f), 1.0f);
        }
        if (!chroma_) return;
        moved_row(frame_.cb, frame_.size, part_, y, offset, cb_row_.data());
        moved_row(frame_.cr, frame_.size, part_, y, offset, cr_row_.data());
        const glm::vec2 center = key_.key_chroma;
        const float reach = 1.0f / std::max(key_.chroma_high - key_.chroma_low, 1e-3f);
        for (int x = 0; x < width; ++x) {
            const auto i = static_cast<std::size_t>(x);
            const float b = cb_row_[i] - center.x, r = cr_row_[i] - center.y;
            const float value = (std::sqrt(b * b + r * r) - key_.chroma_low) * reach;
            out[x] *= std::min(std::max(value, 0.0f), 1.0f);
        }
    }
    /// Haze is drawn only within its part, where a place beyond an edge reads the edge; outside there is nothing.
    void look_through_window(int y, glm::vec2 offset, float* __restrict out) {
        for (int x = 0; x < frame_.size.x; ++x) {
            const glm::vec2 here = glm::vec2(x, y) + 0.5f;
            glm::vec2 position = here + offset;
            if (window_.fills_view) {
                const bool inside =
                    glm::all(glm::greaterThan(here, window_.low)) && glm::all(glm::lessThan(here, window_.high));
                position = inside ? glm::clamp(position, window_.low + 0.5f, window_.high - 0.5f) : here;
            }
            out[x] *= smoke::window_at(window_, position);
        }
    }

    const KeyingFrame& frame_;
    const Keying& key_;
    bool windowed_;
    smoke::Window window_;
    FramePart part_;
    bool chroma_;
    std::vector<float> luma_row_, cb_row_, cr_row_;
};

/// smoke::choked() of a whole row, `offset` away.
void choked_row(RowKeyer& keyer, int y, glm::vec2 offset, float choke, std::vector<float>& scratch, float* out) {
    keyer.key(y, offset, out);
    if (!(choke > 0.0f)) return;
    for (const glm::vec2 direction : smoke::edge_directions) {
        keyer.key(y, offset + choke * direction, scratch.data());
        for (std::size_t x = 0; x < scratch.size(); ++x) out[x] = std::min(out[x], scratch[x]);
    }
}

Image picture_of(glm::ivec2 size) {
    return {.width = size.x, .height = size.y, .pixels = std::vector<std::uint8_t>(area(size) * 4), .name = ""};
}

/// The light of smoke, for all pixels of a frame.
class Light {
  public:
    Light(const KeyingFrame& frame, const KeyingLook& look)
        : frame_(frame), key_(smoke::keying_of(look.keying, look.clip.polarity)) {}

    /// own_light() in shaders/smoke.glsl does the same.
    glm::vec3 operator()(std::size_t i) const {
        const float y = frame_.luma[i];
        const glm::vec2 chroma(frame_.cb[i], frame_.cr[i]);
        const bool keyed_by_chroma = key_.chroma_high > 0.0f;
        const glm::vec3 own = smoke::tint(y, smoke::despill(chroma, key_));
        const float shade = frame_.opacity.empty() ? 1.0f : smoke::shade(y, frame_.opacity[i]);
        return shade * (keyed_by_chroma ? glm::mix(own, glm::vec3(1.0f), key_.spill) : own);
    }

  private:
    const KeyingFrame& frame_;
    Keying key_;
};

/// The place of a pixel of the clip in a background that is cropped to the shape of the clip.
class Backdrop {
  public:
    Backdrop(const Image& image, glm::ivec2 size) : image_(image) {
        const glm::vec2 whole(image.width, image.height), wanted(size);
        step_ = std::min(whole.x / wanted.x, whole.y / wanted.y);
        corner_ = 0.5f * (whole - step_ * wanted);
    }
    const std::uint8_t* pixel(glm::ivec2 p) const {
        if (image_.pixels.empty()) return black;
        const glm::ivec2 place = glm::ivec2(corner_ + step_ * (glm::vec2(p) + 0.5f));
        const glm::ivec2 inside = glm::clamp(place, glm::ivec2(0), glm::ivec2(image_.width, image_.height) - 1);
        return &image_.pixels[4 * at({image_.width, image_.height}, inside)];
    }

  private:
    static constexpr std::uint8_t black[4] = {0, 0, 0, 255};
    const Image& image_;
    glm::vec2 corner_{0.0f};
    float step_ = 1.0f;
};

}  // namespace

glm::vec3 KeyingFrame::code(glm::ivec2 pixel) const {
    const std::size_t i = at(size, pixel);
    const float red = luma[i] + 1.402f * cr[i], blue = luma[i] + 1.772f * cb[i];
    return {red, (luma[i] - 0.299f * red - 0.114f * blue) / 0.587f, blue};
}

struct KeyingReader::State {
    media::Decoder decoder;
    ClipReport report;
    media::Picture picture;
};

KeyingReader::KeyingReader(const std::filesystem::path& clip, const std::atomic<bool>* stop)
    : state_(
          std::make_unique<State>(media::open_stoppable(clip, media::Layout::planar, media::Decoder::most_frames, stop),
                                  ClipReport{}, media::Picture{})) {
    state_->report = media::report_of(state_->decoder.info());
}
KeyingReader::KeyingReader(KeyingReader&&) noexcept = default;
KeyingReader& KeyingReader::operator=(KeyingReader&&) noexcept = default;
KeyingReader::~KeyingReader() = default;

const ClipReport& KeyingReader::report() const {
    return state_->report;
}

int KeyingReader::frame_at(double time) const {
    return state_->decoder.info().frame_at(time);
}

double KeyingReader::time_of(int frame) const {
    const auto& times = state_->decoder.info().times;
    return times[static_cast<std::size_t>(std::clamp(frame, 0, static_cast<int>(times.size()) - 1))];
}

bool KeyingReader::read(int frame, KeyingFrame& into, const std::atomic<bool>* stop) noexcept {
    media::Decoder& decoder = state_->decoder;
    const bool good = decoder.read(std::clamp(frame, 0, state_->report.frames - 1), state_->picture, stop);
    const media::PictureFormat format = decoder.format();
    const glm::ivec2 size = format.size;
    try {
        for (std::vector<float>* plane : {&into.luma, &into.cb, &into.cr}) plane->resize(area(size));
        into.opacity.resize(format.alpha ? area(size) : 0);
        into.size = size;
    } catch (const std::bad_alloc&) {
        into = {};
        return false;
    }
    if (state_->picture.bytes.size() < format.bytes()) {  // nothing of it could be decoded
        for (std::vector<float>* plane : {&into.luma, &into.cb, &into.cr, &into.opacity})
            std::fill(plane->begin(), plane->end(), 0.0f);
        return false;
    }
    const std::uint8_t* bytes = state_->picture.bytes.data();
    const media::ColorMatrix& color = decoder.info().color;
    const glm::mat3 rows = glm::transpose(color.matrix);
    for (int y = 0; y < size.y; ++y) {
        const std::size_t line = at(size, {0, y});
        float *l = &into.luma[line], *cb = &into.cb[line], *cr = &into.cr[line];
        upsample_row(bytes + format.color_bytes(), format.chroma_size(), y, size.x, cb, cr);
        for (int x = 0; x < size.x; ++x) {
            const glm::vec3 value =
                glm::vec3(static_cast<float>(bytes[line + static_cast<std::size_t>(x)]), cb[x], cr[x]) - color.offset;
            const glm::vec3 code(glm::dot(rows[0], value), glm::dot(rows[1], value), glm::dot(rows[2], value));
            const glm::vec2 chroma = smoke::chroma(code);
            l[x] = smoke::luma(code), cb[x] = chroma.x, cr[x] = chroma.y;
        }
    }
    const std::uint8_t* opacity = bytes + format.color_bytes() + format.chroma_bytes();
    for (std::size_t i = 0; i < into.opacity.size(); ++i) into.opacity[i] = static_cast<float>(opacity[i]) / 255.0f;
    return good;
}

void keyed_opacity(const KeyingFrame& frame, const KeyingParameters& keying, const SmokeClip& clip,
                   std::vector<float>& opacity) {
    const Keying key = smoke::keying_of(keying, clip.polarity);
    const auto choke = static_cast<float>(keying.choke), feather = static_cast<float>(keying.feather);
    const auto width = static_cast<std::size_t>(frame.size.x);
    opacity.resize(area(frame.size));
    RowKeyer keyer(frame, key, clip);
    std::vector<float> scratch(width), moved(width);
    for (int y = 0; y < frame.size.y; ++y) {
        float* row = opacity.data() + at(frame.size, {0, y});
        choked_row(keyer, y, glm::vec2(0.0f), choke, scratch, row);
        if (!(feather > 0.0f)) continue;
        for (const glm::vec2 direction : smoke::edge_directions) {
            choked_row(keyer, y, feather * direction, choke, scratch, moved.data());
            for (std::size_t x = 0; x < width; ++x) row[x] += moved[x];
        }
        for (std::size_t x = 0; x < width; ++x) row[x] /= 9.0f;
    }
}

glm::vec3 smoke_light(const KeyingFrame& frame, const KeyingLook& look, glm::ivec2 pixel) {
    return Light(frame, look)(at(frame.size, pixel));
}

Image source_picture(const KeyingFrame& frame) {
    Image image = picture_of(frame.size);
    std::uint8_t* pixel = image.pixels.data();
    for (std::size_t i = 0; i < frame.luma.size(); ++i, pixel += 4) {
        const float luma = frame.luma[i], red = luma + 1.402f * frame.cr[i], blue = luma + 1.772f * frame.cb[i];
        pixel[0] = byte(red);
        pixel[1] = byte((luma - 0.299f * red - 0.114f * blue) / 0.587f);
        pixel[2] = byte(blue);
        pixel[3] = 255;
    }
    return image;
}

Image matte_picture(glm::ivec2 size, std::span<const float> opacity) {
    assert(opacity.size() == area(size));
    Image image = picture_of(size);
    for (std::size_t i = 0; i < opacity.size(); ++i) {
        const std::uint8_t grey = byte(255.0f * opacity[i]);
        std::fill_n(&image.pixels[4 * i], 3, grey);
        image.pixels[4 * i + 3] = 255;
    }
    return image;
}

Image keyed_picture(const KeyingFrame& frame, const KeyingLook& look, std::span<const float> opacity) {
    assert(opacity.size() == area(frame.size));
    Image image = picture_of(frame.size);
    const std::vector<std::uint8_t>& table = srgb_table();
    const Light light(frame, look);
    const glm::vec3 color = linear(look.color);
    const auto exponent = static_cast<float>(look.density * look.extinction.g);
    for (std::size_t i = 0; i < opacity.size(); ++i) {
        std::uint8_t* pixel = &image.pixels[4 * i];
        if (opacity[i] <= 0.0f) continue;
        const glm::vec3 own = color * light(i);
        for (int c = 0; c < 3; ++c) pixel[c] = encode(table, own[c]);
        const float left = std::max(1.0f - opacity[i], least_transmission);
        pixel[3] = byte(255.0f * (1.0f - std::pow(left, exponent)));
    }
    return image;
}

Image composite_picture(const KeyingFrame& frame, const KeyingLook& look, std::span<const float> opacity,
                        const Image& background) {
    assert(opacity.size() == area(frame.size));
    Image image = picture_of(frame.size);
    const std::vector<std::uint8_t>& table = srgb_table();
    const std::array<float, 256>& decode = linear_table();
    const Light light(frame, look);
    const Backdrop backdrop(background, frame.size);
    const glm::vec3 color = linear(look.color), extinction = glm::vec3(look.density * look.extinction);
    for (int y = 0; y < frame.size.y; ++y)
        for (int x = 0; x < frame.size.x; ++x) {
            const std::size_t i = at(frame.size, {x, y});
            std::uint8_t* pixel = &image.pixels[4 * i];
            const std::uint8_t* behind = backdrop.pixel({x, y});
            pixel[3] = 255;
            if (opacity[i] <= 0.0f) {
                std::copy_n(behind, 3, pixel);
                continue;
            }
            const float thickness = -std::log(std::max(1.0f - opacity[i], least_transmission));
            const glm::vec3 own = color * light(i);
            for (int c = 0; c < 3; ++c) {
                const float transmission = std::exp(-thickness * extinction[c]);
                pixel[c] = encode(table, decode[behind[c]] * transmission + own[c] * (1.0f - transmission));
            }
        }
    return image;
}

}  // namespace lapfx
