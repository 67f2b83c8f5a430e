// SPDX-License-Identifier: Apache-2.0
#include "host/base/file_lock.hpp"

#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

namespace canproof::host {

namespace {

std::string process(const std::string& number) {
    std::ifstream in{"/proc/" + number + "/comm"};
    std::string name;
    std::getline(in, name);
    return "process " + number + (name.empty() ? "" : " (" + name + ")");
}

}  // namespace

bool try_lock(int descriptor) {
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
        return true;
    }
    if (errno != EWOULDBLOCK) {
        throw std::system_error{errno, std::generic_category(), "cannot lock"};
    }
    return false;
}

bool wait_for_lock(int descriptor) {
    int status = 0;
    do {
        status = flock(descriptor, LOCK_EX);
    } while (status != 0 && errno == EINTR);
    return status == 0;
}

/// Searches /proc/locks for the inode of the file. In the line `1: FLOCK ADVISORY WRITE 4711 fe:00:131073 0 EOF`,
/// 131073 is the inode, and 4711 is the process that has locked the file.
std::string lock_holder(int descriptor) {
    struct stat file {};
    const std::string ending = fstat(descriptor, &file) == 0 ? ":" + std::to_string(file.st_ino) : ":?";
    std::ifstream in{"/proc/locks"};
    std::string line;
    while (std::getline(in, line)) {
        std::istringstream words{line};
        std::string number;
        std::string kind;
        std::string force;
        std::string mode;
        std::string holder;
        std::string place;
        words >> number >> kind >> force >> mode >> holder >> place;
        const bool is_it = kind == "FLOCK" && place.size() > ending.size() &&
                           place.compare(place.size() - ending.size(), ending.size(), ending) == 0;
        // 0 or -1: the system does not report the process, for example because it is in another namespace
        if (is_it && holder != "0" && holder != "-1") {
            return process(holder);
        }
    }
    return "another process";
}

}  // namespace canproof::host
