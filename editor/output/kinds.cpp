#include "output/kinds.h"

#include "lapfx/authoring/letters.h"
#include "lapfx/rows.h"
#include "output/files.h"
#include "output/frame_files.h"

namespace lapfx::output {

namespace {

constexpr std::size_t longest_name = 255;

constexpr std::array<OutputRow, output_kind_count> rows = {{
    {.kind = OutputKind::preset,
     .title = "Preset",
     .help =
         "The preset alone, as a simulator reads it. Its clips must be in the same folder or below; otherwise make a "
         "bundle",
     .ending = "_tuned.json",
     .content = Content::document,
     .files = "Presets"},
    {.kind = OutputKind::bundle,
     .title = "Bundle",
     .help = "A new folder with the preset, its clips, a picture and, if wanted, the scene and its organ",
     .ending = "_bundle",
     .content = {},
     .command = "export.bundle",
     .command_title = "Export preset bundle...",
     .command_tip = "A folder with the preset and everything that it needs"},
    {.kind = OutputKind::picture,
     .title = "Picture",
     .help = "One PNG through the scene's camera",
     .ending = ".png",
     .content = Content::picture,
     .files = "Pictures",
     .command = "export.picture",
     .command_title = "Export picture...",
     .command_tip = "The current frame, as PNG",
     .example = "out.png",
     .is_name = is_picture_name,
     .frames = make_png_files},
    {.kind = OutputKind::sequence,
     .title = "Sequence",
     .help = "Numbered PNGs: %04d becomes a number with four digits",
     .ending = "_%04d.png",
     .content = Content::picture,
     .files = "Pictures",
     .example = "out_%04d.png",
     .numbered = true,
     .is_name = is_sequence_name,
     .frames = make_png_files},
    {.kind = OutputKind::video,
     .title = "Video",
     .help = "The ending of the name decides the format",
     .ending = ".mp4",
     .content = Content::video,
     .files = "Videos",
     .command = "export.video",
     .command_title = "Export video...",
     .command_tip = "The scene, or the part of it that plays, as a video",
     .example = "out.mp4",
     .is_name = is_video_name,
     .frames = make_video_frames},
}};

static_assert(rows_follow<&OutputRow::kind>(rows));

constexpr auto titles = [] {
    std::array<std::string_view, output_kind_count> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = rows[i].title;
    return all;
}();

}  // namespace

const std::array<OutputRow, output_kind_count>& output_rows() {
    return rows;
}

const OutputRow& row_of(OutputKind kind) {
    return rows[static_cast<std::size_t>(kind)];
}

const std::array<std::string_view, output_kind_count>& output_titles() {
    return titles;
}

std::string wanted_name(OutputKind kind) {
    const OutputRow& row = row_of(kind);
    const std::string title = lower_first(std::string(row.title));
    if (row.numbered) return "a " + title + " is named like " + std::string(row.example);
    const std::string names = listed(*row.content, " or ", true);
    return "a " + title + " is a" + (names.starts_with(".m") ? "n " : " ") + names;
}

std::optional<OutputKind> kind_named(const std::filesystem::path& name) {
    if (name.filename().native().size() > longest_name) return {};  // no file system allows it
    for (const OutputRow& row : rows)
        if (row.is_name != nullptr && row.is_name(name)) return row.kind;
    return {};
}

}  // namespace lapfx::output
