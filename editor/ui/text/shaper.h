// From bytes to placed glyphs: decoding, a face for every character, HarfBuzz, places for the caret. Private to text/.
#pragma once

#include "ui/text/glyphs.h"

namespace lapfx::ui {

class Shaper {
  public:
    Shaper(Faces& faces, Glyphs& glyphs);

    /// Fills an empty run. Glyphs that the atlas has no room for are left out; Glyphs::full() says so then.
    void shape(std::string_view text, StyleKey style, Run& run);

  private:
    struct Letter {
        char32_t codepoint;
        std::uint32_t byte;
        Face* face;  ///< nullptr: no font has it
        hb_script_t script;
        bool starts_cluster;  ///< it is the first of a cluster, as next_character() parts them
    };

    void read(std::string_view text);
    void choose_faces(std::uint8_t base);
    void choose_scripts();
    void place(std::size_t first, std::size_t last, StyleKey style, Run& run);
    void place_box(const Letter& letter, StyleKey style, Run& run);
    void add_stop(const Letter& letter, Run& run);
    void add(const Glyph& glyph, int x, int y, Run& run);
    void apply_features(Face& face, hb_script_t script, bool tabular);
    float widest_digit(Face& face);

    Faces& faces_;
    Glyphs& glyphs_;
    Owned<hb_buffer_t, hb_buffer_destroy> buffer_;
    std::vector<Letter> letters_;
    double pen_ = 0;  ///< px from the start of the run
};

}  // namespace lapfx::ui
