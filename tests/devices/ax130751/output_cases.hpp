// SPDX-License-Identifier: Apache-2.0
// Test fixture that sets up an output of a given type, for the tests of the universal outputs (AX130751 manual, 1.2,
// 1.3).
#pragma once

#include "tests/devices/ax130751/ax130751_blocks.hpp"

namespace canproof::test {

class Ax130751Output : public Ax130751Blocks {
  protected:
    /// Gives output 1 the type `type`, without ramps. If the command is outside the scaling, the output has the value
    /// of the nearer end (2342h, AO Control Response, is 0).
    void make(int type) {
        set16(0x6310, 1, type);
        no_ramps(1);
        set8(0x2342, 1, 0);
        pass(1);
    }
    /// Connects the enable or override input of output 1 to number 3 + `number` of the CANopen messages (Table 4B),
    /// scaled so that 0 is OFF and 100 is ON.
    void connect(std::uint16_t source_index, int number) {
        extra_as_percent(number);
        set8(source_index, 1, canopen);
        set8(static_cast<std::uint16_t>(source_index + 1), 1, 3 + number);
        pass(1);
    }
};

}  // namespace canproof::test
