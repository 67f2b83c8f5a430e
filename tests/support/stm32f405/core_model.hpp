// SPDX-License-Identifier: Apache-2.0
// The core as the self-tests see it, in place of src/target/image/core.cpp.
#pragma once

#include <cstdint>

namespace canproof::test {

struct CoreModel {
    bool registers_hold{true};
    bool masked{false};              ///< interrupts are masked
    std::uint32_t marches{0};        ///< number of slices of RAM that were tested on the other stack
    const void* stack_end{nullptr};  ///< end of the other stack in the last of these tests
};

/// Returns the model of the core. A test that alters it must set it back to CoreModel{}.
CoreModel& core_model();

}  // namespace canproof::test
