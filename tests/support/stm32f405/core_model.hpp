// SPDX-License-Identifier: Apache-2.0
// A model of the processor core for the self-tests, in place of src/target/image/core.cpp.
#pragma once

#include <cstdint>

namespace canproof::test {

struct CoreModel {
    bool registers_hold{true};
    bool masked{false};              ///< interrupts are masked
    std::uint32_t marches{0};        ///< how often a part of the RAM was tested while the core used a second stack
    const void* stack_end{nullptr};  ///< end of the second stack in the last test that used it
};

/// Returns the model of the core. A test that changes the model must set it back to CoreModel{} at its end.
CoreModel& core_model();

}  // namespace canproof::test
