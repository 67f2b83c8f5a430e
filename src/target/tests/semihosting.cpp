// SPDX-License-Identifier: Apache-2.0
#include "semihosting.hpp"

#include <sys/stat.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "target/semihost.hpp"

extern "C" {
void initialise_monitor_handles();
void fault();
}

namespace canproof::target {

namespace {

constexpr int sys_get_cmdline = 0x15;

/// Ends the image when the heap is used up. Newlib's abort() would end it with 1, the status of a failed test, and
/// without a message.
[[noreturn]] void heap_is_used_up() {
    std::fputs("the heap is used up\n", stderr);
    std::_Exit(71);
}

}  // namespace

std::vector<std::string> begin_image() {
    initialise_monitor_handles();
    std::set_new_handler(heap_is_used_up);
    static std::array<char, 1024> text{};
    struct {
        char* text;
        std::size_t size;
    } block{text.data(), text.size()};
    semihost(sys_get_cmdline, &block);
    std::vector<std::string> all;
    std::string word;
    for (const char c : std::string{text.data()} + ' ') {
        if (c != ' ') {
            word += c;
        } else if (!word.empty()) {
            all.push_back(word);
            word.clear();
        }
    }
    return all;
}

std::string take_option(std::vector<std::string>& words, const std::string& name) {
    const std::string begin = "--" + name + "=";
    for (auto word = words.begin(); word != words.end(); ++word) {
        if (word->rfind(begin, 0) == 0) {
            std::string value = word->substr(begin.size());
            words.erase(word);
            return value;
        }
    }
    return {};
}

}  // namespace canproof::target

/// Handles any exception of the processor: the image ends with 70, the status of an internal software error.
void fault() {
    std::fputs("fault\n", stderr);
    std::exit(70);
}

// Definitions that the start-up code of a hosted program would provide (nothing is destroyed at the end of an image),
// and answers to GoogleTest's questions about folders (they exist).
extern "C" {
void* __dso_handle = nullptr;
void _fini() {}
int stat(const char*, struct stat* found) {
    *found = {};
    found->st_mode = S_IFDIR;
    return 0;
}
int mkdir(const char*, mode_t) {
    return 0;
}
char* getcwd(char* buffer, std::size_t size) {
    std::snprintf(buffer, size, ".");
    return buffer;
}
}
