// What differs between two states of a preset or of a scene: enough to turn either into the other, and no more. Undo
// steps are made of these, so a step is as large as the change, however large the document is.
//
//     const Delta delta(preset_table(), before, after);
//     delta.redo(preset);  // as after
//     delta.undo(preset);  // as before
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
    /// Of nothing: empty.
    Delta() = default;
    /// `Document`: Preset or Scene; `table` is its table, which outlives this.
    template <class Document>
    Delta(const Table& table, const Document& before, const Document& after) : table_(&table) {
        if (before.folder != after.folder) folders_ = {before.folder, after.folder};
        compare(table, &before, &after, "");
    }

    /// The document must be as it was before; then it is as it was after. And the other way round.
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
    /// Whether the value at this JSON pointer differs; elements that came or went are not looked into.
    bool changes(std::string_view place) const;
    /// A text that was `from` before or after is `to` from now on; one that no longer differs is forgotten.
    void replace(std::string_view place, const std::string& from, const std::string& to);
    /// Bytes that it takes beside its own.
    std::size_t memory() const;

  private:
    /// One place and what stands there, written by the table (delta.cpp).
    struct Change {
        enum class What {
            value,     ///< of one parameter
            presence,  ///< of an object that may be left out
            elements,  ///< a part of a list, from `first` to before the last elements, which are equal
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
    std::vector<std::filesystem::path> folders_;  ///< before and after; empty: they are the same
};

}  // namespace lapfx::document
