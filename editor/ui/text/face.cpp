#include "ui/text/face.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include FT_OUTLINE_H

#include "ui/value/closed_list.h"

namespace lapfx::ui {

namespace {

// From here on letters are large enough for whole px between them.
constexpr float whole_pixel_size = 24;

constexpr struct {
    Weight value;
    int fontconfig;
} weights[] = {
    {Weight::regular, FC_WEIGHT_REGULAR}, {Weight::medium, FC_WEIGHT_MEDIUM}, {Weight::bold, FC_WEIGHT_BOLD}};
static_assert(is_whole(weights));

int integer_of(const FcPattern* pattern, const char* name, int otherwise) {
    int value = otherwise;
    return FcPatternGetInteger(pattern, name, 0, &value) == FcResultMatch ? value : otherwise;
}

bool flag_of(const FcPattern* pattern, const char* name, bool otherwise) {
    FcBool value = FcFalse;
    return FcPatternGetBool(pattern, name, 0, &value) == FcResultMatch ? value == FcTrue : otherwise;
}

/// A face of coverage, not of colours: pictures (emoji) need another kind of texture.
bool drawable(const FcPattern* font) {
    return flag_of(font, FC_OUTLINE, false) && !flag_of(font, FC_COLOR, false);
}

Rendering rendering_of(const FcPattern* font, Hinting wanted) {
    if (wanted != Hinting::from_system) return {.hinting = wanted};
    Rendering rendering{.smooth = flag_of(font, FC_ANTIALIAS, true), .automatic = flag_of(font, FC_AUTOHINT, false)};
    const int style = flag_of(font, FC_HINTING, true) ? integer_of(font, FC_HINT_STYLE, FC_HINT_SLIGHT) : FC_HINT_NONE;
    rendering.hinting = style == FC_HINT_NONE     ? Hinting::none
                        : style == FC_HINT_SLIGHT ? Hinting::slight
                                                  : Hinting::full;
    return rendering;
}

FT_Int32 load_flags(const Rendering& rendering) {
    FT_Int32 flags = FT_LOAD_NO_BITMAP;
    if (rendering.hinting == Hinting::none) return flags | FT_LOAD_NO_HINTING;
    if (rendering.automatic) flags |= FT_LOAD_FORCE_AUTOHINT;
    if (!rendering.smooth) return flags | FT_LOAD_TARGET_MONO;
    return flags | (rendering.hinting == Hinting::slight ? FT_LOAD_TARGET_LIGHT : FT_LOAD_TARGET_NORMAL);
}

}  // namespace

Face::Face(FT_Library library, const std::string& file, int index, const Rendering& rendering, std::uint16_t id)
    : file_(file), index_(index), id_(id), rendering_(rendering) {
    FT_Face face = nullptr;
    if (FT_New_Face(library, file.c_str(), index, &face) != 0) throw std::runtime_error("no font: " + file);
    outlines_.reset(face);
    if (!FT_IS_SCALABLE(face)) throw std::runtime_error("a font without outlines: " + file);

    // The lower half of the index is the face in a collection, the upper half the named instance of a variable font.
    const Owned<hb_blob_t, hb_blob_destroy> blob(hb_blob_create_from_file(file.c_str()));
    const Owned<hb_face_t, hb_face_destroy> tables(hb_face_create(blob.get(), static_cast<unsigned>(index) & 0xffff));
    // Shaped in design units, so that advances know nothing of hinting and widths grow evenly with the size.
    shaping_.reset(hb_font_create(tables.get()));
    if ((index >> 16) > 0) hb_font_set_var_named_instance(shaping_.get(), static_cast<unsigned>(index >> 16) - 1);
    units_per_em_ = std::max(1U, hb_face_get_upem(tables.get()));
    hb_font_get_h_extents(shaping_.get(), &extents_);
}

bool Face::has(char32_t codepoint) const {
    hb_codepoint_t glyph = 0;
    return hb_font_get_nominal_glyph(shaping_.get(), codepoint, &glyph) != 0 && glyph != 0;
}

LineMetrics Face::metrics(float size) const {
    // Asked for with every text drawn, hence no call of std::round.
    const auto px = [factor = scale(size)](hb_position_t units) {
        return static_cast<float>(static_cast<int>(static_cast<float>(std::max(0, units)) * factor + 0.5F));
    };
    LineMetrics metrics{.ascent = px(extents_.ascender), .descent = px(-extents_.descender)};
    metrics.height = metrics.ascent + metrics.descent + px(extents_.line_gap);
    return metrics;
}

int Face::phases(float size) const {
    // Full hinting puts stems on whole px; any other position would smear them again.
    return size < whole_pixel_size && rendering_.smooth && rendering_.hinting != Hinting::full ? 4 : 1;
}

const Face::Bitmap& Face::rasterise(std::uint32_t glyph, std::uint16_t size_quarters, int phase) {
    bitmap_.width = bitmap_.height = 0;
    FT_Face face = outlines_.get();
    if (size_set_ != size_quarters) {
        // FreeType counts in 1/64 px at 72 dpi.
        if (FT_Set_Char_Size(face, 0, FT_F26Dot6{size_quarters} * 16, 72, 72) != 0) return bitmap_;
        size_set_ = size_quarters;
    }
    if (FT_Load_Glyph(face, glyph, load_flags(rendering_)) != 0) return bitmap_;
    FT_GlyphSlot slot = face->glyph;
    if (slot->format != FT_GLYPH_FORMAT_OUTLINE) return bitmap_;
    FT_Outline_Translate(&slot->outline, phase * 64 / phases(static_cast<float>(size_quarters) / 4), 0);
    if (FT_Render_Glyph(slot, rendering_.smooth ? FT_RENDER_MODE_NORMAL : FT_RENDER_MODE_MONO) != 0) return bitmap_;

    const FT_Bitmap& rendered = slot->bitmap;
    const auto width = static_cast<int>(rendered.width), height = static_cast<int>(rendered.rows);
    bitmap_.left = slot->bitmap_left, bitmap_.top = slot->bitmap_top;
    bitmap_.width = width, bitmap_.height = height;
    bitmap_.coverage.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        const std::uint8_t* from = rendered.buffer + std::ptrdiff_t{y} * rendered.pitch;
        std::uint8_t* to = bitmap_.coverage.data() + std::ptrdiff_t{y} * width;
        for (int x = 0; x < width; ++x) {
            to[x] = rendered.pixel_mode == FT_PIXEL_MODE_GRAY ? from[x]
                    : (from[x / 8] >> (7 - x % 8) & 1) != 0   ? 255
                                                              : 0;
        }
    }
    return bitmap_;
}

Faces::Faces(const FontOptions& options) : options_(options), config_(FcInitLoadConfigAndFonts()) {
    // The configuration is our own, not fontconfig's shared one: it is read for this object and freed with it.
    FT_Library library = nullptr;
    if (config_ == nullptr || FT_Init_FreeType(&library) != 0) throw std::runtime_error("fonts cannot be read");
    library_.reset(library);
    opened(0);
}

Face& Faces::base(std::uint8_t which) {
    return *opened(which).face;
}

Faces::Base& Faces::opened(std::uint8_t which) {
    Base& base = bases_[which];
    if (base.face != nullptr) return base;
    const std::string& family = which % 2 == 1 ? options_.monospace : options_.family;
    base.pattern.reset(FcPatternCreate());
    FcPattern* pattern = base.pattern.get();
    FcPatternAddString(pattern, FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
    // For when there is no such family.
    FcPatternAddString(pattern, FC_FAMILY,
                       reinterpret_cast<const FcChar8*>(which % 2 == 1 ? "monospace" : "sans-serif"));
    FcPatternAddInteger(pattern, FC_WEIGHT, weights[which / 2].fontconfig);
    FcPatternAddInteger(pattern, FC_SLANT, FC_SLANT_ROMAN);
    FcPatternAddBool(pattern, FC_OUTLINE, FcTrue);
    FcPatternAddBool(pattern, FC_COLOR, FcFalse);
    FcPatternAddBool(pattern, FC_VARIABLE,
                     FcFalse);  // named instances of variable fonts rather than all of their range
    FcConfigSubstitute(config_.get(), pattern, FcMatchPattern);
    FcDefaultSubstitute(pattern);

    FcResult result = FcResultNoMatch;
    const OwnedPattern match(FcFontMatch(config_.get(), pattern, &result));
    Face* face = match != nullptr && drawable(match.get()) ? open(match.get()) : nullptr;
    if (face == nullptr) face = search(base, U'0');
    if (face == nullptr) throw std::runtime_error("the system has no font for " + family);
    base.face = face;
    return base;
}

const FcFontSet* Faces::sorted(Base& base) {
    if (base.others == nullptr) {
        FcResult result = FcResultNoMatch;
        base.others.reset(FcFontSort(config_.get(), base.pattern.get(), FcFalse, nullptr, &result));
    }
    return base.others.get();
}

Face* Faces::open(FcPattern* font) {
    FcChar8* file = nullptr;
    if (FcPatternGetString(font, FC_FILE, 0, &file) != FcResultMatch) return nullptr;
    const std::string name(reinterpret_cast<const char*>(file));
    const int index = integer_of(font, FC_INDEX, 0);
    for (const auto& face : faces_) {
        if (face->file() == name && face->index() == index) return face.get();
    }
    try {
        faces_.push_back(std::make_unique<Face>(library_.get(), name, index, rendering_of(font, options_.hinting),
                                                static_cast<std::uint16_t>(faces_.size())));
    } catch (const std::runtime_error&) {
        return nullptr;  // removed since fontconfig looked, or broken: the next best does
    }
    return faces_.back().get();
}

Face* Faces::search(Base& base, char32_t codepoint) {
    const FcFontSet* fonts = sorted(base);
    for (int i = 0; fonts != nullptr && i < fonts->nfont; ++i) {
        FcPattern* font = fonts->fonts[i];
        FcCharSet* characters = nullptr;
        if (!drawable(font) || FcPatternGetCharSet(font, FC_CHARSET, 0, &characters) != FcResultMatch ||
            FcCharSetHasChar(characters, codepoint) == FcFalse) {
            continue;
        }
        // The user's settings for this font, such as hinting, are not in the list but made by this.
        const OwnedPattern prepared(FcFontRenderPrepare(config_.get(), base.pattern.get(), font));
        Face* face = prepared != nullptr ? open(prepared.get()) : nullptr;
        if (face != nullptr && face->has(codepoint)) return face;
    }
    return nullptr;
}

Face* Faces::face_of(char32_t codepoint, std::uint8_t which) {
    Base& base = opened(which);
    if (base.face->has(codepoint)) return base.face;
    const auto known = base.fallback.find(codepoint);
    if (known != base.fallback.end()) return known->second;
    return base.fallback[codepoint] = search(base, codepoint);
}

}  // namespace lapfx::ui
