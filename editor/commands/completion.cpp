#include "commands/completion.h"

#include <algorithm>

#include "commands/help_topics.h"
#include "lapfx/authoring/formats.h"

namespace lapfx::commands {

namespace {

// Only what bash has itself: the package bash-completion need not be there. An ending is also taken in capitals.
constexpr std::string_view script_begin = R"(# Completion of lapfx in bash, printed by `lapfx help --completion bash`.
_lapfx_files() {
    local ending
    compopt -o filenames
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(
        compgen -d -- "$word"
        for ending in "$@" "${@^^}"; do compgen -f -X "!*$ending" -- "$word"; done
    )
}

_lapfx() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=edit
    local words='' endings=()
    COMPREPLY=()
    # bash takes --option=value for three words.
    [ "$before" != = ] || before=${COMP_WORDS[COMP_CWORD - 2]}
    [ "$word" != = ] || word=''
)";

constexpr std::string_view script_end = R"(    esac
    # Where files are taken, options are offered once a word begins as they do.
    if [ -n "$word" ] || [ "${#endings[@]}" -eq 0 ]; then
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    fi
    if [ "${#COMPREPLY[@]}" -eq 0 ] && [ "${#endings[@]}" -gt 0 ]; then _lapfx_files "${endings[@]}"; fi
}
complete -F _lapfx lapfx
)";

std::string joined(const std::vector<std::string>& parts, const std::string& separator) {
    std::string out;
    for (const std::string& part : parts) out += (out.empty() ? "" : separator) + part;
    return out;
}

/// "egl", "Tune"; not "WxH", "S" or "KEY".
bool is_word(std::string_view text) {
    const auto is_small = [](char c) { return c >= 'a' && c <= 'z'; };
    return text.size() > 1 && (is_small(text[0]) || (text[0] >= 'A' && text[0] <= 'Z')) &&
           std::all_of(text.begin() + 1, text.end(), is_small);
}

void add_kind(Values& values, std::string_view kind) {
    const auto add = [&](const std::vector<std::string>& more) {
        values.endings.insert(values.endings.end(), more.begin(), more.end());
    };
    constexpr std::string_view file = "FILE";
    if (is_word(kind)) values.words.emplace_back(kind);
    if (kind.starts_with(file)) add({std::string(kind.substr(file.size()))});
    if (kind == "SCENE") add({".scene.json"});
    if (kind == "VIDEO" || kind == "REFERENCE")
        for (const Content content : {Content::video, Content::picture}) add(extensions(content));
    if (kind == "DIR" || kind == "FOLDER" || kind == "RESULTS") add({"/"});
    if (kind == "WORD")
        for (const HelpTopic& topic : help_topics()) values.words.emplace_back(topic.name);
}

std::string set(const std::vector<std::string>& words, const std::vector<std::string>& endings) {
    std::string out = "words=\"" + joined(words, " ") + "\" endings=(";
    for (const std::string& ending : endings) out += (out.ends_with('(') ? "\"" : " \"") + ending + '"';
    return out + ')';
}

/// The arm of a command: what it takes, and behind an option with a value what that may be.
std::string arm(const Verb& program, const Verb& verb, const std::string& name) {
    std::vector<std::string> words, endings;
    std::string behind;
    for (const Verb& part : verb.parts) words.push_back(part.name);
    for (const Option& option : verb.options) {
        const Values values = values_of(option.is_argument() ? option.names : option.takes);
        if (option.is_argument()) {
            words.insert(words.end(), values.words.begin(), values.words.end());
            endings.insert(endings.end(), values.endings.begin(), values.endings.end());
            continue;
        }
        const std::vector<std::string> names = option.split_names();
        words.insert(words.end(), names.begin(), names.end());
        if (!option.takes.empty())
            behind += "                " + joined(names, " | ") + ") " + set(values.words, values.endings) + " ;;\n";
    }
    if (verb.name == "help")  // WORD is a command, too
        for (const Verb& command : program.parts) words.push_back(command.name);
    std::string out = "        \"" + name + "\")\n            " + set(words, endings) + '\n';
    if (!behind.empty()) out += "            case $before in\n" + behind + "            esac\n";
    return out + "            ;;\n";
}

}  // namespace

Values values_of(std::string_view takes) {
    Values values;
    for (std::size_t begin = 0, end = 0; end != std::string_view::npos; begin = end + 1) {
        end = takes.find('|', begin);
        add_kind(values, takes.substr(begin, end - begin));
    }
    return values;
}

std::string bash_completion(const Verb& program) {
    std::vector<std::string> verbs, with_parts;
    std::string arms;
    for (const Verb& verb : program.parts) {
        verbs.push_back(verb.name);
        arms += arm(program, verb, verb.name);
        for (const Verb& part : verb.parts) arms += arm(program, part, verb.name + ' ' + part.name);
        if (!verb.parts.empty()) with_parts.push_back(verb.name);
    }
    // The first word is a command, or a file for the editor.
    std::string out(script_begin);
    return out.append("    local verbs=\"") + joined(verbs, " ") + "\"\n" +
           "    case \" $verbs \" in\n        *\" ${COMP_WORDS[1]} \"*) command=${COMP_WORDS[1]} ;;\n    esac\n" +
           "    case $command in\n        " + joined(with_parts, " | ") +
           ") [ \"$COMP_CWORD\" -eq 2 ] || command+=\" ${COMP_WORDS[2]}\" ;;\n    esac\n" +
           "    [ \"$COMP_CWORD\" -ne 1 ] || command=''\n    case $command in\n        \"\")\n" +
           "            words=\"$verbs --help --version\"\n            [ -z \"$word\" ] || endings=(\"\")\n" +
           "            ;;\n" + arms + std::string(script_end);
}

}  // namespace lapfx::commands
