// Where shader text comes from: the files of shaders/ as embedded at build, or a folder on disk that
// overrides them while the editor runs. `#include "name"` is resolved here, once per file, with #line marks
// so that a compiler's message can be traced back to file and line.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace lapfx::gl {

struct ShaderSource {
    std::string text;                ///< ready for the compiler
    std::vector<std::string> files;  ///< source string number i of the #line marks is files[i]
    bool edited = false;             ///< some of it comes from a folder on disk
};

/// `name` is a file name such as "organ.frag". Throws Error (runtime) when it, or a file that it includes, is missing.
ShaderSource shader_source(const std::string& name);

/// The same for a host, which pastes it into a shader of its own: without #line marks, whose file numbers mean nothing
/// to it.
std::string host_text(const std::string& name);

/// While it lives, and afterwards if kept, the files of a folder come before the embedded ones, with their present
/// content, so that a later mistake in a file breaks nothing. Shaders that are not in the folder are the embedded ones.
/// Any thread.
class ShaderTrial {
  public:
    explicit ShaderTrial(const std::filesystem::path& folder);
    ~ShaderTrial();
    ShaderTrial(const ShaderTrial&) = delete;
    ShaderTrial& operator=(const ShaderTrial&) = delete;
    void keep() { kept_ = true; }

  private:
    using Texts = std::map<std::string, std::string>;
    friend std::optional<std::string> text_on_trial(const std::string& name);
    static std::mutex mutex_;
    static std::shared_ptr<const Texts> texts_;

    std::shared_ptr<const Texts> former_;
    bool kept_ = false;
};

/// From now on files in `folder` come before all others, read when they are needed; an empty path ends that.
void set_shader_folder(const std::filesystem::path& folder);

/// The compiler's log with file names for the string numbers, followed by the lines that it mentions, numbered.
std::string readable_log(const ShaderSource& source, const std::string& log);

}  // namespace lapfx::gl
