// SPDX-License-Identifier: Apache-2.0
#include "host/base/fixed_addresses.hpp"

#include <sys/personality.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace canproof::host {

void fix_addresses() noexcept {
    const int now = personality(0xFFFF'FFFFU);  // asks and changes nothing
    if (now < 0 || (now & ADDR_NO_RANDOMIZE) != 0) {
        return;
    }
    if (personality(static_cast<unsigned>(now) | ADDR_NO_RANDOMIZE) < 0) {
        return;
    }
    std::ifstream file{"/proc/self/cmdline", std::ios::binary};
    std::string text{std::istreambuf_iterator<char>{file}, {}};
    std::vector<char*> words;
    for (std::size_t begin = 0; begin < text.size(); begin = text.find('\0', begin) + 1) {
        words.push_back(&text[begin]);
    }
    words.push_back(nullptr);
    if (words.size() > 1) {
        execv("/proc/self/exe", words.data());  // returns only when it fails
    }
    personality(static_cast<unsigned>(now));
}

}  // namespace canproof::host
