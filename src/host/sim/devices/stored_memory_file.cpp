// SPDX-License-Identifier: Apache-2.0
#include "host/sim/devices/stored_memory_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string_view>
#include <system_error>

#include "host/base/file_lock.hpp"
#include "host/base/input_error.hpp"
#include "host/base/replace_file.hpp"

namespace canproof::host {

namespace {

namespace fs = std::filesystem;
using Image = std::vector<std::uint8_t>;

[[noreturn]] void refuse_to_read(const fs::path& path, const std::string& why) {
    throw InputError{fmt::format("cannot read {}: {}; correct this or name another file", path.string(), why)};
}

std::string last_error() {
    return std::strerror(errno);
}

std::string_view text(const Image& image) {
    return {reinterpret_cast<const char*>(image.data()), image.size()};
}

/// Opens an existing file. Follows a symbolic link. Throws InputError for anything that is no regular file.
Descriptor open_existing(const fs::path& path) {
    struct stat found {};
    if (stat(path.c_str(), &found) != 0) {
        refuse_to_read(path, errno == ENOENT ? "it is a link to a missing file" : last_error());
    }
    if (!S_ISREG(found.st_mode)) {
        refuse_to_read(path, S_ISDIR(found.st_mode) ? "it is a folder" : "it is no regular file");
    }
    // The file is opened for writing if possible, because some file systems can lock only such a file.
    Descriptor file{open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK)};
    if (!file.is_open() && (errno == EACCES || errno == EROFS)) {
        file = Descriptor{open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
    }
    if (!file.is_open()) {
        refuse_to_read(path, last_error());
    }
    return file;
}

/// Returns whether the path still leads to this open file. Another process can have replaced the file after it was
/// opened.
bool is_at(const Descriptor& file, const fs::path& path) {
    struct stat opened {};
    struct stat named {};
    return fstat(file.number(), &opened) == 0 && stat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
           opened.st_dev == named.st_dev;
}

Image read_image(const Descriptor& file, const fs::path& path, std::size_t size) {
    struct stat found {};
    if (fstat(file.number(), &found) != 0) {
        refuse_to_read(path, last_error());
    }
    if (static_cast<std::size_t>(found.st_size) != size) {
        throw InputError{fmt::format(
            "{} has {} bytes and is no image of this device's memory ({} bytes); remove the file or name another",
            path.string(), found.st_size, size)};
    }
    Image image(size);
    std::size_t done = 0;
    while (done < size) {
        const ssize_t count = pread(file.number(), &image[done], size - done, static_cast<off_t>(done));
        if (count <= 0) {
            refuse_to_read(path, count == 0 ? "it became shorter while it was read" : last_error());
        }
        done += static_cast<std::size_t>(count);
    }
    return image;
}

/// Stores a memory image in a file and keeps that file locked.
class StoredMemoryFile {
  public:
    StoredMemoryFile(fs::path path, Image& image, NoticeListener tell)
        : path_{std::move(path)}, tell_{std::move(tell)} {
        while (!(exists() ? take(image) : make(image))) {
            // Another process was faster: tries again.
        }
        path_ = fs::canonical(path_);
        remove_leftovers(path_);
    }

    bool keep(const Image& image) {
        try {
            FileBeside fresh{path_};
            fresh.write(text(image));
            fresh.replace();
            file_ = fresh.take();  // the file was locked before it got its name
            return true;
        } catch (const std::system_error& error) {
            tell(fmt::format("cannot write {}: {}; the device answers that it stored nothing", path_.string(),
                             error.code().message()));
            return false;
        }
    }

  private:
    /// Reports a failure to the user. If the report itself fails, only the answer of the device shows the failure.
    void tell(const std::string& text) const {
        try {
            tell_(text);
        } catch (const std::exception&) {
            return;
        }
    }

    bool exists() const {
        std::error_code error;
        const auto status = fs::symlink_status(path_, error);
        if (status.type() == fs::file_type::none) {
            refuse_to_read(path_, error.message());
        }
        return fs::exists(status);
    }

    bool take(Image& image) {
        Descriptor file = open_existing(path_);
        if (!lock(file)) {
            if (!is_at(file, path_)) {
                return false;
            }
            throw InputError{fmt::format("{} is in use by {}; end that process or name another file", path_.string(),
                                         lock_holder(file.number()))};
        }
        if (!is_at(file, path_)) {
            return false;
        }
        image = read_image(file, path_, image.size());
        file_ = std::move(file);
        return true;
    }

    bool lock(const Descriptor& file) const {
        try {
            return try_lock(file.number());
        } catch (const std::system_error& error) {
            throw InputError{fmt::format("cannot lock {}: {}; name a file on another file system", path_.string(),
                                         error.code().message())};
        }
    }

    bool make(const Image& image) {
        try {
            FileBeside fresh{path_};
            fresh.write(text(image));
            const bool first = fresh.create();
            file_ = first ? fresh.take() : Descriptor{};
            return first;
        } catch (const std::system_error& error) {
            throw InputError{
                fmt::format("cannot write {}: {}; name another file", path_.string(), error.code().message())};
        }
    }

    fs::path path_;
    NoticeListener tell_;
    Descriptor file_;
};

}  // namespace

void keep_in_file(Memory& memory, const fs::path& file, NoticeListener tell) {
    const auto stored = std::make_shared<StoredMemoryFile>(file, memory.bytes(), std::move(tell));
    memory.keep_by([stored](const Image& image) { return stored->keep(image); });
}

}  // namespace canproof::host
