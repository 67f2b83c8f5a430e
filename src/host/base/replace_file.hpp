// Files that are written as a whole: at every moment, whatever ends the program or the machine, a path has its whole
// old content or its whole new one.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "host/base/descriptor.hpp"

namespace canproof::host {

/// Throws std::filesystem::filesystem_error: that `path` cannot be written, and why by errno.
[[noreturn]] void refuse_to_write(const std::filesystem::path& path);

/// A new file beside another one, to take its place. It is locked (flock) from its first byte on, and removed unless it
/// took the place. Every function throws std::system_error, with the target's path, when the disk refuses.
class FileBeside {
  public:
    /// A link must have been followed: `target` gets the place of the link otherwise.
    explicit FileBeside(std::filesystem::path target);
    ~FileBeside();
    FileBeside(const FileBeside&) = delete;
    FileBeside& operator=(const FileBeside&) = delete;

    /// On disk when it returns.
    void write(std::string_view bytes);
    /// Takes the place of `target`, which keeps its permissions. On disk when it returns; when it throws, the old
    /// content or the new one stands.
    void replace();
    /// Takes the place when there is no `target` yet, else returns false.
    bool create();
    /// The locked file.
    Descriptor take() { return std::move(file_); }

  private:
    [[noreturn]] void fail() const;
    void sync_folder() const;

    std::filesystem::path target_;
    std::filesystem::path beside_;
    Descriptor file_;
    bool placed_{false};
};

/// What a program that was killed left beside `target`. Only for targets that one process at a time writes.
void remove_leftovers(const std::filesystem::path& target);

/// The new content of `path`, on disk when it returns. A link is followed; a device or a FIFO is written to. Throws
/// std::system_error.
void replace_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace canproof::host
