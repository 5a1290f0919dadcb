#include "gl/shader_source.h"

#include <fstream>
#include <optional>
#include <regex>
#include <sstream>
#include <utility>

#include "gl/generated_shaders.h"
#include "lapfx/error.h"

namespace lapfx::gl {

// Written at build time by effects/cmake/write_embedded_shaders.cmake.
extern const std::pair<std::string_view, std::string_view>* const embedded_shaders;
extern const unsigned embedded_shader_count;

namespace {

std::filesystem::path& shader_folder() {
    static std::filesystem::path folder;
    return folder;
}

std::string content_of(std::ifstream& file) {
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::mutex ShaderTrial::mutex_;
std::shared_ptr<const ShaderTrial::Texts> ShaderTrial::texts_;

ShaderTrial::ShaderTrial(const std::filesystem::path& folder) {
    auto texts = std::make_shared<Texts>();
    std::error_code error;
    for (std::filesystem::directory_iterator file(folder, error), end; !error && file != end; file.increment(error)) {
        if (std::error_code gone; !file->is_regular_file(gone)) continue;  // opening a pipe would wait for its writer
        if (std::ifstream in(file->path(), std::ios::binary); in)
            (*texts)[file->path().filename().string()] = content_of(in);
    }
    if (error) throw Error(Failure::runtime, Fault{.file = folder.string(), .place = "", .reason = error.message()});
    const std::lock_guard lock(mutex_);
    former_ = std::exchange(texts_, std::move(texts));
}

ShaderTrial::~ShaderTrial() {
    const std::lock_guard lock(mutex_);
    if (!kept_) texts_ = std::move(former_);
}

std::optional<std::string> text_on_trial(const std::string& name) {
    const std::lock_guard lock(ShaderTrial::mutex_);
    if (!ShaderTrial::texts_) return std::nullopt;
    const auto found = ShaderTrial::texts_->find(name);
    return found == ShaderTrial::texts_->end() ? std::nullopt : std::optional(found->second);
}

namespace {

std::optional<std::string> text_on_disk(const std::string& name) {
    if (!shader_folder().empty()) {
        std::ifstream file(shader_folder() / name, std::ios::binary);
        if (file) return content_of(file);
    }
    return text_on_trial(name);
}

std::optional<std::string> embedded_text(const std::string& name) {
    for (unsigned i = 0; i < embedded_shader_count; ++i)
        if (embedded_shaders[i].first == name) return std::string(embedded_shaders[i].second);
    return std::nullopt;
}

/// The file name in a line `#include "name"`, otherwise empty.
std::string included_name(const std::string& line) {
    const std::string word = "#include \"";
    const std::size_t end = line.rfind('"');
    if (!line.starts_with(word) || end < word.size()) return {};
    return line.substr(word.size(), end - word.size());
}

void append(ShaderSource& source, const std::string& name, const std::string& from) {
    std::optional<std::string> text = text_on_disk(name);
    source.edited |= text.has_value();
    if (!text) text = embedded_text(name);
    if (!text) text = generated_text(name);
    if (!text)
        throw Error(Failure::runtime, Fault{.file = from.empty() ? name : from,
                                            .place = "",
                                            .reason = "the shader file \"" + name + "\" is missing"});
    const std::size_t number = source.files.size();
    source.files.push_back(name);
    if (number > 0) source.text += "#line 1 " + std::to_string(number) + "\n";
    std::istringstream lines(*text);
    std::string line;
    for (int count = 1; std::getline(lines, line); ++count) {
        const std::string included = included_name(line);
        if (included.empty()) {
            source.text += line + "\n";
            continue;
        }
        const bool known = std::find(source.files.begin(), source.files.end(), included) != source.files.end();
        if (!known) append(source, included, name);
        source.text += "#line " + std::to_string(count + 1) + " " + std::to_string(number) + "\n";
    }
}

/// Line `wanted` of the file with this number inside the joined text.
std::string source_line(const ShaderSource& source, std::size_t file, int wanted) {
    std::istringstream lines(source.text);
    std::string line;
    std::size_t current = 0;
    int number = 0;
    while (std::getline(lines, line)) {
        if (line.starts_with("#line ")) {
            std::istringstream mark(line.substr(6));
            mark >> number >> current;
            --number;
            continue;
        }
        if (++number == wanted && current == file) return line;
    }
    return {};
}

}  // namespace

ShaderSource shader_source(const std::string& name) {
    ShaderSource source;
    append(source, name, "");
    return source;
}

std::string host_text(const std::string& name) {
    std::istringstream lines(shader_source(name).text);
    std::string text, line;
    while (std::getline(lines, line))
        if (!line.starts_with("#line ")) text += line + "\n";
    return text;
}

void set_shader_folder(const std::filesystem::path& folder) {
    shader_folder() = folder;
}

std::string readable_log(const ShaderSource& source, const std::string& log) {
    // Mesa and most others write "string:line(column): message" or "string(line) : message".
    static const std::regex place(R"(^(\d+)[:(](\d+))");
    std::istringstream lines(log);
    std::string line, out;
    while (std::getline(lines, line)) {
        std::smatch match;
        if (!std::regex_search(line, match, place) || std::stoul(match[1]) >= source.files.size()) {
            out += line + "\n";
            continue;
        }
        const std::size_t file = std::stoul(match[1]);
        const int number = std::stoi(match[2]);
        out += source.files[file] + ":" + match[2].str() + line.substr(static_cast<std::size_t>(match.length())) + "\n";
        for (int n = std::max(1, number - 2); n <= number + 2; ++n)
            out += (n == number ? "  > " : "    ") + std::to_string(n) + " | " + source_line(source, file, n) + "\n";
    }
    return out;
}

}  // namespace lapfx::gl
