// SPDX-License-Identifier: Apache-2.0
#include "host/conform/steps/abort_list.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/conform/link/sdo_client.hpp"
#include "host/conform/link/verdict.hpp"

namespace canproof::host::conform {

AbortList AbortList::parse(Scanner& line) {
    AbortList list;
    if (line.take_word("any")) {
        return list;
    }
    do {
        const std::string word = line.word();
        if (word.size() != 8 || word.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) {
            line.fail(fmt::format("`{}` is no abort code", word), "write eight hexadecimal digits, or `any`");
        }
        list.codes_.push_back(static_cast<std::uint32_t>(std::stoul(word, nullptr, 16)));
    } while (line.take("|"));
    return list;
}

void AbortList::want(std::uint32_t code) const {
    if (!codes_.empty() && std::find(codes_.begin(), codes_.end(), code) == codes_.end()) {
        std::string wanted;
        for (const std::uint32_t one : codes_) {
            wanted += fmt::format("{}{:08X}h", wanted.empty() ? "" : " or ", one);
        }
        throw SlaveFailed{fmt::format("the transfer ended with {} instead of {}", abort_words(code), wanted)};
    }
}

}  // namespace canproof::host::conform
