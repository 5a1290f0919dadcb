// lapfx bench measure --learn FILE: learns the model of the mean veil (match/frame/veil_model.h).
//
// Method: renders of ours with smoke of the core (stills and clips, as the bench measures them, and courses: many
// moments under a still camera), and known veils laid over clear renders of ours whose camera and instrument move
// (over.cpp), which have light and shape of the smoke that our presets do not have. Each is measured as
// the bench does, and the figures of the estimator are the inputs. With --over the veils are laid over those files in
// place of our renders, to compare: such a model is not shipped, since nothing of other people's frames is to be in it.
#include <cstdio>
#include <map>

#include "bench/benches.h"
#include "bench/measure/each.h"
#include "bench/measure/over.h"
#include "bench/measure/renders.h"
#include "bench/scratch_folder.h"
#include "commands/options.h"
#include "commands/progress.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/video.h"
#include "match/frame/veil_model.h"

namespace lapfx::bench {

namespace {

struct Extent {
    int stills, clips, pictures_of_clip, courses, pictures_of_course, clear_clips, composites;
};
/// Of the random numbers: no picture that the bench measures is learned from, whatever the seeds.
constexpr std::uint32_t learned_part = 100;
constexpr Extent whole{100, 20, 30, 40, 10, 50, 8}, least{2, 1, 12, 1, 4, 6, 10};

class Lessons {
  public:
    void add(const KnownView& view) {
        measure_each(
            view, {},
            [this](const KnownPicture& known, const match::Estimator& estimator, const match::FrameAmounts& amounts) {
                if (amounts.measurable())
                    examples_.push_back({.figures = estimator.veil_figures(), .veil = known.veil, .view = subject_});
            });
    }
    /// What is added from now on is of this subject: one render, one operation. It is left out together.
    void begin(int subject) { subject_ = subject; }
    /// Veils over the frames of a clear video or picture.
    void add_over(const std::filesystem::path& file, int seed, int number, int composites) {
        OverCounts counts;
        for (const KnownView& view : known_over(file, static_cast<std::uint32_t>(seed), number, composites, counts))
            add(view);
    }
    const std::vector<match::VeilExample>& examples() const { return examples_; }

  private:
    std::vector<match::VeilExample> examples_;
    int subject_ = 0;
};

}  // namespace

BenchReport bench_measure_learn(const BenchOptions& options) {
    const Extent& extent = options.short_form ? least : whole;
    commands::check_output("--learn", options.learn);  // before anything is rendered
    for (const std::string& file : options.over) const VideoReader opened(file);
    const Context context = Context::create(Backend::automatic);
    KnownRenders renders(static_cast<std::uint32_t>(options.seed), learned_part);
    Lessons lessons;
    int subject = 0;
    if (options.over.empty()) {
        commands::Progress progress("rendering and measuring",
                                    extent.stills + extent.clips + extent.courses + extent.clear_clips);
        const ScratchFolder folder;
        for (int i = 0; i < extent.stills; ++i, progress.step()) {
            lessons.begin(subject++);
            lessons.add(renders.still(i));
        }
        for (int i = 0; i < extent.clips; ++i, progress.step()) {
            lessons.begin(subject++);
            lessons.add(renders.clip(i, extent.pictures_of_clip));
        }
        for (int i = 0; i < extent.courses; ++i, progress.step()) {
            lessons.begin(subject++);
            lessons.add(renders.course(i, extent.pictures_of_course));
        }
        for (int i = 0; i < extent.clear_clips; ++i, progress.step()) {
            const std::filesystem::path file = folder.path() / "clear.mp4";
            renders.write_clear(i, file);
            lessons.begin(subject++);
            lessons.add_over(file, options.seed, i, extent.composites);
        }
    } else {
        commands::Progress progress("measuring over real frames", static_cast<int>(options.over.size()));
        int number = 0;
        std::map<std::string, int> operations;
        for (const std::string& file : options.over) {
            lessons.begin(operations.emplace(operation_of(file), static_cast<int>(operations.size())).first->second);
            lessons.add_over(file, options.seed, number++, extent.composites);
            progress.step();
        }
    }
    const match::VeilModel model = match::VeilModel::learn(
        lessons.examples(), (options.over.empty() ? "renders" : "known veils over files") + std::string(" of seed ") +
                                std::to_string(options.seed) + " by lapfx bench measure --learn");
    write_file(options.learn, model.json());

    const match::VeilModelError& error = model.error();
    BenchReport report{.bench = "measure", .renderer = context.renderer(), .rows = {}, .ratios = {}, .table = {}};
    report.rows.push_back({.of = {{"model", "mean veil"}},
                           .measured = {{"pictures", static_cast<double>(lessons.examples().size())},
                                        {"mean_absolute_error", error.mean_absolute},
                                        {"bias", error.bias},
                                        {"correlation", error.correlation}}});
    char line[200];
    std::snprintf(line, sizeof line,
                  "learned from %zu pictures; on views left out: mean absolute error %.4f, bias %+.4f, r %.3f\n",
                  lessons.examples().size(), error.mean_absolute, error.bias, error.correlation);
    report.table = line;
    return report;
}

}  // namespace lapfx::bench
