// What the verbs of `lapfx` take: plain tables of options, which each verb fills. command_line.cpp parses by them, and
// help, man pages and completion are written from them. No other file includes CLI11: that costs a compiler more than
// a verb does.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lapfx::commands {

/// Where a value goes. Nowhere (monostate): of --help and --version, which parse() answers itself.
using Target =
    std::variant<std::monostate, bool*, int*, std::uint32_t*, float*, double*, std::string*, std::optional<double>*,
                 std::optional<std::size_t>*, std::vector<double>*, std::vector<std::string>*>;

struct Range {
    double least, most;  ///< both are allowed
};

enum class Number { any, finite, above_0, whole };  ///< "nan" and "inf" are numbers, too; whole: 0 to 2^32 - 1

/// What a value must be, and how often it may be given.
struct Rules {
    bool required = false;
    bool shows_default = false;              ///< what is in `to` already is told as the default
    bool one_each = false;                   ///< true: a list takes one value behind each name, which may be repeated
    char separator = 0;                      ///< of a list: between values behind one name; 0: none
    int count = 0;                           ///< of a list: exactly so many values; 0: one or more
    Number number = Number::any;             ///< only these numbers are allowed
    std::optional<Range> range = {};         ///< finite numbers are within it; they are whole for an int
    std::vector<std::string> words = {};     ///< no others are allowed; empty: any
    std::vector<std::string> excludes = {};  ///< names of options that are not given beside it; they are added before
    bool* given = nullptr;                   ///< becomes true where it is on the command line
};

struct Option {
    std::string names;  ///< "-o,--output"; "SCENE", an argument without a name
    /// "WxH". Where it takes one of several words or kinds of files, '|' is between them ("dark|light"), and one of
    /// files is FILE with their ending ("FILE.json"): bash is told so, too (completion.h). Empty: a flag or an
    /// argument.
    std::string takes;
    std::string help;
    Target to = {};
    Rules rules = {};
    std::string standard = {};  ///< the default that is told; empty: none

    bool is_argument() const { return !names.starts_with('-'); }
    bool is_list() const;  ///< takes several values
    /// "-o" and "--output"; of an argument none.
    std::vector<std::string> split_names() const;
};

/// A command, a part of one ("bench streaming"), or the program with its commands as parts.
struct Verb {
    std::string name;
    std::string help;
    std::string footer = {};  ///< below the options
    std::vector<Option> options = {{"-h,--help", "", "Print this help"}};
    std::vector<Verb> parts = {};    ///< one of them is needed where there are any
    bool is_program = false;         ///< its parts are commands
    std::function<void()> run = {};  ///< once all values are where they go. Throws lapfx::Error on failure

    void argument(std::string_view name, std::string_view help, Target to, Rules rules = {});
    void option(std::string_view names, std::string_view takes, std::string_view help, Target to, Rules rules = {});
    void flag(std::string_view names, std::string_view help, bool* to, Rules rules = {});
};

/// Puts the values of `arguments` (without the program's name) where they go and returns what is to run, or nothing
/// where they asked for --help or --version, which is printed. `program` must live until it has run. Throws Error
/// (bad_input).
std::function<void()> parse(const Verb& program, std::vector<std::string> arguments, const std::string& version);

}  // namespace lapfx::commands
