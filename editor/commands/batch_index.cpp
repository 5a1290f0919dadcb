// The index page of lapfx batch.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>

#include "commands/batch_table.h"
#include "match/report/markup.h"
#include "match/report/page.h"
#include "match/report/report_plot.h"

namespace lapfx::commands {

namespace {

using match::escaped;

/// After that of the reports. Not XML in itself: neither '<' nor '&'. An order is a number of each item and a choice,
/// without a script.
constexpr std::string_view index_style = R"css(
main { max-width: 76rem; margin: 0 auto; }
body { max-width: 80rem; }
.orders { display: inline-block; margin-right: 1rem; }
.order { accent-color: var(--veil); }
.items { display: flex; flex-direction: column; margin-top: 1rem; }
.item { border-top: 1px solid var(--rule); padding: 0.8rem 0; }
.item h2 { font-size: 1rem; margin: 0; }
.item a { color: inherit; }
.item .shown { display: grid; grid-template-columns: 1fr 1fr 21rem; gap: 1rem; align-items: end; padding-top: 0.4rem; }
.item .plot { max-width: 26rem; }
.item .small { display: flex; gap: 0.6rem; }
.item figure { flex: 1; max-width: 160px; }
.item figcaption { font-size: 0.8rem; }
.state { font-weight: 600; }
.failed .state { color: var(--blood); }
#by-blood:checked ~ .items .item { order: var(--by-blood); }
#by-veil:checked ~ .items .item { order: var(--by-veil); }
#by-state:checked ~ .items .item { order: var(--by-state); }
@media (max-width: 56rem) { .item .shown { grid-template-columns: 1fr; } .item figure { max-width: 200px; } }
)css";

std::string percent_of(const std::optional<double>& share) {
    constexpr double hundred = 100.0;
    return share ? match::decimals(hundred * *share, 2) : "-";
}

std::string figures(const BatchResult& result, const BatchAmount& amount) {
    if (!result.fitted) return amount.peak ? "peak " + percent_of(amount.peak) + " %" : "not measurable";
    if (!amount.before || !amount.after) return "not measurable";
    return "RMS " + percent_of(amount.before) + " before, <strong>" + percent_of(amount.after) + "</strong> % after";
}

std::string state_words(const BatchEntry& entry) {
    std::string html = "<span class=\"state\">" + std::string(state_of(entry)) + "</span>";
    if (!entry.result) return html + ": no result; it is being done, or was ended before it was done";
    if (!entry.result->faults.empty()) {
        for (const std::string& fault : entry.result->faults) html += "<br/>" + escaped(fault);
        return html;
    }
    const BatchResult& result = *entry.result;
    return html + (result.fitted ? ": fitted" : ": measured") + (result.ended_early ? ", ended early" : "") + " in " +
           match::decimals(result.seconds, 0) + " s. Blood " + figures(result, result.blood) + ". Veil " +
           figures(result, result.veil) + ".";
}

std::string notes(const BatchResult& result) {
    std::string html;
    for (const std::string& note : result.notes) html += "<p class=\"quiet\">" + escaped(note) + "</p>\n";
    return html;
}

std::string plots(const BatchResult& result, std::size_t number) {
    match::FitResult shown;
    shown.before = result.before, shown.after = result.after;
    const match::PlotPlace place{.id = "item-" + std::to_string(number) + '-',
                                 .of = result.fitted ? "scene" : "video",
                                 .compared = result.fitted};
    std::string html;
    for (const match::AmountName& amount : match::amount_names)
        html += match::amount_plot(result.target, shown, amount, result.from, result.to, place);
    return html;
}

std::string pictures(const BatchResult& result) {
    std::string html = "<div class=\"small\">";
    for (const BatchPicture& picture : result.pictures)
        if (!picture.jpeg.empty())
            html += "<figure><img src=\"data:image/jpeg;base64," + match::base64(picture.jpeg) + "\" alt=\"" +
                    escaped(picture.name) + "\"/><figcaption>" + escaped(picture.name) + "</figcaption></figure>\n";
    return html + "</div>\n";
}

/// Where it comes in an order.
struct Ranks {
    std::size_t blood = 0, veil = 0, state = 0;
};

/// The greatest value first; equal ones stay by name.
std::vector<std::size_t> ranks(const std::vector<BatchEntry>& entries,
                               const std::function<double(const BatchEntry&)>& value) {
    std::vector<std::size_t> order(entries.size()), rank(entries.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return value(entries[a]) > value(entries[b]); });
    for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
    return rank;
}

double rms_of(const BatchEntry& entry, BatchAmount BatchResult::*amount) {
    constexpr double none = -1.0;
    if (!entry.result) return none;
    const std::optional<double>& after = ((*entry.result).*amount).after;
    return after && std::isfinite(*after) ? *after : none;
}

double state_rank(const BatchEntry& entry) {
    const std::string state = state_of(entry);
    return state == "unfinished" ? 1.0 : state == "done" ? 0.0 : 2.0;
}

std::string article(const BatchEntry& entry, std::size_t number, const Ranks& rank) {
    std::string html = "<article class=\"item " + std::string(state_of(entry)) +
                       "\" style=\"--by-blood:" + std::to_string(rank.blood) +
                       ";--by-veil:" + std::to_string(rank.veil) + ";--by-state:" + std::to_string(rank.state) +
                       "\">\n<h2>";
    const std::string name = match::name_element(entry.item);
    html += entry.report ? "<a href=\"" + relative_url(entry.item + '/' + report_name) + "\">" + name + "</a>" : name;
    html += "</h2>\n<p>" + state_words(entry) + "</p>\n";
    if (entry.result && entry.result->faults.empty())
        html += notes(*entry.result) + "<div class=\"shown\">\n" + plots(*entry.result, number) +
                pictures(*entry.result) + "</div>\n";
    return html + "</article>\n";
}

std::string counts(const std::vector<BatchEntry>& entries) {
    std::string html = std::to_string(entries.size()) + (entries.size() == 1 ? " item" : " items");
    for (const std::string state : {"done", "failed", "unfinished"}) {
        const auto count =
            std::count_if(entries.begin(), entries.end(), [&](const auto& entry) { return state == state_of(entry); });
        if (count > 0) html += ", " + std::to_string(count) + ' ' + state;
    }
    return html;
}

std::string orders() {
    struct Order {
        const char *id, *name;
    };
    constexpr Order all[] = {{"by-name", "name"},
                             {"by-blood", "blood, farthest first"},
                             {"by-veil", "veil, farthest first"},
                             {"by-state", "failed first"}};
    std::string html = "<span class=\"orders\">Order:</span>\n";
    for (const Order& order : all)
        html += "<input type=\"radio\" class=\"order\" name=\"order\" id=\"" + std::string(order.id) + "\"" +
                (order.id == all[0].id ? " checked=\"checked\"" : "") + "/><label class=\"orders\" for=\"" + order.id +
                "\"> " + order.name + "</label>\n";
    return html;
}

}  // namespace

std::string relative_url(const std::string& path) {
    std::string url = "./";  // a name with a colon would be a scheme
    for (const char letter : path) {
        const auto byte = static_cast<unsigned char>(letter);
        if (std::isalnum(byte) != 0 || std::string_view("-._~/").find(letter) != std::string_view::npos) {
            url += letter;
        } else {
            char code[4];
            std::snprintf(code, sizeof code, "%%%02X", byte);
            url += code;
        }
    }
    return url;
}

std::string index_html(const std::vector<BatchEntry>& entries) {
    const auto by_blood = ranks(entries, [](const auto& entry) { return rms_of(entry, &BatchResult::blood); });
    const auto by_veil = ranks(entries, [](const auto& entry) { return rms_of(entry, &BatchResult::veil); });
    const auto by_state = ranks(entries, state_rank);
    std::string html = match::page_head("Results of " + counts(entries), index_style) +
                       "<body>\n<main>\n<h1>Results</h1>\n<p>" + counts(entries) +
                       ". Figures are in <a href=\"./table.csv\">table.csv</a>; RMS is the root mean square "
                       "difference to the reference, % of the view.</p>\n" +
                       orders() + "<div class=\"items\">\n";
    for (std::size_t i = 0; i < entries.size(); ++i)
        html += article(entries[i], i + 1, {by_blood[i], by_veil[i], by_state[i]});
    return html + "</div>\n</main>\n</body>\n</html>\n";
}

}  // namespace lapfx::commands
