// Nothing that is read is replaced by what is written, whatever the names: links and other spellings count as the same
// file. What a program reads is noted where files are opened and where a document names one, and what it writes is
// refused where files are made (Beside), so a new command has this without asking for it.
//
//     lapfx::guard_files(lapfx::FileGuard::refuse);        // once, before anything is read
//     lapfx::claim_output("--json", "amounts.json");       // before the work: throws what would be thrown after it
//
// A pattern of numbered images ("frame_%04d.png") stands for all images of that name, and is read when one of them is.
// Once it is noted, its images are known by name alone. Process-wide; any thread.
#pragma once

#include <filesystem>
#include <string>

namespace lapfx {

enum class FileGuard {
    off,     ///< a host: nothing is noted
    note,    ///< the editor, which saves what it has opened, and asks is_read() before it exports
    refuse,  ///< a command
};

/// Begins anew with this; what was noted before is forgotten.
void guard_files(FileGuard guard);

/// A file that is read, or that a document names, whether it exists or not. Throws Error (bad_input) that names the
/// option when that is an output that was claimed.
void note_read(const std::filesystem::path& path);

/// An output of a command, by the option that names it; a pattern is one. Nothing, unless files are refused. Throws
/// Error (bad_input) at `option` when that is a file that is read, or the output of another option.
void claim_output(const std::string& option, const std::filesystem::path& path);

/// Whether this is a file that was noted.
bool is_read(const std::filesystem::path& path);

/// Throws Error (bad_input) for a file that was noted, where such are refused.
void require_not_read(const std::filesystem::path& path);

/// From now on this file may be replaced: it is rewritten in place.
void allow_rewriting(const std::filesystem::path& path);

}  // namespace lapfx
