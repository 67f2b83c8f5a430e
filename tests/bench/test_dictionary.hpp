// SPDX-License-Identifier: Apache-2.0
// The object dictionary for the transactions: the 1,100 entries of the AX130751, and entries that this device lacks.
// These are a DOMAIN of 64 KiB, a string of 64 bytes, and eight UNSIGNED16 values (5F02h) that PDOs may carry.
#pragma once

#include <cstddef>
#include <cstdint>

#include "host/register/register.hpp"

namespace canproof::bench {

constexpr std::uint16_t domain_index = 0x5F00;
constexpr std::size_t domain_size = 65536;

const host::Part& test_part();

}  // namespace canproof::bench
