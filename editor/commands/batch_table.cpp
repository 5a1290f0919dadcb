#include "commands/batch_table.h"
#include "lapfx/authoring/printable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "lapfx/error.h"
#include "ui/value/csv.h"

namespace lapfx::commands {

namespace fs = std::filesystem;

namespace {

Error refused(const fs::path& folder, const std::string& reason) {
    return {Failure::bad_input, Fault{.file = folder.string(), .place = "", .reason = reason}};
}

std::string number(const std::optional<double>& value) {
    if (!value || !std::isfinite(*value)) return {};
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", *value);
    return text;
}

class Row {
  public:
    explicit Row(std::string& csv) : csv_(csv) {}
    void add(const std::string& cell) {
        if (!first_) csv_ += ',';
        first_ = false;
        ui::append_csv(csv_, cell);
    }
    /// A text from outside: a spreadsheet would compute what begins like a formula.
    void add_text(const std::string& text) {
        const bool formula = !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
        add((formula ? "'" : "") + printable(text));
    }
    void add(const std::optional<double>& value) { add(number(value)); }
    void end() { csv_ += '\n'; }

  private:
    std::string& csv_;
    bool first_ = true;
};

std::set<std::string> keys_of(const std::vector<BatchEntry>& entries) {
    std::set<std::string> keys;
    for (const BatchEntry& entry : entries)
        if (entry.result)
            for (const BatchParameter& p : entry.result->parameters) keys.insert(p.key);
    return keys;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "; ") + line;
    return text;
}

void add_amount(Row& row, const BatchAmount& amount) {
    for (const std::optional<double>* value : {&amount.peak, &amount.mean, &amount.before, &amount.after})
        row.add(*value);
}

void add_parameter(Row& row, const BatchResult& result, const std::string& key) {
    const auto found = std::find_if(result.parameters.begin(), result.parameters.end(),
                                    [&](const BatchParameter& p) { return p.key == key; });
    if (found == result.parameters.end()) {
        for (int i = 0; i < 5; ++i) row.add("");
        return;
    }
    row.add(found->before), row.add(found->after);
    row.add(found->determined ? number(found->low) : ""), row.add(found->determined ? number(found->high) : "");
    row.add(found->determined ? "yes" : "no");
}

void add_entry(std::string& csv, const BatchEntry& entry, const std::set<std::string>& keys) {
    const BatchResult result = entry.result.value_or(BatchResult{});
    Row row(csv);
    row.add_text(entry.item);
    row.add(entry.item.ends_with(".scene.json") ? "scene" : "video");
    row.add(state_of(entry));
    row.add_text(joined(result.faults));
    add_amount(row, result.blood), add_amount(row, result.veil);
    row.add(entry.result && result.faults.empty() ? number(result.seconds) : "");
    row.add_text(entry.report ? entry.item + '/' + report_name : "");
    row.add(entry.result && result.faults.empty() ? (result.ended_early ? "yes" : "no") : "");
    row.add_text(joined(result.notes));
    for (const std::string& key : keys) add_parameter(row, result, key);
    row.end();
}

}  // namespace

std::vector<BatchEntry> batch_entries(const fs::path& results) {
    std::error_code error;
    if (!fs::exists(results, error)) throw refused(results, "no such folder");
    if (!fs::is_directory(results, error)) throw refused(results, "is not a folder");
    std::vector<BatchEntry> entries;
    constexpr auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator it(results, options, error), end; !error && it != end; it.increment(error)) {
        std::error_code none;
        if (it->is_symlink(none) || !it->is_directory(none) || !is_of_batch(it->path())) continue;
        it.disable_recursion_pending();
        entries.push_back({.item = it->path().lexically_relative(results).generic_string(),
                           .result = read_result(it->path()),
                           .report = fs::is_regular_file(it->path() / report_name, none)});
    }
    if (error)
        throw Error(Failure::runtime, Fault{results.string(), "", "cannot be looked through: " + error.message()});
    if (entries.empty()) throw refused(results, "holds no results of lapfx batch run");
    std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.item < b.item; });
    return entries;
}

const char* state_of(const BatchEntry& entry) {
    return entry.result ? state_of(*entry.result) : "unfinished";
}

std::string table_csv(const std::vector<BatchEntry>& entries) {
    const std::set<std::string> keys = keys_of(entries);
    std::string csv =
        "item,kind,state,fault,blood_peak,blood_mean,blood_rms_before,blood_rms_after,"
        "veil_peak,veil_mean,veil_rms_before,veil_rms_after,seconds,report,ended_early,notes";
    for (const std::string& key : keys)
        for (const char* column : {"_before", "_after", "_low", "_high", "_determined"}) {
            csv += ',';
            ui::append_csv(csv, key + column);
        }
    csv += '\n';
    for (const BatchEntry& entry : entries) add_entry(csv, entry, keys);
    return csv;
}

}  // namespace lapfx::commands
