// What differs between two states of a preset or of a scene: enough to turn either into the other, and no more. Undo
// steps are made of these, so a step is as large as the change, however large the document is.
//
//     const Delta delta(preset_table(), before, after);
//     delta.redo(preset);  // as after
//     delta.undo(preset);  // as before
//
// Elements of a list are compared place by place from its front, and what is equal at its end counts as kept: moving an
// element to another place changes all those between.
//
// Both directions give back every letter and every bit, also values that no row allows and those of parts that are
// switched off.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "lapfx/parameter.h"

namespace lapfx::document {

class Delta {
  public:
    /// An empty one.
    Delta() = default;
    /// `Document`: Preset or Scene; `table` is its table, which outlives this.
    template <class Document>
    Delta(const Table& table, const Document& before, const Document& after) : table_(&table) {
        if (before.folder != after.folder) folders_ = {before.folder, after.folder};
        compare(table, &before, &after, "");
    }

    /// redo() takes a document in the state before and brings it to the state after; undo() does the reverse.
    template <class Document>
    void redo(Document& document) const {
        put(&document, &Change::after);
        if (!folders_.empty()) document.folder = folders_[1];
    }
    template <class Document>
    void undo(Document& document) const {
        put(&document, &Change::before);
        if (!folders_.empty()) document.folder = folders_[0];
    }

    bool empty() const { return changes_.empty() && folders_.empty(); }
    /// Whether the value at this JSON pointer differs. Values inside of elements that were added or removed do not
    /// count.
    bool changes(std::string_view place) const;
    /// Replaces the text `from`, before and after, by `to`. A text that no longer differs then is forgotten.
    void replace(std::string_view place, const std::string& from, const std::string& to);
    /// Bytes that it has allocated.
    std::size_t memory() const;

  private:
    /// One place and its content before and after, as bytes (delta.cpp).
    struct Change {
        enum class What {
            value,     ///< the value of one parameter
            presence,  ///< whether an object that may be left out exists
            elements,  ///< a part of a list: from `first` up to the elements at the end that are equal
        };
        What what = What::value;
        std::string place;  ///< JSON pointer
        std::size_t first = 0;
        std::string before, after;
    };

    void compare(const Table& table, const void* before, const void* after, const std::string& place);
    void compare_list(const Table& list, const void* before, const void* after, const std::string& place);
    void put(void* document, std::string Change::*state) const;

    const Table* table_ = nullptr;
    std::vector<Change> changes_;
    std::vector<std::filesystem::path> folders_;  ///< the folder before and the one after; empty: they are the same
};

}  // namespace lapfx::document
