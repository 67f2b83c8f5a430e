// SPDX-License-Identifier: Apache-2.0
#include "host/base/replace_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "host/base/write_all.hpp"

namespace canproof::host {

namespace {

namespace fs = std::filesystem;

constexpr const char* ending = ".new";
constexpr mode_t everybody = 0666;  // the process umask reduces these permissions
constexpr mode_t permissions = 07777;

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path{"."};
}

std::string beginning(const fs::path& target) {
    return "." + target.filename().string() + ".";
}

/// Writes to a device file, such as /dev/null, or to a FIFO. Neither has content that could be kept.
void write_into(const fs::path& path, std::string_view bytes) {
    const Descriptor file{open(path.c_str(), O_WRONLY | O_CLOEXEC)};
    if (!file.is_open() || !write_all(file.number(), bytes)) {
        refuse_to_write(path);
    }
}

}  // namespace

void refuse_to_write(const fs::path& path) {
    throw fs::filesystem_error{"cannot write", path, std::error_code{errno, std::generic_category()}};
}

FileBeside::FileBeside(fs::path target) : target_{std::move(target)} {
    int number = 0;
    do {
        beside_ = folder_of(target_) /
                  (beginning(target_) + std::to_string(getpid()) + "-" + std::to_string(number) + ending);
        file_ = Descriptor{open(beside_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, everybody)};
        ++number;
    } while (!file_.is_open() && errno == EEXIST);
    if (!file_.is_open()) {
        fail();
    }
    struct stat old {};
    const bool known = stat(target_.c_str(), &old) == 0;
    const bool may = !known || access(target_.c_str(), W_OK) == 0;
    if (!may || flock(file_.number(), LOCK_EX | LOCK_NB) != 0 ||
        (known && fchmod(file_.number(), old.st_mode & permissions) != 0)) {
        const int error = errno;
        unlink(beside_.c_str());
        errno = error;
        fail();
    }
}

FileBeside::~FileBeside() {
    if (!placed_) {
        unlink(beside_.c_str());
    }
}

void FileBeside::fail() const {
    refuse_to_write(target_);
}

void FileBeside::write(std::string_view bytes) {
    if (!write_all(file_.number(), bytes) || fsync(file_.number()) != 0) {
        fail();
    }
}

void FileBeside::sync_folder() const {
    const Descriptor folder{open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    // EINVAL means that the file system does not support fsync for folders.
    if (!folder.is_open() || (fsync(folder.number()) != 0 && errno != EINVAL)) {
        fail();
    }
}

void FileBeside::replace() {
    if (rename(beside_.c_str(), target_.c_str()) != 0) {
        fail();
    }
    placed_ = true;
    sync_folder();
}

bool FileBeside::create() {
    const bool linked = link(beside_.c_str(), target_.c_str()) == 0;
    // EPERM means that the file system has no hard links.
    const bool moved = !linked && errno == EPERM &&
                       renameat2(AT_FDCWD, beside_.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE) == 0;
    if (!linked && !moved) {
        // EEXIST: the target exists. ENOENT: another process was faster and has removed the temporary file
        if (errno == EEXIST || errno == ENOENT) {
            return false;
        }
        fail();
    }
    placed_ = moved;
    sync_folder();
    return true;
}

void remove_leftovers(const fs::path& target) {
    const std::string begins = beginning(target);
    std::error_code ignored;  // a temporary file that stays does no harm
    for (const auto& entry : fs::directory_iterator{folder_of(target), ignored}) {
        const std::string name = entry.path().filename().string();
        const bool is_ours = name.size() > begins.size() + std::string_view{ending}.size() &&
                             name.compare(0, begins.size(), begins) == 0 && entry.path().extension() == ending;
        const std::string number = is_ours ? name.substr(begins.size(), name.size() - begins.size() - 4) : "x";
        if (number.find_first_not_of("0123456789-") == std::string::npos) {
            fs::remove(entry.path(), ignored);
        }
    }
}

void replace_file(const fs::path& path, std::string_view bytes) {
    const auto status = fs::status(path);
    const bool is_link = fs::is_symlink(fs::symlink_status(path));
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        write_into(path, bytes);
        return;
    }
    FileBeside fresh{is_link ? fs::canonical(path) : path};
    fresh.write(bytes);
    fresh.replace();
}

}  // namespace canproof::host
