#include "commands/help_topics.h"

#include <algorithm>

#include "app/tuning/parameters.h"
#include "commands/help_tour.h"
#include "commands/session.h"
#include "lapfx/authoring/formats.h"
#include "lapfx/authoring/letters.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"
#include "lapfx/tool.h"
#include "lapfx/view.h"
#include "output/kinds.h"

namespace lapfx::commands {

namespace {

/// "a number from 0 to 60 mm/s; default 4". `owner`: a struct with its defaults.
std::string facts_of(const Parameter& row, const void* owner) {
    std::string facts = row.expected();
    if (row.required) return facts + "; required";
    if (!row.same_as.empty()) return facts + "; default: the same as " + std::string(row.same_as);
    const std::string standard = app::text_of(row, row.get(owner));
    return standard.empty() ? facts : facts + "; default " + standard;
}

/// "no smoke" as "No smoke."
std::string sentence(std::string_view words) {
    return upper_first(std::string(words)) + '.';
}

std::string joined(const std::string& parent, std::string_view key) {
    return parent.empty() ? std::string(key) : parent + '.' + std::string(key);
}

/// Sections for `table` and the tables in it. `owner`: a struct with its defaults; its lists are changed.
void add_table(std::vector<HelpSection>& sections, const Table& table, const std::string& key, void* owner) {
    HelpSection section{
        .title = key.empty() ? "At the top" : key, .paragraphs = {}, .facts_title = "allowed; default", .rows = {}};
    if (!key.empty()) section.paragraphs.push_back(std::string(table.help));
    if (table.list != nullptr)
        section.paragraphs.push_back("A list of at most " + std::to_string(table.list->maximum) + ". " + key +
                                     ".0 is the first one, also for --set.");
    if (table.present != nullptr) section.paragraphs.push_back("It may be left out.");
    for (const Parameter& row : table.rows)
        section.rows.push_back({std::string(row.key), facts_of(row, owner), std::string(row.help)});
    if (!section.rows.empty() || !section.paragraphs.empty()) sections.push_back(std::move(section));
    for (const Table& child : table.tables) {
        void* member = child.member(owner);
        if (child.list != nullptr) {
            child.list->resize(member, 1);  // a new element has the defaults
            member = child.list->at(member, 0);
        }
        add_table(sections, child, joined(table.list != nullptr ? key + ".0" : key, child.key), member);
    }
}

/// By their own names and descriptions.
HelpSection shipped_presets() {
    HelpSection section{.title = "Presets that come with lapfx", .paragraphs = {}, .facts_title = {}, .rows = {}};
    std::error_code code;
    for (const auto& entry : std::filesystem::directory_iterator(data_folder() / "presets", code)) {
        const std::filesystem::path& file = entry.path();
        if (file.extension() != ".json" || file.stem().extension() == ".schema") continue;
        const Preset preset = load_preset(file);
        section.rows.push_back({"presets/" + file.filename().string(), {}, preset.name + ". " + preset.description});
    }
    std::sort(section.rows.begin(), section.rows.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return section;
}

std::vector<HelpSection> preset_sections() {
    std::vector<HelpSection> sections{
        {.title = "Presets",
         .paragraphs =
             {"A preset is the JSON file that a simulator takes: {\"format\": \"lapfx.preset\", \"version\": 1, "
              "\"bleeding\": {\"speed\": 6}}. A key that is missing has its default. Unknown keys, wrong types and "
              "values out of range are faults, and `lapfx check` prints all of them. `lapfx migrate` writes every key "
              "out.",
              "Blood: speed (mm/s) and max_extent (mm) are what the picture shows, on every mesh and at every frame "
              "rate. Edges longer than 2 mm are split before anything bleeds or burns; tissue that nothing has "
              "happened to is still drawn with the triangles of the file.",
              "Vessels: density is found in the textures or vertex colours of the organ. A cut bleeds where the "
              "density around the tip reaches vessel_threshold, and more where it is higher (vessel_strength). "
              "Vessels that are redder than the tissue around them are found on any organ; for blue and pale ones "
              "set vessel_color and vessel_tolerance. Where an organ shows no vessels, such as one of a single "
              "colour, every cut bleeds equally, and `lapfx inspect` says so.",
              "Heat: what several tools give at one place adds; nothing cold undoes a burn; a wound is there once. A "
              "hot tool "
              "closes a wound whose tissue is between the coagulation and the cut temperature, unless its own heat was "
              "there when the wound opened. At their defaults the models radial and bioheat burn equally: the burnt "
              "areas are within 20 % from 0.5 to 8 s at powers from 0.3 to 1.",
              "Smoke: clips are videos of smoke on a plain background, and keying says what in a frame is smoke. A "
              "preset without clips makes no smoke. `lapfx inspect --keying` suggests keying for a clip. crop, masks "
              "and edge_fade leave out bars, logos and hard edges."},
         .facts_title = {},
         .rows = {}},
        shipped_presets()};
    Preset defaults;
    add_table(sections, preset_table(), "", &defaults);
    return sections;
}

std::vector<HelpSection> scene_sections() {
    std::vector<HelpSection> sections{
        {.title = "Scenes",
         .paragraphs = {"A scene is the JSON file in which a preset is previewed: organ, camera, lamp, instrument, "
                        "tool events, the reference video, and curves over time. A simulator never needs one. Names "
                        "of files are relative to the scene."},
         .facts_title = {},
         .rows = {}}};
    Scene defaults;
    add_table(sections, scene_table(), "", &defaults);
    return sections;
}

std::vector<HelpSection> tool_sections() {
    HelpSection section{.title = "Actions of the tool",
                        .paragraphs = {"What an event of a scene or a sample of a haptic thread does to the organ. "
                                       "How far around the tip it works is a parameter of the preset."},
                        .facts_title = "how far; key in the editor",
                        .rows = {}};
    for (const ToolActionRow& row : tool_actions)
        section.rows.push_back(
            {std::string(row.key), std::string(row.reach) + "; key " + row.shortcut, sentence(row.help)});
    return {section};
}

std::vector<HelpSection> overlay_sections() {
    HelpSection section{.title = "Overlays",
                        .paragraphs = {"False colour over the tissue, for `lapfx render --overlay` and the editor."},
                        .facts_title = "key in the editor",
                        .rows = {}};
    for (const OverlayRow& row : overlays)
        section.rows.push_back(
            {std::string(row.key), row.shortcut == 0 ? "" : std::string("key ") + row.shortcut, sentence(row.help)});
    return {section};
}

std::vector<HelpSection> file_sections() {
    HelpSection section{
        .title = "Files that lapfx reads",
        .paragraphs =
            {"glTF is in metres; other meshes are in mm unless organ.scale of the scene says otherwise. A smoke clip "
             "or a reference may be any video that FFmpeg decodes: with alpha, with a variable frame rate, a single "
             "image, or numbered images (smoke_%04d.png).",
             "A video is shown as an ordinary display shows it: HDR (PQ, HLG) and wide gamuts (BT.2020, P3) are "
             "converted "
             "to BT.709, and 203 cd/m2 are white; interlaced frames are deinterlaced; OpenEXR is read as linear light; "
             "pictures are turned as their EXIF data say; where the clock of a video jumps by hours, or back, it plays "
             "on. `lapfx inspect` says what a file holds and what is done, and colours that are not converted are told "
             "before any figure.",
             "Files may come from strangers. What an organ or a preset names must be in its own folder or below, "
             "after symbolic links are followed, and is used only if it is what it should be: an image that decodes, "
             "a clip, a mesh. A clip with a bare name is also looked up among the clips of lapfx, by a host in the "
             "folders "
             "that a host sets. The organ, tool, preset and reference of a scene may be anywhere, because a person "
             "has chosen them: `lapfx inspect` says which are elsewhere, and the export of a bundle lists them and "
             "asks before it copies them. A bundle contains only what was read as such, under names that the export "
             "makes.",
             "A clip that is broken in the middle or ends early continues with its last good frame; `lapfx render` "
             "and Effects::clips() report it. `lapfx inspect` decodes a clip completely and says which out point "
             "avoids broken frames.",
             "The presets, samples and shaders that come with lapfx are found beside the program, in ../share/lapfx or "
             "share/lapfx, or in the folder that the environment variable LAPFX_DATA names.",
             "Every file that lapfx writes appears complete under its name or not at all. What a killed process has "
             "left is removed by the next one that writes into the same folder."},
        .facts_title = {},
        .rows = {}};
    for (const Content content : {Content::mesh, Content::video, Content::picture, Content::document})
        for (const FileFormat& format : formats(content)) {
            std::string names;
            for (const std::string_view extension : format.extensions)
                names += (names.empty() ? "" : " ") + std::string(extension);
            section.rows.push_back({names, {}, std::string(format.name) + ": " + std::string(format.holds)});
        }
    return {section};
}

std::vector<HelpSection> output_sections() {
    HelpSection section{.title = "What the editor exports and lapfx render writes",
                        .paragraphs = {"The name decides the kind: -o out.png, out_%04d.png or out.mp4. Videos are " +
                                       listed(Content::video, " or ", true) + '.'},
                        .facts_title = "ending of the proposed name",
                        .rows = {}};
    for (const output::OutputRow& row : output::output_rows())
        section.rows.push_back({std::string(row.title), std::string(row.ending), sentence(row.help)});
    return {section};
}

constexpr HelpTopic topics[] = {
    {"tour", "What can be done in the editor, step by step", tour_sections},
    {"preset", "Every key of a preset with its range, unit and default; the presets that come with lapfx",
     preset_sections},
    {"scene", "Every key of a scene with its range, unit and default", scene_sections},
    {"tool", "What a tool does to the organ", tool_sections},
    {"overlays", "False colours over the tissue", overlay_sections},
    {"files", "Meshes, videos and images that lapfx reads, and what it does with odd ones", file_sections},
    {"outputs", "What is exported, and under which names", output_sections},
};

}  // namespace

std::span<const HelpTopic> help_topics() {
    return topics;
}

}  // namespace lapfx::commands
