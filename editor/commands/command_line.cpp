#include "commands/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <span>
#include <sstream>
#include <type_traits>
#include <utility>

#include "commands/help_layout.h"
#include "lapfx/error.h"

namespace lapfx::commands {

namespace {

/// What is in a target before anything is parsed, as it is told; "" for what is no single value.
std::string text_of(const Target& target) {
    return std::visit(
        []<typename To>(To to) -> std::string {
            if constexpr (std::is_same_v<To, std::string*>) return *to;
            if constexpr (std::is_pointer_v<To> && std::is_arithmetic_v<std::remove_pointer_t<To>>) {
                std::ostringstream text;
                text << *to;
                return text.str();
            }
            return "";
        },
        target);
}

bool is_finite(const std::string& text) {
    double value = 0.0;
    return CLI::detail::lexical_cast(text, value) && std::isfinite(value);
}

/// CLI::Range, too, accepts "nan" and "inf".
std::string fault_of(Number number, const std::string& text) {
    const auto fault = [&text](bool sound, const char* allowed) {
        return sound ? std::string() : '"' + text + "\" is not a " + allowed;
    };
    switch (number) {
        case Number::any:
            break;
        case Number::finite:
            return fault(is_finite(text), "number");
        case Number::above_0: {
            double value = 0.0;
            return fault(is_finite(text) && CLI::detail::lexical_cast(text, value) && value > 0.0, "number above 0");
        }
        case Number::whole: {
            std::uint32_t value = 0;
            const char* const all = text.data() + text.size();
            const auto [end, code] = std::from_chars(text.data(), all, value);
            return fault(code == std::errc() && end == all, "whole number from 0 to 4294967295");
        }
    }
    return "";
}

/// The program as CLI11 knows it.
class Parser {
  public:
    Parser(const Verb& program, const std::string& version) : app_(program.help, program.name) {
        app_.set_version_flag("--version", version);
        app_.require_subcommand(0, 1);
        for (const Verb& verb : program.parts) {
            CLI::App& sub = add(app_, verb);
            if (!verb.parts.empty()) sub.require_subcommand(1);
            for (const Verb& part : verb.parts) add(sub, part);
        }
    }

    void parse(std::vector<std::string> arguments) {
        std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
        app_.parse(std::move(arguments));
        for (const auto& [option, given] : given_) *given = *given || option->count() > 0;
    }
    /// Below `program`: the names of the command, and of its part, that were given.
    std::vector<std::string> chosen() const {
        std::vector<std::string> names;
        for (const CLI::App* app = &app_; !app->get_subcommands().empty(); names.push_back(app->get_name()))
            app = app->get_subcommands().back();
        return names;
    }

  private:
    CLI::App& add(CLI::App& parent, const Verb& verb) {
        CLI::App& app = *parent.add_subcommand(verb.name, verb.help);
        for (const Option& option : verb.options)
            if (!std::holds_alternative<std::monostate>(option.to)) add(app, option);
        return app;
    }
    void add(CLI::App& app, const Option& option) {
        CLI::Option* const made = std::visit([&](auto to) { return add(app, option.names, to); }, option.to);
        const Rules& rules = option.rules;
        made->required(rules.required);
        if (rules.one_each) made->allow_extra_args(false);
        if (rules.separator != 0) made->delimiter(rules.separator);
        if (rules.count != 0) made->expected(rules.count);
        const Number number = rules.range && !std::holds_alternative<int*>(option.to) ? Number::finite : rules.number;
        if (number != Number::any) made->check([number](const std::string& text) { return fault_of(number, text); });
        if (rules.range && std::holds_alternative<int*>(option.to))
            made->check(CLI::Range(static_cast<int>(rules.range->least), static_cast<int>(rules.range->most)));
        else if (rules.range)
            made->check(CLI::Range(rules.range->least, rules.range->most));
        if (!rules.words.empty()) made->check(CLI::IsMember(rules.words));
        for (const std::string& other : rules.excludes) made->excludes(other);
        if (rules.given != nullptr) given_.emplace_back(made, rules.given);
    }
    template <typename To>
    static CLI::Option* add(CLI::App& app, const std::string& names, To to) {
        if constexpr (std::is_same_v<To, std::monostate>)
            return nullptr;
        else if constexpr (std::is_same_v<To, bool*>)
            return app.add_flag(names, *to);
        else
            return app.add_option(names, *to);
    }

    CLI::App app_;
    std::vector<std::pair<const CLI::Option*, bool*>> given_;
};

/// `names`: of a command and of its part.
const Verb& verb_at(const Verb& program, std::span<const std::string> names) {
    const Verb* verb = &program;
    for (const std::string& name : names)
        verb = &*std::find_if(verb->parts.begin(), verb->parts.end(), [&](const Verb& v) { return v.name == name; });
    return *verb;
}

}  // namespace

bool Option::is_list() const {
    return std::holds_alternative<std::vector<std::string>*>(to) || std::holds_alternative<std::vector<double>*>(to);
}

std::vector<std::string> Option::split_names() const {
    std::vector<std::string> split;
    std::istringstream all(is_argument() ? "" : names);
    for (std::string name; std::getline(all, name, ',');) split.push_back(name);
    return split;
}

void Verb::argument(std::string_view name_of_it, std::string_view help_of_it, Target to, Rules rules) {
    option(name_of_it, "", help_of_it, to, std::move(rules));
}

void Verb::option(std::string_view names, std::string_view takes, std::string_view help_of_it, Target to, Rules rules) {
    options.push_back({.names = std::string(names),
                       .takes = std::string(takes),
                       .help = std::string(help_of_it),
                       .to = to,
                       .rules = std::move(rules)});
    if (options.back().rules.shows_default) options.back().standard = text_of(to);
}

void Verb::flag(std::string_view names, std::string_view help_of_it, bool* to, Rules rules) {
    option(names, "", help_of_it, to, std::move(rules));
}

std::function<void()> parse(const Verb& program, std::vector<std::string> arguments, const std::string& version) {
    Parser parser(program, version);
    try {
        parser.parse(std::move(arguments));
        return verb_at(program, parser.chosen()).run;
    } catch (const CLI::CallForHelp&) {
        std::string name = program.name;
        const std::vector<std::string> names = parser.chosen();
        for (const std::string& word : names) name += ' ' + word;
        std::cout << help_text(verb_at(program, names), name);
    } catch (const CLI::CallForVersion&) {
        std::cout << version << '\n';
    } catch (const CLI::ParseError& wrong) {
        throw Error(Failure::bad_input,
                    Fault{.file = "", .place = "", .reason = std::string(wrong.what()) + " (see lapfx help)"});
    }
    return [] {};
}

}  // namespace lapfx::commands
