// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/selftest/failure_record.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

namespace {

/// The upper three bytes of a valid record; the lowest byte is the number of the SelfTest.
constexpr std::uint32_t mark = 0x5E1F7E00U;

}  // namespace

static_assert(implements<req::CO_SELF_009> && implements<req::CO_D_SELF_001>);
void FailureRecord::keep(const SelfTest test) noexcept {
    const std::uint32_t code = mark | static_cast<std::uint32_t>(test);
    words_.code.write(code);
    words_.complement.write(~code);
}

static_assert(implements<req::CO_SELF_009>);
SelfTest FailureRecord::take() noexcept {
    constexpr std::array<SelfTest, 8U> all{SelfTest::core,  SelfTest::stack,   SelfTest::clock, SelfTest::ram,
                                           SelfTest::flash, SelfTest::outputs, SelfTest::flow,  SelfTest::state};
    const std::uint32_t code = words_.code.read();
    SelfTest found{SelfTest::none};
    if (words_.complement.read() == ~code) {
        for (const SelfTest test : all) {
            found = (code == (mark | static_cast<std::uint32_t>(test))) ? test : found;
        }
    }
    words_.code.write(0U);  // clears the record: the complement no longer matches
    return found;
}

}  // namespace canproof::stm32f405
