// Exports presets, bundles, pictures and videos with the code of `lapfx render`, one frame at a time, while the editor
// can be used. It exports a copy of the document made at the start, so a person can continue to edit. A file appears
// only when it is complete and has been read back.
//
//     exports.propose(OutputKind::video);
//     exports.form.fps = 30;
//     if (exports.faults().empty()) exports.start();
//     each frame: exports.update(now);   // Editor::frame
#pragma once

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/editor_options.h"
#include "app/base/settling.h"
#include "document/document.h"
#include "lapfx/error.h"
#include "output/bundle.h"
#include "output/bundle_sources.h"
#include "output/render_job.h"

namespace lapfx::app {

class FileChooser;
class ExportTrial;
class Job;
class Jobs;
class Measuring;
class Notices;
class PreviewHost;
class Reference;
class Screen;
class Settings;
class Timeline;
struct Looking;

using output::OutputKind;

struct ExportSize {
    std::string_view name;
    glm::ivec2 px;
};
/// The last one is for a size that the person types.
inline constexpr std::array<ExportSize, 7> export_sizes = {{
    {"1280 x 1024 (5:4)", {1280, 1024}},
    {"1920 x 1080 (Full HD)", {1920, 1080}},
    {"3840 x 2160 (4K)", {3840, 2160}},
    {"1280 x 720 (HD)", {1280, 720}},
    {"720 x 576 (PAL)", {720, 576}},
    {"640 x 512", {640, 512}},
    {"Free", {0, 0}},
}};

/// What the dialog asks for.
struct ExportForm {
    int kind = 0;                                              ///< an OutputKind
    std::array<std::string, output::output_kind_count> files;  ///< of each kind: file, folder, or pattern of a sequence
    bool with_scene = true;                                    ///< of a bundle
    int size = 0;                                              ///< of export_sizes
    int width = 1280, height = 1024;                           ///< px, where the size is free
    double at = 0, from = 0, to = 0;                           ///< s
    double fps = 25;
    bool outside_agreed = false;  ///< the person has agreed to copy what Exports::outside() lists
    bool overlay = false;         ///< with what the view shows over the tissue
    bool beside = false;          ///< the reference beside each picture, and below them the curves of both
    int codec = 0;                ///< an output::Codec, of a video
    int quality = static_cast<int>(output::Quality::good);  ///< of a codec that is not lossless
    bool amounts = false;
    std::string amounts_file;

    OutputKind what() const { return static_cast<OutputKind>(kind); }
    std::string& file() { return files[static_cast<std::size_t>(kind)]; }
    const std::string& file() const { return files[static_cast<std::size_t>(kind)]; }
    glm::ivec2 px() const;
    output::Codec coded() const { return static_cast<output::Codec>(codec); }
    bool renders() const { return output::row_of(what()).frames != nullptr; }
    friend bool operator==(const ExportForm&, const ExportForm&) = default;
};

/// To the millisecond, as it is shown and written into commands: what is rendered is what is shown.
double shown_time(double time);

class Exports {
  public:
    /// Opens what was exported, where a person asks for that.
    using Open = std::function<void(const std::vector<std::string>& files)>;

    /// All must outlive it.
    struct Parts {
        const document::Document& document;
        const Timeline& timeline;
        const Looking& looking;
        const Reference& reference;
        const Measuring& measuring;
        PreviewHost& preview;
        Jobs& jobs;
        Settings& settings;
        FileChooser& chooser;
        Notices& notices;
        Screen& screen;
        const EditorOptions& options;
    };
    Exports(const Parts& parts, Open open);
    ~Exports();
    Exports(const Exports&) = delete;
    Exports& operator=(const Exports&) = delete;

    ExportForm form;

    /// The title of the dialog that asks for a file of that kind.
    static std::string title(OutputKind kind);
    /// Fills in what the person has not set yet: names where such files were written last, beside the person's own
    /// preset or among their documents; the time that is shown, the range of play.
    void propose(OutputKind kind);
    /// What is wrong with the form as it is. Places are the options of `lapfx render`: "-o", "--size".
    const std::vector<Fault>& faults();
    std::string_view fault_at(std::string_view place);  ///< its reason; empty: nothing is wrong there
    /// Whether something of that name is there and will be replaced.
    bool replaces() const { return replaces_; }
    /// What a bundle would copy from outside the folder of its scene (without one: of the preset), other than files
    /// that came with lapfx. As of the last faults(). A person has to agree to it (ExportForm::outside_agreed), and
    /// again when it changes.
    const std::vector<output::SourceFile>& outside() const { return outside_; }
    std::filesystem::path home() const;  ///< that folder; empty: it was never saved, so everything is outside
    int frames() const;
    double duration() const;        ///< s, of the scene
    bool overlaid() const;          ///< the view shows something over the tissue, which can be drawn, too
    bool comparable() const;        ///< there is a reference that can lie beside
    glm::ivec2 written_px() const;  ///< of what is written of each frame
    /// While the UI is built, by whoever shows seconds_expected(): a few frames are tried, unless something runs. Gives
    /// the time, s, at which it wants another frame; infinity: it comes by itself.
    double want_estimate();
    /// s that the export as it is in the form will take, without measuring; negative: not known, yet or at all.
    double seconds_expected() const;

    /// Starts the export; with faults in the form it does nothing. What goes wrong later is told by toasts. A preset is
    /// written at once, whatever is running; of the rest there is one at a time.
    void start();
    /// The form has to wait for what is running.
    bool waits() const { return running() && form.what() != OutputKind::preset; }
    bool running() const { return static_cast<bool>(running_); }
    void cancel();
    double progress() const;            ///< 0..1; while loading(), that of loading; negative: unknown
    bool loading() const;               ///< files are read, or both are measured; nothing is drawn yet
    const Job* job() const;             ///< the one that loads, measures or copies for it now; null: none
    std::string progress_text() const;  ///< "12 of 300 frames"
    std::string_view name() const;      ///< what is being written has this name
    double seconds_left() const;        ///< s; negative: not known

    /// The command line that makes the same. Throws Error (bad_input) when it could not: scene or preset are not saved.
    std::string command() const;

    /// Once before each frame. `now`: s.
    void update(double now);

  private:
    struct Running;
    /// What the cost of a frame depends on.
    struct TriedOf {
        glm::ivec2 px{0};
        double fps = 0, from = 0;
        bool overlay = false;
        int codec = 0, quality = 0;
        std::string ending = {};
        std::uint64_t document = 0, organ = 0;
        friend bool operator==(const TriedOf&, const TriedOf&) = default;
    };
    bool compares() const { return form.beside && form.renders() && comparable(); }
    output::RenderOptions render_options() const;
    void look_at_form();
    void look_outside();
    void check_preset_file(std::vector<Fault>& faults) const;
    void load();
    void make_page();
    void begin();
    TriedOf tried_of() const;
    void follow_estimate();
    bool try_frames();
    void begin_copying();
    void step();
    std::string proposed(OutputKind kind, std::string_view ending) const;
    void export_preset();
    void end(const std::string& what);
    void tell_made(const ExportForm& made, const std::string& text);
    void fail(const std::vector<Fault>& faults);

    const Parts parts_;
    const Open open_;
    std::unique_ptr<Running> running_;
    bool estimate_wanted_ = false;
    TriedOf tried_of_;
    std::unique_ptr<ExportTrial> trial_;  ///< of it; null: none yet, or it failed
    Settling settling_{0.5};              ///< of tried_of_
    bool trial_failed_ = false;
    ExportForm checked_;  ///< what faults_ is of
    std::uint64_t checked_version_ = 0, checked_organ_ = 0;
    bool checked_comparable_ = false;
    std::vector<Fault> faults_;
    std::vector<output::SourceFile> outside_;
    bool replaces_ = false;
    std::string proposed_for_;  ///< file and name of the preset that the proposed names were made from
    double now_ = 0;
};

}  // namespace lapfx::app
