// SPDX-License-Identifier: Apache-2.0
#include "host/base/replace_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <system_error>

#include "host/base/descriptor.hpp"
#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "host/base/replace_file.hpp"

namespace canproof::host {

namespace {

namespace fs = std::filesystem;

void write_plainly(const fs::path& path, const std::string& bytes) {
    fs::create_directories(path.parent_path());
    std::ofstream out{path, std::ios::binary};
    out << bytes;
    out.close();
    if (!out) {
        refuse_to_write(path);
    }
}

void sync_all(const fs::path& folder) {
    const Descriptor file{open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    if (!file.is_open() || syncfs(file.number()) != 0) {
        refuse_to_write(folder);
    }
}

/// Returns the temporary name that the old folder has during an exchange in three steps.
fs::path old_of(const fs::path& fresh) {
    return fresh.string() + ".old";
}

/// Exchanges the two folders in one step, or in three steps if the file system cannot exchange them in one.
void exchange(const fs::path& fresh, const fs::path& folder) {
    if (renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, folder.c_str(), RENAME_EXCHANGE) == 0) {
        return;
    }
    if (errno != EINVAL && errno != ENOSYS) {
        refuse_to_write(folder);
    }
    const fs::path old = old_of(fresh);
    fs::rename(folder, old);
    fs::rename(fresh, folder);
    fs::rename(old, fresh);
}

/// Restores the folder that an earlier call had moved to `old` when its program stopped between the steps of
/// exchange().
void restore(const fs::path& old, const fs::path& folder) {
    if (fs::exists(old) && !fs::exists(folder)) {
        fs::rename(old, folder);
    }
    fs::remove_all(old);
}

}  // namespace

void replace_folder(const fs::path& folder, const std::map<std::string, std::string>& files) {
    check_folder_place(folder);
    const fs::path named = fs::weakly_canonical(fs::absolute(folder));
    const fs::path target = named.has_filename() ? named : named.parent_path();
    const fs::path fresh = target.parent_path() / ("." + target.filename().string() + ".new");
    restore(old_of(fresh), target);
    fs::remove_all(fresh);
    fs::create_directories(fresh);
    try {
        for (const auto& [name, bytes] : files) {
            write_plainly(fresh / name, bytes);
        }
        sync_all(fresh);
        if (fs::exists(target)) {
            exchange(fresh, target);
        } else {
            fs::rename(fresh, target);
        }
        sync_all(target.parent_path());
    } catch (const std::exception&) {
        std::error_code ignored;
        fs::remove_all(fresh, ignored);
        throw;
    }
    fs::remove_all(fresh);
}

void check_replaceable(const fs::path& folder) {
    check_folder_place(folder);
    const fs::path named = fs::weakly_canonical(fs::absolute(folder));
    fs::path place = (named.has_filename() ? named : named.parent_path()).parent_path();
    while (!fs::exists(place) && place != place.parent_path()) {
        place = place.parent_path();
    }
    std::string trial = place / ".canproof-XXXXXX";
    if (mkdtemp(trial.data()) == nullptr || rmdir(trial.c_str()) != 0) {
        throw InputError{
            fmt::format("cannot write {}: {}; name another folder", folder.string(), std::strerror(errno))};
    }
}

}  // namespace canproof::host
