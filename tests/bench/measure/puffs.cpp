#include "bench/measure/puffs.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

#include "lapfx/authoring/file.h"
#include "lapfx/authoring/video.h"
#include "lapfx/error.h"
#include "match/video/measure.h"

namespace lapfx::bench {

namespace {

constexpr std::string_view columns = "video,onset,peak,end";
constexpr std::size_t longest = 1 << 20;    // bytes
constexpr double longest_video = 86'400.0;  // s
constexpr double bounds[] = {0.2, 0.25};    // s
constexpr double rounding = 1e-9;           // s

/// One line of the file.
class Row {
  public:
    Row(const std::filesystem::path& file, std::size_t line) : file_(file), line_(line) {}

    Error refused(const std::string& reason) const {
        return {Failure::bad_input,
                Fault{.file = file_.string(), .place = "line " + std::to_string(line_), .reason = reason}};
    }
    /// The name of a video may have commas.
    KnownPuff puff(std::string_view text) const {
        KnownPuff puff;
        for (std::size_t i = puff_times.size(); i-- > 0;) {
            const std::size_t comma = text.rfind(',');
            if (comma == std::string_view::npos) throw refused("has fewer than four values (" + title() + ")");
            puff.by_eye[i] = seconds(text.substr(comma + 1), puff_times[i]);
            text = text.substr(0, comma);
        }
        if (text.empty()) throw refused("names no video");
        puff.video = file_.parent_path() / text;
        check_order(puff.by_eye);
        return puff;
    }
    static std::string title() { return std::string(columns); }

  private:
    std::optional<double> seconds(std::string_view cell, const char* name) const {
        if (cell.empty()) return {};
        double value = 0.0;
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (error != std::errc{} || end != cell.data() + cell.size() || !(value >= 0.0 && value <= longest_video))
            throw refused(std::string(name) + ": \"" + std::string(cell) + "\" is no time in s, 0 to 86400");
        return value;
    }
    void check_order(const PuffTimes& times) const {
        std::optional<double> last;
        for (const std::optional<double>& time : times) {
            if (time && last && *time <= *last) throw refused("onset, peak and end do not follow each other");
            if (time) last = time;
        }
        if (!last) throw refused("has no time");
    }

    const std::filesystem::path& file_;
    std::size_t line_;
};

std::string text_of(const MeasuredPuff& puff) {
    char text[120];
    std::snprintf(text, sizeof text, "  %-46.46s", puff.known.video.filename().string().c_str());
    std::string line = text;
    for (std::size_t i = 0; i < puff_times.size(); ++i) {
        const std::optional<double> error = puff.error(i);
        if (error)
            std::snprintf(text, sizeof text, "%+8.2f", *error);
        else
            std::snprintf(text, sizeof text, "%8s", puff.known.by_eye[i] ? "none" : "-");
        line += text;
    }
    return line + (puff.told ? "\n" : "  within the intervals: not told\n");
}

}  // namespace

std::optional<double> MeasuredPuff::error(std::size_t time) const {
    if (!measured[time] || !known.by_eye[time]) return {};
    return *measured[time] - *known.by_eye[time];
}

std::vector<KnownPuff> known_puffs(const std::filesystem::path& file) {
    const std::string text = read_file(file, longest);
    std::vector<KnownPuff> puffs;
    std::size_t line = 0;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        std::string_view row(text.data() + from, end - from);
        from = end + 1;
        if (row.ends_with('\r')) row.remove_suffix(1);
        const Row at(file, ++line);
        if (line == 1 && row != columns) throw at.refused("the columns are not " + Row::title());
        if (line > 1 && !row.empty()) puffs.push_back(at.puff(row));
    }
    if (puffs.empty()) throw Row(file, line).refused("no video follows");
    return puffs;
}

namespace {

/// As if nothing were uncertain: an episode that its intervals would not tell has its times, too.
std::vector<match::FrameAmounts> certain(std::vector<match::FrameAmounts> frames) {
    for (match::FrameAmounts& frame : frames) {
        frame.veil.low = frame.veil.high = frame.veil.value;
        if (frame.course) frame.course->low = frame.course->high = frame.course->value;
    }
    return frames;
}

}  // namespace

MeasuredPuff measured_puff(const KnownPuff& known) {
    VideoReader reader(known.video);
    const match::Measurement found = match::measure(reader, {});
    const match::Curve curve = found.course_only ? match::Curve::course : match::Curve::veil;
    const match::Episode veil = match::episode_of(certain(found.frames), curve);
    MeasuredPuff puff{.known = known, .measured = {veil.onset, veil.peak_at}, .told = found.veil.peak_at.has_value()};
    if (veil.peak_at && veil.decay) puff.measured[2] = *veil.peak_at + *veil.decay;
    return puff;
}

PuffsWithin puffs_within(std::span<const MeasuredPuff> puffs, std::size_t time, double seconds) {
    PuffsWithin count;
    for (const MeasuredPuff& puff : puffs) {
        const std::optional<double> error = puff.error(time);
        count.known += puff.known.by_eye[time] ? 1 : 0;
        count.within += error && std::abs(*error) <= seconds + rounding ? 1 : 0;
    }
    return count;
}

void add_puffs(BenchReport& report, std::span<const MeasuredPuff> puffs) {
    char text[120];
    std::snprintf(text, sizeof text, "%-48s%8s%8s%8s\n", "puffs: measured minus by eye, s", "onset", "peak", "end");
    report.table += text;
    for (const MeasuredPuff& puff : puffs) {
        BenchRow row{.of = {{"puff", puff.known.video.filename().string()}}, .measured = {{"told", puff.told}}};
        for (std::size_t i = 0; i < puff_times.size(); ++i)
            if (const std::optional<double> error = puff.error(i))
                row.measured[std::string(puff_times[i]) + "_error_s"] = *error;
        report.rows.push_back(std::move(row));
        report.table += text_of(puff);
    }
    BenchRow all{.of = {{"class", "puffs"}, {"pictures", "real"}}, .measured = {}};
    for (const double bound : bounds) {
        std::snprintf(text, sizeof text, "  within %-39.2f", bound);
        report.table += text;
        for (std::size_t i = 0; i < puff_times.size(); ++i) {
            const PuffsWithin count = puffs_within(puffs, i, bound);
            std::snprintf(text, sizeof text, "%3d of%2d", count.within, count.known);
            report.table += text;
            const std::string name = puff_times[i];
            std::snprintf(text, sizeof text, "_within_%.0f_ms", 1000.0 * bound);
            all.measured[name + text] = count.within, all.measured[name + "_known"] = count.known;
        }
        report.table += '\n';
    }
    report.rows.push_back(std::move(all));
    report.table += '\n';
}

}  // namespace lapfx::bench
