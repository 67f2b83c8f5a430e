// SPDX-License-Identifier: Apache-2.0
// A template of the self-tests that only tests and images instantiate. It is instantiated here, so that the program of
// mutants contains it together with its mutants.
#include "target/stm32f405/selftest/output_copy.hpp"

namespace canproof::stm32f405 {

template class OutputCopy<std::array<std::uint8_t, 3U>>;

}  // namespace canproof::stm32f405
