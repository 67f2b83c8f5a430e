// SPDX-License-Identifier: Apache-2.0
#include "host/register/service_words.hpp"

namespace canproof::host {

const std::vector<std::string>& service_words() {
    static const std::vector<std::string> words{"none", "sync",  "emcy", "heartbeat",       "guarding",
                                                "pdo",  "store", "nmt",  "error_behaviour", "program",
                                                "lss",  "device"};
    return words;
}

}  // namespace canproof::host
