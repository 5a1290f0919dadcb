#include "ui/support/texts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <set>

namespace lapfx::ui {

namespace {

Rect rect_of(const Instance& i) {
    return {i.x, i.y, i.w, i.h};
}

glm::vec2 middle(const Rect& r) {
    return r.at() + r.size() * 0.5F;
}

/// Whether it hides everything under it.
bool covers(const Instance& i) {
    switch (i.kind) {
        case InstanceKind::fill:
            return i.color.a == 255 && (i.border == 0 || i.uv[2] == 1);
        case InstanceKind::image:
        case InstanceKind::gradient:
        case InstanceKind::checker:
        case InstanceKind::compare:
            return true;
        default:
            return false;
    }
}

/// The glyphs of ellipses in all sizes and weights that the toolkit draws, each at all parts of a px that it may begin
/// at: letters of many widths stand before it.
class Ellipses {
  public:
    Ellipses(Fonts& fonts, float em) {
        for (const float size : {0.85F, 0.86F, 0.9F, 1.0F, 1.15F, 1.25F, 1.5F})
            for (const Weight weight : {Weight::regular, Weight::medium, Weight::bold})
                for (const char before : std::string_view("\0abcdefgijklmnoprstuvwxz.,-1 AEMTW", 34)) {
                    std::string text = before != 0 ? std::string(1, before) + "\u2026" : "\u2026";
                    for (const bool monospace : {false, true}) {
                        const Run& run =
                            fonts.run(text, {.size = std::round(size * em), .weight = weight, .monospace = monospace});
                        if (!run.glyphs.empty()) glyphs_.insert(key_of(run.glyphs.back()));
                    }
                }
    }
    bool has(const Instance& glyph) const { return glyphs_.contains(key_of(glyph)); }

  private:
    static std::string key_of(const Instance& glyph) {
        return {reinterpret_cast<const char*>(glyph.uv), sizeof glyph.uv};
    }
    std::set<std::string> glyphs_;
};

std::string box_text(const Rect& r) {
    char text[64];
    std::snprintf(text, sizeof text, " at %.0f, %.0f (%.0f x %.0f)", static_cast<double>(r.x), static_cast<double>(r.y),
                  static_cast<double>(r.w), static_cast<double>(r.h));
    return text;
}

std::string place_of(std::span<const Node> tree, const TextSeen& text) {
    const std::uint32_t node = node_of(tree, text);
    return (node == no_node ? std::string("?")
                            : path_of(tree, node) + " (" + std::string(name_of(tree[node].role)) + ", \"" +
                                  std::string(tree[node].text.empty() ? tree[node].shown : tree[node].text) + "\")") +
           box_text(text.rect);
}

/// Whether the node is in a scroll area that scrolls along `axis`.
bool scrolled(std::span<const Node> tree, std::uint32_t node, int axis) {
    for (; node != no_node; node = tree[node].parent)
        if (tree[node].scrolls[axis]) return true;
    return false;
}

/// Whether this is a control whose name is the text on it.
bool is_label_of_control(Role role) {
    switch (role) {
        case Role::button:
        case Role::toggle:
        case Role::checkbox:
        case Role::radio:
        case Role::menu_item:
        case Role::section:
        case Role::heading:
        case Role::column_header:
            return true;
        default:
            return false;
    }
}

/// Whether what was written by us, or a number or a path, ends in an ellipsis. What a person has written may.
bool ends_where_there_is_room(const Node& node, const TextSeen& text, float em) {
    switch (node.role) {
        case Role::slider:  // its value, not its caption
            return text.rect.x > node.rect().x + 0.4F * node.extent[0] || node.label.size() == 1;
        case Role::label:  // that of a row's caption has no text
            return !node.text.empty();
        case Role::text_field:
            return has(node.is, Is::read_only);
        case Role::search_field:
        case Role::tab:
            return true;
        case Role::list_item:
            return text.rect.w > 12 * em;
        default:
            return false;
    }
}

/// Panes that a person pans: texts at their edges may be cut.
bool is_panned(Role role) {
    return role == Role::timeline || role == Role::plot || role == Role::curve || role == Role::canvas ||
           role == Role::image || role == Role::text_field || role == Role::search_field;
}

bool in_panned(std::span<const Node> tree, std::uint32_t node) {
    for (; node != no_node; node = tree[node].parent)
        if (is_panned(tree[node].role)) return true;
    return false;
}

}  // namespace

std::vector<TextSeen> texts_seen(const DrawList& list, Fonts& letters, float em) {
    const Ellipses ellipses(letters, em);
    std::vector<TextSeen> texts;
    for (const Batch& batch : list.batches) {
        const Instance* last = nullptr;
        for (std::uint32_t n = batch.first; n < batch.first + batch.count; ++n) {
            const Instance& i = list.instances[n];
            const Rect clip = list.clips[batch.first_clip + i.clip], rect = rect_of(i);
            if (i.kind != InstanceKind::glyph) {
                last = nullptr;
                if (!covers(i)) continue;
                const Rect hidden = intersect(rect, clip);
                for (TextSeen& text : texts)
                    std::erase_if(text.glyphs,
                                  [&](const Rect& g) { return hidden.contains(middle(intersect(g, text.clip))); });
                continue;
            }
            if (!rect.overlaps(clip) || i.color.a == 0) continue;
            // A glyph belongs to the same line if it has the same colour and follows to the right.
            const bool on = last != nullptr && std::memcmp(&last->color, &i.color, sizeof i.color) == 0 &&
                            i.clip == last->clip && i.x > last->x - 0.1F * em && i.x < last->x + last->w + em &&
                            i.y < last->y + last->h + em && i.y + i.h > last->y - em;
            if (!on) texts.push_back({.rect = {}, .glyphs = {}, .clip = clip});
            texts.back().glyphs.push_back(rect);
            // A path may begin with it: then it does not count, unless it is all that there is.
            texts.back().elided = (texts.back().elided && texts.back().glyphs.size() > 2) || ellipses.has(i);
            last = &i;
        }
    }
    std::erase_if(texts, [](const TextSeen& t) { return t.glyphs.empty(); });
    for (TextSeen& text : texts) {
        glm::vec2 low{1e9F}, high{-1e9F};
        for (const Rect& glyph : text.glyphs) {
            const Rect seen = intersect(glyph, text.clip);
            low = glm::min(low, seen.at()), high = glm::max(high, seen.at() + seen.size());
        }
        text.rect = {low.x, low.y, high.x - low.x, high.y - low.y};
    }
    return texts;
}

std::uint32_t node_of(std::span<const Node> tree, const TextSeen& text) {
    std::uint32_t found = no_node;
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
        const Node& node = tree[i];
        // A splitter has no text of its own and is drawn over its neighbours.
        if (node.label.empty() || node.role == Role::splitter || !node.seen().contains(middle(text.rect))) continue;
        if (found == no_node || node.layer > tree[found].layer ||
            (node.layer == tree[found].layer && (node.role != Role::none || tree[found].role == Role::none)))
            found = i;
    }
    return found;
}

std::vector<std::string> texts_over_texts(std::span<const Node> tree, const std::vector<TextSeen>& texts, float em) {
    std::vector<std::string> found;
    const float least = 0.12F * em;  // letters of a line overlap by less, and so do successive lines
    for (std::size_t a = 0; a < texts.size(); ++a)
        for (std::size_t b = a + 1; b < texts.size(); ++b) {
            const Rect both = intersect(texts[a].rect, texts[b].rect);
            if (both.w <= least || both.h <= least) continue;
            const auto meet = [&](const Rect& g, const Rect& h) {
                const Rect common = intersect(intersect(g, texts[a].clip), intersect(h, texts[b].clip));
                return common.w > least && common.h > least;
            };
            const bool over = std::any_of(texts[a].glyphs.begin(), texts[a].glyphs.end(), [&](const Rect& g) {
                return std::any_of(texts[b].glyphs.begin(), texts[b].glyphs.end(),
                                   [&](const Rect& h) { return meet(g, h); });
            });
            if (over) found.push_back(place_of(tree, texts[a]) + " and " + place_of(tree, texts[b]));
        }
    return found;
}

std::vector<std::string> cut_texts(std::span<const Node> tree, const std::vector<TextSeen>& texts, float em) {
    std::vector<std::string> found;
    for (const TextSeen& text : texts) {
        const std::uint32_t node = node_of(tree, text);
        if (node == no_node) continue;
        if (text.elided && is_label_of_control(tree[node].role))
            found.push_back(place_of(tree, text) + ": its label is elided");
        if (text.elided && ends_where_there_is_room(tree[node], text, em))
            found.push_back(place_of(tree, text) + ": its end is missing");
        float sides = 0, height = 0, whole = 0;
        for (const Rect& glyph : text.glyphs) {
            const Rect seen = intersect(glyph, text.clip);
            sides = std::max(sides, glyph.w - seen.w);
            height = std::max(height, glyph.h - seen.h);
            whole = std::max(whole, glyph.h);
        }
        if (in_panned(tree, node)) continue;
        if (text.elided && text.glyphs.size() <= 2) found.push_back(place_of(tree, text) + ": nothing of it is left");
        // Half of a name looks like a mistake on a tab, although the strip scrolls.
        if (sides > 0.15F * em && (tree[node].role == Role::tab || !scrolled(tree, node, 0)))
            found.push_back(place_of(tree, text) + ": cut at the side by" + box_text(text.clip));
        if (height > 0.15F * em && !scrolled(tree, node, 1))
            found.push_back(place_of(tree, text) + ": cut in height by" + box_text(text.clip));
    }
    return found;
}

}  // namespace lapfx::ui
