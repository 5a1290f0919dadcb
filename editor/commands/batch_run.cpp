#include "commands/batch_run.h"

#include <chrono>
#include <limits>
#include <optional>
#include <ostream>
#include <sstream>

#include "commands/batch_result.h"
#include "commands/content_hash.h"
#include "commands/file_kind.h"
#include "commands/options.h"
#include "commands/progress.h"
#include "commands/session.h"
#include "document/lock.h"
#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/pack.h"
#include "lapfx/authoring/printable.h"
#include "match/report/markup.h"
#include "match/report/report_pictures.h"

namespace lapfx::commands {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

/// What is fitted to what, for one item; a video without a scene is measured.
struct Job {
    FitOptions options;
    bool fitted = false;
};

Job job_of(const BatchRunOptions& o, const BatchItem& item) {
    Job job{.options = o.fit, .fitted = item.kind == ItemKind::scene || !o.fit.files.scene.empty()};
    FitFiles& files = job.options.files;
    const fs::path folder = folder_of(o.results, item);
    files.output = folder / preset_name, files.fitted_scene = folder / fitted_scene_name;
    files.csv = folder / curves_name, files.report = folder / report_name;
    const std::string file = o.folder / item.name;
    (item.kind == ItemKind::scene ? files.scene : files.reference) = file;
    return job;
}

/// A scene is fitted to its own reference. Returns why it cannot be found.
std::optional<Error> find_reference(Job& job) {
    FitFiles& files = job.options.files;
    if (!files.reference.empty()) return {};
    const char* place = "/reference/file";
    try {
        const Scene scene = load_scene(files.scene);
        if (scene.reference.file.empty())
            throw Error(Failure::bad_input,
                        Fault{.file = files.scene,
                              .place = place,
                              .reason = "is missing; a scene is fitted to the reference that it names"});
        files.reference = named_path(scene.folder, scene.reference.file, Reach::anywhere, files.scene, place);
        return {};
    } catch (const Error& error) {
        return error;
    }
}

Preset preset_of(const FitFiles& files, const Scene& scene) {
    return preset_for(scene, files.preset, {});
}

std::string said(const std::optional<double>& value) {
    return value ? std::to_string(*value) : "none";
}

void add_fit(ContentHash& hash, const FitOptions& o) {
    hash.add(o.parameters);
    hash.add(said(o.match.offset) + ' ' + std::to_string(o.seed) + ' ' + std::to_string(o.budget) +
             (o.colors ? " colors" : ""));
    hash.add_file(o.files.scene);
    const Scene scene = load_scene(o.files.scene);
    for (const fs::path& file : read_files(o.files, scene)) hash.add_file(file);
    for (const std::string& mesh : {scene.organ.file, scene.tool.file})  // the files that a scene names are read, too
        if (!mesh.empty())
            for (const PackedFile& file : pack_organ(named_path(scene.folder, mesh, Reach::anywhere)))
                hash.add({reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()});
    const Preset preset = preset_of(o.files, scene);
    for (const SmokeClip& clip : preset.smoke.clips) hash.add_file(find_clip(clip.file, preset.folder, clip_folders()));
}

/// Where an input cannot be read, of what can be: its fault is recorded with it, and told anew when that has changed.
std::string input_of(const Job& job) {
    ContentHash hash;
    hash.add(job.fitted ? "fitted" : "measured");
    hash.add(job.options.match.window);
    hash.add(said(job.options.match.baseline));
    hash.add(job.options.match.view);
    if (!job.options.files.reference.empty()) hash.add_file(job.options.files.reference);
    try {
        if (job.fitted) add_fit(hash, job.options);
    } catch (const Error& error) {
        hash.add(error.what());
    }
    return hash.text();
}

/// The preset that is written lies beside the report, and finds its own clips there: the same files, or copies where
/// the disk is another. `brought`: what was put there.
void bring_clips(const FitFiles& files, std::vector<fs::path>& brought) {
    const Scene scene = load_scene(files.scene);
    const Preset preset = preset_of(files, scene);
    const fs::path to = fs::path(files.output).parent_path();
    for (const SmokeClip& clip : preset.smoke.clips) {
        const fs::path found = find_clip(clip.file, preset.folder, clip_folders());
        if (!lies_in(preset.folder, found)) continue;
        std::vector<fs::path> images = clip_images(found);
        if (images.empty()) images.push_back(found);
        for (const fs::path& image : images) {
            const fs::path place = to / fs::path(clip.file).parent_path() / image.filename();
            std::error_code error;
            if (fs::weakly_canonical(place, error) == fs::canonical(image, error)) continue;  // the file itself
            brought.push_back(place);
            if (is_same_file(image, place)) continue;
            fs::remove(place, error);  // a run before may have left it, with another clip
            fs::create_directories(place.parent_path(), error);
            fs::create_hard_link(fs::canonical(image, error), place, error);
            if (error) write_file(place, read_file(image, std::numeric_limits<std::size_t>::max()));
        }
    }
}

/// What was found for an item may be where the next fit of it begins, but not while it is replaced.
void check_reads(const Job& job, const fs::path& folder) {
    std::vector<fs::path> files;
    try {
        if (job.fitted) files = read_files(job.options.files, load_scene(job.options.files.scene));
    } catch (const Error&) {
        return;  // told by the fit
    }
    for (const fs::path& file : files)
        if (lies_in(folder, file))
            throw Error(Failure::bad_input, Fault{.file = file.string(),
                                                  .place = "",
                                                  .reason = "is a result of this item, which would be replaced: copy "
                                                            "it to another place"});
}

void remove_files(const fs::path& folder) {
    std::error_code none;
    // The mark that it is done goes first.
    for (const char* name : {result_name, report_name, curves_name, amounts_name, fitted_scene_name, preset_name})
        fs::remove(folder / name, none);
}

/// Folders that are empty then go, too.
void remove_clips(const fs::path& folder, const std::vector<fs::path>& brought) {
    std::error_code none;
    for (const fs::path& clip : brought) {
        fs::remove(clip, none);
        for (fs::path in = clip.parent_path(); in != folder && fs::is_empty(in, none); in = in.parent_path())
            if (!fs::remove(in, none)) break;
    }
}

BatchAmount amount_of(const match::Episode& episode) {
    return {.peak = episode.peak, .mean = episode.mean};
}

std::string picture_name(const char* what, double time) {
    return what + (" at " + match::seconds_text(time));
}

/// Of the first moment, which is the one with most blood or veil.
void take_pictures(BatchResult& result, const match::FitReport& report) {
    if (report.moments.empty()) return;
    const match::ReportMoment& moment = report.moments.front();
    for (const auto& [name, jpeg] : {std::pair{"Reference", &moment.reference}, std::pair{"After", &moment.after}})
        if (!jpeg->empty()) result.pictures.push_back({picture_name(name, moment.time), match::small_jpeg(*jpeg)});
}

void fit(const Job& job, BatchResult& result) {
    FitRun run = run_fit(job.options);
    write_file(fs::path(job.options.files.output).parent_path() / amounts_name, match::csv_of(run.measured));
    const match::FitResult& found = *run.report.found.result;
    result.blood = amount_of(run.measured.blood), result.veil = amount_of(run.measured.veil);
    result.blood.before = found.blood_before, result.blood.after = found.blood_after;
    result.veil.before = found.veil_before, result.veil.after = found.veil_after;
    for (const match::FittedParameter& p : found.parameters)
        result.parameters.push_back({.key = p.parameter.key,
                                     .unit = std::string(p.parameter.row->unit),
                                     .before = p.before,
                                     .after = p.after,
                                     .low = p.low,
                                     .high = p.high,
                                     .determined = p.determined});
    result.from = run.report.found.fit.from, result.to = run.report.found.fit.to,
    result.ended_early = found.ended_early;
    result.target = run.report.found.target, result.before = found.before, result.after = found.after;
    result.notes = run.report.of.notes;
    take_pictures(result, run.report);
}

void measure(const Job& job, const fs::path& folder, BatchResult& result) {
    constexpr int steps = 100;
    const std::string& file = job.options.files.reference;
    VideoReader video = opened_video(file);
    const Window window = window_of(job.options.match.window, video.info().duration, "video");
    Progress progress("measuring", steps);
    match::MeasureOptions options = measure_options(job.options.match, {}, video.info().size, "");
    options.from = window.from, options.to = window.to;
    const match::Measurement found = measured_video(video, file, {.options = options}, [&](double share) {
                                         progress.to(share);
                                         return true;
                                     }).found;
    write_file(folder / amounts_name, match::csv_of(found));
    result.from = window.from, result.to = window.to;
    result.blood = amount_of(found.blood), result.veil = amount_of(found.veil);
    result.target = match::target_of(found.frames, {.from = window.from, .to = window.to});
    result.notes = found.notes;
    for (const match::ReportMoment& moment : match::report_moments(result.target)) {
        Image frame;
        if (!video.read(video.frame_at(moment.time), frame)) continue;
        result.pictures.push_back({picture_name("Video", moment.time), match::small_jpeg(frame)});
        break;
    }
}

/// A fault as it is kept: without the way to the folder, which another machine has elsewhere.
std::vector<std::string> lines_of(const Error& error, const fs::path& folder) {
    std::vector<std::string> lines;
    const std::string prefix = (folder / "").string();
    for (Fault fault : error.faults()) {
        if (fault.file.starts_with(prefix)) fault.file.erase(0, prefix.size());
        lines.push_back(fault.text());
    }
    return lines;
}

std::string summary(const BatchResult& result) {
    std::ostringstream line;
    line.precision(3);
    for (const auto& [name, amount] : {std::pair{"blood", &result.blood}, std::pair{"veil", &result.veil}}) {
        line << name << ' ';
        if (result.fitted && amount->before && amount->after)
            line << "RMS " << *amount->before << " before, " << *amount->after << " after, ";
        else if (!result.fitted && amount->peak)
            line << "peak " << *amount->peak << ", ";
        else
            line << "not measurable, ";
    }
    line << match::decimals(result.seconds, 1) << " s" << (result.ended_early ? ", ended early: the best so far" : "");
    return line.str();
}

/// Told again, with the exit code that it had.
void tell_done(const BatchItem& item, const BatchResult& result, std::ostream& out) {
    out << printable(item.name) << ": " << (result.faults.empty() ? "done before" : "failed before") << '\n';
    std::vector<Fault> faults;
    for (const std::string& line : result.faults) faults.push_back({.file = "", .place = "", .reason = line});
    if (!faults.empty()) throw Error(Failure::bad_input, std::move(faults));
}

void work(const Job& job, const fs::path& folder, BatchResult& result) {
    const Clock::time_point began = Clock::now();
    if (job.fitted)
        fit(job, result);
    else
        measure(job, folder, result);
    result.seconds = std::chrono::duration<double>(Clock::now() - began).count();
    write_file(folder / result_name, text_of(result));
}

}  // namespace

fs::path folder_of(const fs::path& results, const BatchItem& item) {
    return results / item.name;
}

void run_item(const BatchRunOptions& o, const BatchItem& item, std::ostream& out) {
    const fs::path folder = folder_of(o.results, item);
    std::optional<document::Lock> lock = document::Lock::take(folder / lock_name);
    if (!lock) {
        const std::string holder = document::holder_of(folder / lock_name);
        out << printable(item.name) << ": is being done by " << (holder.empty() ? "another process" : holder) << '\n';
        return;
    }
    Job job = job_of(o, item);
    const std::optional<Error> without_reference = find_reference(job);
    BatchResult result{.kind = item.kind, .fitted = job.fitted, .input = input_of(job)};
    const std::optional<BatchResult> done = read_result(folder);
    if (done && !done->unfinished && !o.again && done->input == result.input) return tell_done(item, *done, out);
    if (job.fitted) check_options(job.options);  // what is wrong with the command leaves what was found
    check_reads(job, folder);
    remove_files(folder);
    std::vector<fs::path> brought;
    try {
        if (without_reference) throw *without_reference;
        if (job.fitted) bring_clips(job.options.files, brought);
        work(job, folder, result);
    } catch (const Error& error) {
        remove_files(folder);
        remove_clips(folder, brought);
        result = {.kind = item.kind,
                  .fitted = job.fitted,
                  .input = result.input,
                  .faults = lines_of(error, o.folder),
                  .unfinished = error.failure() != Failure::bad_input};
        try {
            write_file(folder / result_name, text_of(result));
        } catch (const Error&) {  // what went wrong first is told
        }
        throw;
    }
    out << printable(item.name) << ": " << summary(result) << '\n';
}

}  // namespace lapfx::commands
