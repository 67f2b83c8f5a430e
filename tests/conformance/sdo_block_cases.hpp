// SPDX-License-Identifier: Apache-2.0
// The fixture for tests of SDO block transfer (CiA 301, 7.2.4.3.8 to 7.2.4.3.16): the conformance slave, node 5. Its
// DOMAIN of 64 KiB is 2400h. The CRC of "123456789" is 31C3h.
#pragma once

#include "tests/support/exchange.hpp"
#include "tests/support/sdo_text.hpp"
#include "tests/support/slave_bench.hpp"

namespace canproof::test {

inline const Bytes nine{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
inline const std::string stray = "585#8000000001000405";  // abort 05040001h (invalid command), which names no object

class SdoBlock : public testing::Test, public SlaveBench {
  protected:
    Bytes held() const {
        const ByteView view = device->held(program_index, 0);
        return {view.data(), view.data() + view.size()};
    }
    void hold(const Bytes& bytes) { device->fill(program_index, 0, bytes); }

    /// Returns the segments of an upload without losses: the first eight at once, the rest when the queue has room.
    Frames all_segments(const std::string& request) {
        Frames frames = send(request);
        for (const auto& later : pass(0)) {
            frames.push_back(later.substr(2));  // removes the time "0:"
        }
        return frames;
    }
};

}  // namespace canproof::test
