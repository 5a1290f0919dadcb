#include "commands/verb.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "lapfx/authoring/letters.h"

namespace lapfx::commands {

namespace {

constexpr std::size_t longest_verb = 32;  // longer words are cut before the comparison

bool could_be_file(const std::string& word) {
    std::error_code error;
    return word.find_first_of("./%") != std::string::npos || std::filesystem::exists(word, error);
}

/// `what`: "is neither a command nor a file". A word that resembles none is not led astray.
Error refused(const std::string& word, const std::string& what, std::span<const std::string> known) {
    const std::string shown = word.substr(0, longest_verb);
    const auto nearest = std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
        return edit_distance(shown, a) < edit_distance(shown, b);
    });
    const bool resembles = nearest != known.end() && 2 * edit_distance(shown, *nearest) <= shown.size();
    return {Failure::bad_input, Fault{.file = "",
                                      .place = "",
                                      .reason = "\"" + shown + "\" " + what +
                                                (resembles ? "; nearest is " + *nearest : "") + " (see lapfx help)"}};
}

Error unknown_verb(const std::string& word, std::span<const std::string> verbs) {
    return refused(word, "is neither a command nor a file", verbs);
}

}  // namespace

Error unknown_word(const std::string& word, const std::string& what, std::span<const std::string> known) {
    return refused(word, "is not a " + what, known);
}

void require_values(std::span<const std::string> arguments) {
    std::string before;
    for (const std::string& argument : arguments) {
        const bool unset = argument.starts_with("--") && argument.find('=') == argument.size() - 1;
        if (argument.empty() || unset)
            throw Error(Failure::bad_input, Fault{.file = "",
                                                  .place = unset ? argument.substr(0, argument.size() - 1)
                                                           : before.starts_with('-') ? before
                                                                                     : "",
                                                  .reason = "\"\" is empty; a value is needed here"});
        before = argument;
    }
}

std::vector<std::string> with_verb(std::vector<std::string> arguments, std::span<const std::string> verbs) {
    const auto is_verb = [&](const std::string& word) {
        return std::find(verbs.begin(), verbs.end(), word) != verbs.end();
    };
    if (arguments.empty()) return {"edit"};
    const std::string first = arguments.front();
    for (const char* own : {"-h", "--help", "--version"})
        if (first == own) return arguments;
    if (is_verb(first)) return arguments;
    if (!first.starts_with('-') && !could_be_file(first)) throw unknown_verb(first, verbs);
    arguments.insert(arguments.begin(), "edit");
    return arguments;
}

}  // namespace lapfx::commands
