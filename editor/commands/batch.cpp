// lapfx batch: many scenes and videos, fitted or measured in a process for each.
#include <iostream>
#include <limits>
#include <optional>

#include "commands/batch_list.h"
#include "commands/batch_run.h"
#include "commands/batch_table.h"
#include "commands/command.h"
#include "commands/file_kind.h"
#include "commands/matched_videos.h"
#include "commands/options.h"
#include "commands/say.h"
#include "commands/shown_scene.h"
#include "lapfx/authoring/file.h"
#include "lapfx/preset.h"

namespace lapfx::commands {

namespace {

namespace fs = std::filesystem;

struct ListOptions {
    std::string folder, results;
};

struct RunOptions {
    BatchRunOptions run;
    std::string folder, results, item;
    std::optional<std::size_t> number;
};

void list(const ListOptions& o) {
    const BatchList found = batch_items(o.folder, o.results);
    for (const BatchItem& item : found.items) std::cout << item.name << '\n';
    for (const std::string& line : found.notes) say(line);
}

BatchItem item_of(const RunOptions& o) {
    if (o.number.has_value() == !o.item.empty())
        throw wrong_option("ITEM", o.number ? "\"" + o.item + "\" and --number: one of them says which item"
                                            : "is missing: a line of `lapfx batch list`, or --number");
    if (!o.number) return batch_item(o.folder, o.item);
    const BatchList list = batch_items(o.folder, o.results);
    if (*o.number < 1 || *o.number > list.items.size())
        throw wrong_option(
            "--number", std::to_string(*o.number) + " is none of the list's 1 to " + std::to_string(list.items.size()));
    return list.items[*o.number - 1];
}

/// What is wrong with the command is told before an item is touched: else each would fail by it.
void check(const RunOptions& o) {
    const FitOptions& fit = o.run.fit;
    if (!fit.match.window.empty()) (void)window_of(fit.match.window, std::numeric_limits<double>::max(), "item");
    const std::vector<std::string> presets =
        fit.files.preset.empty() ? std::vector<std::string>() : std::vector{fit.files.preset};
    if (!fit.files.preset.empty()) (void)load_preset(fit.files.preset);
    if (!fit.files.scene.empty()) (void)open_shown(fit.files.scene, presets, {});
    std::error_code error;
    if (fs::exists(o.results, error) && !fs::is_directory(o.results, error))
        throw wrong_option("--into", "\"" + o.results + "\" is not a folder");
    if (will_be_same_file(o.results, o.folder))
        throw wrong_option("--into", "\"" + o.results + "\" is the folder of the items");
}

void run(const RunOptions& given) {
    RunOptions o = given;
    o.run.folder = o.folder, o.run.results = o.results;
    const BatchItem item = item_of(o);
    check(o);
    run_item(o.run, item, std::cout);
}

void collect(const std::string& results) {
    const std::vector<BatchEntry> entries = batch_entries(results);
    const fs::path folder = results;
    write_file(folder / "table.csv", table_csv(entries));
    write_file(folder / "index.html", index_html(entries));
    std::size_t done = 0, failed = 0;
    for (const BatchEntry& entry : entries) {
        const std::string state = state_of(entry);
        if (state == "unfinished")
            say(entry.item + ": is not finished" +
                (entry.result && !entry.result->faults.empty() ? ": " + entry.result->faults.front() : ""));
        else
            ++(state == "done" ? done : failed);
    }
    std::cout << entries.size() << (entries.size() == 1 ? " item, " : " items, ") << done << " done, " << failed
              << " failed, " << entries.size() - done - failed << " unfinished\n";
}

CLI::App* add_part(CLI::App& verb, const char* name, const char* help, const char* examples) {
    CLI::App* part = verb.add_subcommand(name, help);
    part->group("Parts");
    part->footer(examples);
    return part;
}

void add_list(CLI::App& verb) {
    auto o = std::make_shared<ListOptions>();
    CLI::App* part = add_part(
        verb, "list", "Print the scenes and videos of a folder, one a line",
        "Scenes are *.scene.json, videos have a name that `lapfx help files` lists. Folders below are looked through,\n"
        "too, but not those of results. A video that is there twice, by its content, is listed once, and one that a\n"
        "scene of the list has as its reference is not: the scene is fitted to it. What is left out is told on "
        "stderr.\n\n"
        "Example:\n  lapfx batch list samples");
    part->add_option("FOLDER", o->folder, "The folder")->required();
    part->add_option("--into", o->results, "The folder of the results, which is not looked through")
        ->option_text("RESULTS");
    part->callback([o] { list(*o); });
}

void add_run(CLI::App& verb) {
    auto o = std::make_shared<RunOptions>();
    CLI::App* part = add_part(
        verb, "run", "Fit or measure one item of the list",
        "A scene is fitted to the reference that it names. A video is fitted with --scene, whose events move to when\n"
        "smoke and blood of the video begin, and without --scene it is measured.\n\n"
        "RESULTS/ITEM/ gets amounts.csv, of a fit also fitted.json, fitted.scene.json, curves.csv and report.html, "
        "and\n"
        "last of all result.json. An item that has one, made from the same files by the same options, is not done "
        "again:\n"
        "it is told, with the exit code that it had. One whose input is at fault (exit 2) has one, too; one that "
        "failed\n"
        "otherwise (exit 1) or was killed is done by the next run. Two processes never do one item: the second says\n"
        "so and ends with 0.\n\n"
        "Example:\n  lapfx batch run samples reference/operation.mp4 --window 0,2 --into results");
    part->add_option("FOLDER", o->folder, "The folder of the list")->required();
    part->add_option("ITEM", o->item, "A line of the list");
    part->add_option("--number", o->number,
                     "The item by its line in the list, from 1, for job arrays; the folder must not change meanwhile")
        ->option_text("N")
        ->check(whole_number());
    part->add_option("--into", o->results, "The folder of the results; made where it is missing")
        ->option_text("RESULTS")
        ->required();
    part->add_option("--scene", o->run.fit.files.scene, "The scene that videos are fitted with")
        ->option_text("FILE.scene.json");
    add_fit_options(*part, o->run.fit, "a scene");
    part->add_flag("--again", o->run.again, "Also what is done");
    part->callback([o] { run(*o); });
}

void add_collect(CLI::App& verb) {
    auto results = std::make_shared<std::string>();
    CLI::App* part = add_part(
        verb, "collect", "Make a table and an index page of all results",
        "RESULTS/table.csv has a row for each item: state and fault, peak and mean of blood and veil of the video, of "
        "a\n"
        "fit their root mean square differences before and after, and of each parameter its value before and after\n"
        "and its interval. RESULTS/index.html shows them with curves and pictures, and leads to the reports.\n\n"
        "Example:\n  lapfx batch collect results");
    part->add_option("RESULTS", *results, "The folder of the results")->required();
    part->callback([results] { collect(*results); });
}

}  // namespace

void add_batch(CLI::App& app) {
    CLI::App* verb = app.add_subcommand("batch", "Fit or measure many scenes and videos, one in each process");
    verb->require_subcommand(1);
    add_list(*verb);
    add_run(*verb);
    add_collect(*verb);
    verb->footer(
        "What starts the processes is GNU parallel, the job array of a cluster, or a loop:\n\n"
        "    lapfx batch list videos | parallel lapfx batch run videos {} --scene usual.scene.json --into results\n"
        "    lapfx batch collect results\n\n"
        "Run again, it goes on where it stopped.");
}

}  // namespace lapfx::commands
