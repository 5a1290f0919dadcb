#include "document/words.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "document/tables.h"
#include "lapfx/authoring/compare.h"
#include "lapfx/authoring/letters.h"
#include "lapfx/authoring/strokes.h"

namespace lapfx::document {

namespace {

using Pair = std::pair<std::size_t, std::size_t>;
constexpr std::size_t none = ~std::size_t{0};
constexpr std::size_t most_matched =
    400 * 400;  // cells of the table that matches elements; beyond it they are paired in order

const void* element(const Table& list, const void* vector, std::size_t index) {
    return list.list->at(const_cast<void*>(vector), index);  // only an address is taken, nothing is written
}

/// "Clip" for "Clips".
std::string singular(std::string_view name) {
    return std::string(name.ends_with('s') ? name.substr(0, name.size() - 1) : name);
}

/// The first value of an element says what it is: a clip's file, an event's action.
std::string what_it_is(const Table& list, const void* item) {
    if (list.rows.empty()) return {};
    const std::string text = text_of(list.rows[0], item);
    return list.rows[0].kind == Kind::path ? std::filesystem::path(text).filename().string() : text;
}

std::string called(const Table& list, const void* item, std::size_t index) {
    std::string name = singular(list.name) + ' ' + std::to_string(index + 1);
    const std::string what = what_it_is(list, item);
    return what.empty() ? name : name + " (" + what + ')';
}

/// Finds pairs of elements (index before, index after), in order. Equal elements are partners. The elements between
/// them are paired in order, because they have been edited; where one side has more, the other index of the pair is
/// `none`.
class Matcher {
  public:
    Matcher(const Table& list, const void* before, const void* after)
        : list_(list), before_(before), after_(after), n_(list.list->size(before)), m_(list.list->size(after)) {}

    std::vector<Pair> pairs() {
        std::size_t head = 0, tail = 0;
        while (head < std::min(n_, m_) && same(head, head)) ++head;
        while (tail < std::min(n_, m_) - head && same(n_ - 1 - tail, m_ - 1 - tail)) ++tail;
        for (std::size_t i = 0; i < head; ++i) out_.emplace_back(i, i);
        const std::size_t n = n_ - head - tail, m = m_ - head - tail;
        if (n * m <= most_matched)
            longest_common(head, n, m);
        else
            pair_up(head, n, head, m);
        for (std::size_t i = tail; i > 0; --i) out_.emplace_back(n_ - i, m_ - i);
        return std::move(out_);
    }

    /// Whether both lists have the same elements in another order.
    bool reordered() const {
        if (n_ != m_ || n_ * m_ > most_matched) return false;
        std::vector<char> used(m_, 0);
        bool moved = false;
        for (std::size_t i = 0; i < n_; ++i) {
            std::size_t j = 0;
            while (j < m_ && (used[j] != 0 || !same(i, j))) ++j;
            if (j == m_) return false;
            used[j] = 1;
            moved |= i != j;
        }
        return moved;
    }

  private:
    bool same(std::size_t i, std::size_t j) const {
        return equal_elements(element(list_, before_, i), element(list_, after_, j));
    }
    bool equal_elements(const void* a, const void* b) const {
        // The table of a list describes one element, its rows and parts.
        return equal(list_, a, b);
    }

    void pair_up(std::size_t i, std::size_t n, std::size_t j, std::size_t m) {
        for (std::size_t k = 0; k < std::max(n, m); ++k) out_.emplace_back(k < n ? i + k : none, k < m ? j + k : none);
    }

    void longest_common(std::size_t head, std::size_t n, std::size_t m) {
        std::vector<std::uint16_t> length((n + 1) * (m + 1), 0);
        const auto at = [&](std::size_t i, std::size_t j) -> std::uint16_t& { return length[i * (m + 1) + j]; };
        for (std::size_t i = n; i-- > 0;)
            for (std::size_t j = m; j-- > 0;)
                at(i, j) = same(head + i, head + j) ? static_cast<std::uint16_t>(at(i + 1, j + 1) + 1)
                                                    : std::max(at(i + 1, j), at(i, j + 1));
        std::size_t i = 0, j = 0, from_i = 0, from_j = 0;
        const auto flush = [&] { pair_up(head + from_i, i - from_i, head + from_j, j - from_j); };
        while (i < n && j < m) {
            if (same(head + i, head + j) && at(i, j) == at(i + 1, j + 1) + 1) {
                flush();
                out_.emplace_back(head + i++, head + j++);
                from_i = i, from_j = j;
            } else {
                at(i + 1, j) >= at(i, j + 1) ? ++i : ++j;
            }
        }
        i = n, j = m;
        flush();
    }

    const Table& list_;
    const void *before_, *after_;
    std::size_t n_, m_;
    std::vector<Pair> out_;
};

class Comparison {
  public:
    explicit Comparison(bool scene) : scene_(scene) {}
    std::vector<Difference> found;

    void table(const Table& t, const void* before, const void* after, const std::string& before_at,
               const std::string& after_at, const std::string& item) {
        for (const Parameter& row : t.rows)
            if (!equal(row, before, after)) value(t, row, before, after, before_at, after_at, item);
        for (const Table& child : t.tables) {
            const std::string key = '/' + std::string(child.key);
            const void* left = child.member(const_cast<void*>(before));
            const void* right = child.member(const_cast<void*>(after));
            if (child.list != nullptr)
                list(child, left, right, before_at + key, after_at + key);
            else if (child.present == nullptr)
                table(child, left, right, before_at + key, after_at + key, item);
            else
                part(child, before, after, before_at + key, after_at + key, item);
        }
    }

  private:
    Difference make(Difference::Kind kind, const std::string& before_at, const std::string& after_at,
                    const std::string& item) const {
        Difference d;
        d.kind = kind;
        d.scene = scene_;
        d.before_at = before_at;
        d.after_at = after_at;
        d.item = item;
        return d;
    }

    void value(const Table& t, const Parameter& row, const void* before, const void* after,
               const std::string& before_at, const std::string& after_at, const std::string& item) {
        const std::string key = '/' + std::string(row.key);
        Difference d = make(Difference::Kind::value, before_at + key, after_at + key, item);
        d.row = std::string(row.name);
        const bool whole_item = !item.empty() && t.list != nullptr;
        std::string where = whole_item ? item : std::string(t.name);
        if (!item.empty() && !whole_item) where = item + ", " + where;
        d.name = where + ": " + d.row;
        d.before = text_of(row, before);
        d.after = text_of(row, after);
        if (d.before == d.after) {
            d.before = exact_text_of(row, before);
            d.after = exact_text_of(row, after);
        }
        d.unit = std::string(row.unit);
        found.push_back(std::move(d));
    }

    void part(const Table& child, const void* before, const void* after, const std::string& before_at,
              const std::string& after_at, const std::string& item) {
        const bool was = *child.present(const_cast<void*>(before)), is = *child.present(const_cast<void*>(after));
        if (was == is) {
            if (was)
                table(child, child.member(const_cast<void*>(before)), child.member(const_cast<void*>(after)), before_at,
                      after_at, item);
            return;
        }
        Difference d = make(Difference::Kind::part, before_at, after_at, item);
        d.row = std::string(child.name);
        d.name = (item.empty() ? "" : item + ": ") + d.row;
        d.before = was ? "on" : "off";
        d.after = is ? "on" : "off";
        found.push_back(std::move(d));
    }

    void list(const Table& t, const void* before, const void* after, const std::string& before_at,
              const std::string& after_at) {
        Matcher matcher(t, before, after);
        if (matcher.reordered()) {
            Difference d = make(Difference::Kind::moved, before_at, after_at, {});
            d.name = d.row = std::string(t.name);
            d.before = order(t, before);
            d.after = order(t, after);
            found.push_back(std::move(d));
            return;
        }
        for (const auto& [i, j] : matcher.pairs()) element_pair(t, before, after, {i, j}, before_at, after_at);
    }

    static std::string order(const Table& t, const void* vector) {
        std::string text;
        const std::size_t size = t.list->size(vector);
        for (std::size_t i = 0; i < std::min<std::size_t>(size, 4); ++i)
            text += (i == 0 ? "" : ", ") + what_it_is(t, element(t, vector, i));
        return size > 4 ? text + " ..." : text;
    }

    void element_pair(const Table& t, const void* before, const void* after, const Pair& pair,
                      const std::string& before_at, const std::string& after_at) {
        const auto [i, j] = pair;
        const std::string left = before_at + '/' + std::to_string(i == none ? j : i);
        const std::string right = after_at + '/' + std::to_string(j == none ? i : j);
        if (i != none && j != none) {
            const void *a = element(t, before, i), *b = element(t, after, j);
            if (!equal(t, a, b)) table(t, a, b, left, right, called(t, b, j));
            return;
        }
        const bool added = i == none;
        Difference d = make(added ? Difference::Kind::added : Difference::Kind::removed, left, right, {});
        const void* item = added ? element(t, after, j) : element(t, before, i);
        d.name = d.item = called(t, item, added ? j : i);
        d.row = singular(t.name);
        (added ? d.after : d.before) = what_it_is(t, item);
        found.push_back(std::move(d));
    }

    bool scene_;
};

template <typename Document>
std::vector<Difference> compare(const Table& table, const Document& before, const Document& after, bool scene) {
    Comparison comparison(scene);
    comparison.table(table, &before, &after, "", "", "");
    return std::move(comparison.found);
}

bool says(std::string_view text, std::string_view word) {
    const auto same = [](char a, char b) { return lower(a) == lower(b); };
    return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

/// "cauterise" for "Event 3 (cauterise)".
std::string inside_brackets(const std::string& item) {
    const std::size_t open = item.find('(');
    return open == std::string::npos || !item.ends_with(')') ? item : item.substr(open + 1, item.size() - open - 2);
}

std::string counted(std::size_t count, std::string_view what) {
    return std::to_string(count) + ' ' + lower_first(std::string(what)) + (count == 1 ? "" : "s");
}

/// Of differences that all add or remove: how many a person would count. What a hand does in one go is a stroke of many
/// contacts, and one event on the timeline.
std::size_t things_in(const std::vector<Difference>& all, const Content& before, const Content& after) {
    constexpr std::string_view events = "/events/";
    std::vector<ToolContact> contacts;
    for (const Difference& d : all) {
        const bool added = d.kind == Difference::Kind::added;
        const std::string& at = added ? d.after_at : d.before_at;
        const std::vector<ToolContact>& from = (added ? after : before).scene.events;
        std::size_t number = from.size();
        if (at.starts_with(events)) std::from_chars(at.data() + events.size(), at.data() + at.size(), number);
        if (number < from.size()) contacts.push_back(from[number]);
    }
    if (contacts.size() != all.size()) return all.size();
    std::stable_sort(contacts.begin(), contacts.end(),
                     [](const ToolContact& a, const ToolContact& b) { return a.time < b.time; });
    std::vector<char> is_continued(contacts.size(), 0);
    std::size_t strokes = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const auto from = goes_on_from(
            i, [&](std::size_t k) -> const ToolContact& { return contacts[k]; },
            [&](std::size_t k) { return is_continued[k] != 0; });
        from ? is_continued[*from] = 1 : ++strokes;
    }
    return strokes;
}

/// What several differences have in common.
std::string summary(const std::vector<Difference>& all, const Content& before, const Content& after) {
    const Difference& first = all.front();
    const bool one_kind = std::all_of(all.begin(), all.end(),
                                      [&](const Difference& d) { return d.kind == first.kind && d.row == first.row; });
    if (one_kind && (first.kind == Difference::Kind::added || first.kind == Difference::Kind::removed)) {
        const std::size_t count = things_in(all, before, after);
        return (count == 1 ? inside_brackets(first.item) : counted(count, first.row)) + ' ' + change_text(first);
    }
    const bool values = std::all_of(all.begin(), all.end(), [](const Difference& d) {
        return d.kind == Difference::Kind::value || d.kind == Difference::Kind::part;
    });
    if (!values) return counted(all.size(), "change");
    const bool one_item = !first.item.empty() && std::all_of(all.begin(), all.end(),
                                                             [&](const Difference& d) { return d.item == first.item; });
    if (one_item && all.size() == 2)
        return inside_brackets(first.item) + ", " + all[0].row + ' ' + change_text(all[0]) + ", " + all[1].row + ' ' +
               change_text(all[1]);
    return (one_item ? inside_brackets(first.item) + ", " : "") + counted(all.size(), "value");
}

}  // namespace

std::vector<Difference> differences(const Preset& before, const Preset& after) {
    return compare(preset_table(), before, after, false);
}

std::vector<Difference> differences(const Scene& before, const Scene& after) {
    return compare(scene_table(), before, after, true);
}

std::vector<Difference> differences(const Content& before, const Content& after) {
    std::vector<Difference> all = differences(before.preset, after.preset);
    std::vector<Difference> scene = differences(before.scene, after.scene);
    std::move(scene.begin(), scene.end(), std::back_inserter(all));
    return all;
}

std::string change_text(const Difference& d) {
    if (d.kind == Difference::Kind::added) return "added";
    if (d.kind == Difference::Kind::removed) return "removed";
    if (d.kind == Difference::Kind::moved) return "in another order";
    // The unit is written once: "4 to 8.3 mm/s".
    std::string before = d.before;
    const std::string unit = ' ' + d.unit;
    if (!d.unit.empty() && before.ends_with(unit)) before.resize(before.size() - unit.size());
    return before + " to " + d.after;
}

std::string fault_text(const Fault& fault, const Preset& preset) {
    constexpr std::string_view clips = "/smoke/clips/";
    if (!fault.place.starts_with(clips)) return fault.text();
    const char* const begin = fault.place.data() + clips.size();
    const char* const end = fault.place.data() + fault.place.size();
    std::size_t number = 0;
    const auto [after, error] = std::from_chars(begin, end, number);
    if (error != std::errc() || number >= preset.smoke.clips.size()) return fault.text();
    const std::string name = std::filesystem::path(preset.smoke.clips[number].file).filename().string();
    std::string field(after, end);
    if (field == "/file") field.clear();
    std::replace(field.begin(), field.end(), '/', ' ');
    std::replace(field.begin(), field.end(), '_', ' ');
    return Fault{"",
                 "smoke clip " + std::to_string(number + 1) + (name.empty() ? "" : ", " + name) +
                     (field.empty() ? "" : "," + field),
                 fault.reason}
        .text();
}

std::string change_of(std::string_view name, const Content& before, const Content& after) {
    const std::vector<Difference> all = differences(before, after);
    if (all.empty()) return {};
    if (all.size() > 1) return summary(all, before, after);
    const Difference& d = all.front();
    if (d.kind == Difference::Kind::added || d.kind == Difference::Kind::removed)
        return inside_brackets(d.item) + ' ' + change_text(d);
    if (d.kind == Difference::Kind::moved) return change_text(d);
    const std::string what = says(name, d.row) ? "" : d.row + ' ';
    const std::string item = d.item.empty() ? "" : inside_brackets(d.item) + ", ";
    return item + what + change_text(d);
}

std::string title_of(const Step& step) {
    return step.change.empty() ? step.name : step.name + ": " + step.change;
}

bool take_back(Preset& after, const Preset& before, const Difference& d) {
    Preset source = before;  // find() takes no const document
    const Table& root = preset_table();
    const std::string list_at = d.after_at.substr(0, d.after_at.rfind('/'));
    const Spot from = find(root, &source, d.before_at), to = find(root, &after, d.after_at);
    switch (d.kind) {
        case Difference::Kind::value:
            if (!from.row || from.row != to.row) return false;
            copy(*from.row, to.owner, from.owner);
            return true;
        case Difference::Kind::part:
            if (!from || !to || from.table->present == nullptr) return false;
            *to.table->present(to.parent) = *from.table->present(from.parent);
            copy(*from.table, to.owner, from.owner);
            return true;
        case Difference::Kind::added:
            if (!to.element) return false;
            erase(*to.table, to.parent, to.index);
            return true;
        case Difference::Kind::removed: {
            const Spot list = find(root, &after, list_at);
            if (!from.element || !list || list.table->list->size(list.owner) >= list.table->list->maximum) return false;
            insert(*list.table, list.owner, from.index, from.owner);
            return true;
        }
        case Difference::Kind::moved:
            if (!from || !to || from.table->list == nullptr) return false;
            to.table->list->resize(to.owner, 0);
            to.table->list->resize(to.owner, from.table->list->size(from.owner));
            for (std::size_t i = 0; i < from.table->list->size(from.owner); ++i)
                copy(*to.table, to.table->list->at(to.owner, i), from.table->list->at(from.owner, i));
            return true;
    }
    return false;
}

}  // namespace lapfx::document
