// SPDX-License-Identifier: Apache-2.0
// Replaces files as a whole: at every moment, even if the program or the machine stops, a path has its complete old or
// its complete new content.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "host/base/descriptor.hpp"

namespace canproof::host {

/// Throws std::filesystem::filesystem_error: its message says that `path` cannot be written, its code is errno.
[[noreturn]] void refuse_to_write(const std::filesystem::path& path);

/// A temporary file in the folder of a target. replace() or create() gives it the name of the target. The file is
/// locked (flock) before the first byte is written. The destructor removes the temporary file. Every function throws
/// std::system_error with the target's path on an error; the constructor also when the existing target is not writable.
class FileBeside {
  public:
    /// Creates the temporary file. `target` should be resolved: if it is a symbolic link, the file replaces the link.
    explicit FileBeside(std::filesystem::path target);
    ~FileBeside();
    FileBeside(const FileBeside&) = delete;
    FileBeside& operator=(const FileBeside&) = delete;

    /// Writes the bytes. When the function returns, they are on disk.
    void write(std::string_view bytes);
    /// Replaces `target` and keeps the permissions of `target`. When the function returns, the file is on disk. After
    /// an exception, the path has the old or the new content.
    void replace();
    /// Gives the file the name `target` and returns true. Returns false if a file has this name already, or if another
    /// process has removed the temporary file.
    bool create();
    /// Moves the descriptor of the locked file to the caller.
    Descriptor take() { return std::move(file_); }

  private:
    [[noreturn]] void fail() const;
    void sync_folder() const;

    std::filesystem::path target_;
    std::filesystem::path beside_;
    Descriptor file_;
    bool placed_{false};
};

/// Removes temporary files that a killed program left beside `target`. Must be used only if at most one process at a
/// time writes `target`.
void remove_leftovers(const std::filesystem::path& target);

/// Replaces the content of `path`. When the function returns, the new content is on disk. Follows a symbolic link, and
/// writes directly to a device file or a FIFO. Throws std::system_error on an error.
void replace_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace canproof::host
