// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/selftest/stack_guard.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

void StackGuard::start() noexcept {
    for (Register& word : words_) {
        word.write(pattern);
    }
}

static_assert(implements<req::CO_SELF_004>);
bool StackGuard::is_intact() const noexcept {
    bool intact{true};
    for (const Register& word : words_) {
        intact = (word.read() == pattern) && intact;
    }
    return intact;
}

}  // namespace canproof::stm32f405
