// SPDX-License-Identifier: Apache-2.0
#include "host/base/fixed_addresses.hpp"

#include <sys/personality.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <vector>

namespace canproof::host {

void fix_addresses() {
    const int now = personality(0xFFFF'FFFFU);  // this argument only reads the current setting
    if (now < 0 || (now & ADDR_NO_RANDOMIZE) != 0) {
        return;
    }
    if (personality(static_cast<unsigned>(now) | ADDR_NO_RANDOMIZE) < 0) {
        return;
    }
    std::ifstream file{"/proc/self/cmdline", std::ios::binary};
    std::vector<std::string> words;
    for (std::string word; std::getline(file, word, '\0');) {
        words.push_back(word);
    }
    std::vector<char*> pointers;
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    if (!words.empty() && !file.bad()) {
        execv("/proc/self/exe", pointers.data());  // returns only when it fails
    }
    personality(static_cast<unsigned>(now));
}

}  // namespace canproof::host
