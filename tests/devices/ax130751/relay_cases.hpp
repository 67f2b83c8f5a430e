// SPDX-License-Identifier: Apache-2.0
// Test fixture that sets up the relay of an AX130751 by SDO (manual, 1.4).
#pragma once

#include "tests/devices/ax130751/ax130751_blocks.hpp"

namespace canproof::test {

class Ax130751Relay : public Ax130751Blocks {
  protected:
    void SetUp() override {
        Ax130751Blocks::SetUp();
        for (int number = 1; number <= 3; ++number) {
            extra_as_percent(number);
        }
    }
    /// Connects an input of the relay to extra received value `number` (2500h).
    void connect(std::uint16_t source_index, int number) {
        set8(source_index, 1, canopen);
        set8(static_cast<std::uint16_t>(source_index + 1), 1, 3 + number);
        pass(1);
    }
    /// Sets 6220h:3 (DO Write State 1 Output Line), runs a cycle and returns the state of the relay.
    bool control(int state) {
        set8(0x6220, 3, state);
        pass(1);
        return relay_on();
    }
};

}  // namespace canproof::test
