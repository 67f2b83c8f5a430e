// SPDX-License-Identifier: Apache-2.0
// Mixes NMT commands, heartbeat, heartbeat consumer and node guarding in any order and at any times. Compares the
// frames on 705h, their times and the NMT state with a naive model. Input: records of four bytes, an event with its
// numbers; the highest bit of the first byte adds a frame of wrong length or format before the event.
#include <algorithm>

#include "fuzz/support/claims.hpp"
#include "fuzz/support/frame_probe.hpp"
#include "fuzz/support/keep_deadlines.hpp"
#include "fuzz/support/record_mutator.hpp"
#include "fuzz/support/replays_as.hpp"
#include "fuzz/support/require.hpp"
#include "fuzz/support/require_consistent.hpp"
#include "generated/canopen/requirements.hpp"
#include "host/sim/devices/generic_device.hpp"
#include "host/sim/devices/memory.hpp"
#include "properties/support/naive_error_control.hpp"
#include "tests/support/slave_register.hpp"

namespace {

using namespace canproof;
using fuzz::require;
namespace naive = naive_error_control;

constexpr std::size_t record_size = 4;
constexpr std::size_t most_records = 200;

class Both {
  public:
    /// Restarts the slave and the model.
    void restart() {
        now_ = start_ = fuzz::begin_input();
        said_.clear();
        model_ = naive::Node{};
        device_.power_on(naive::node_id, now_);
        compare();
    }

    void happen(const std::uint8_t* record) {
        const naive::Event event{(record[0] & 0x7FU) % naive::event_kinds, record[1], record[2] + 256U * record[3]};
        if ((record[0] & 0x80U) != 0) {
            meaningless(event);
        }
        naive::apply(model_, event);
        const naive::EventFrame asked = naive::frame_of(event);
        if (naive::pause_of(event) != 0 || event.kind == 8) {
            pass(naive::pause_of(event));
        } else {
            Frame frame = data_frame(asked.id, static_cast<std::uint8_t>(asked.data.size()));
            std::copy(asked.data.begin(), asked.data.end(), frame.data.begin());
            frame.remote = asked.remote;
            fuzz::deliver(device_, frame, now_);
            drain();
        }
        compare();
    }

  private:
    /// Sends an NMT command or a heartbeat with a wrong length or a 29-bit identifier, which has no effect.
    void meaningless(const naive::Event& event) {
        Frame frame = data_frame(event.kind % 2U == 0 ? 0U : 0x701U, static_cast<std::uint8_t>(event.b % 9U));
        frame.data = {static_cast<std::uint8_t>(naive::command_of(event)), naive::node_id};
        frame.extended = frame.length == (frame.id == 0 ? 2U : 1U);
        fuzz::deliver(device_, frame, now_);
        drain();
    }
    void pass(std::uint64_t ms) {
        fuzz::keep_deadlines(device_, now_, now_ + milliseconds(ms), [this] { drain(); });
    }
    /// Checks the invariants of the services, and the format and the identifier of each frame that was sent. Does not
    /// check whether the NMT state allows the frame, because an event may change the state.
    void drain() {
        fuzz::require_consistent(device_);
        while (!queue_.empty()) {
            const Frame frame = queue_.pop();
            require(!frame.extended && !frame.remote && frame.length <= max_frame_length, "a frame");
            if (frame.id == 0x705) {
                require(frame.length == 1, "error control has one byte");
                said_.emplace_back(elapsed(start_, now_).us / 1000U, frame.data[0]);
            } else {
                const bool pdo = (frame.id & 0x7FU) == naive::node_id && frame.id >= 0x185 && frame.id <= 0x485;
                require(frame.id == 0x085 || frame.id == 0x585 || pdo, "an identifier of the node", frame.id);
            }
        }
    }
    void compare() {
        drain();
        require(model_.take_said() == std::exchange(said_, {}), "what is said on 705h");
        require(static_cast<unsigned>(device_.node().state()) == model_.state(), "state", model_.state());
        const bool listed = (device_.objects().read(0x1001, 0) & 0x10U) != 0;
        require(listed == model_.has_failed(), "communication error");
    }

    host::Memory memory_{4096};
    TransmitQueue queue_;
    host::GenericDevice device_{test::slave_part(), memory_, queue_};
    naive::Node model_;
    naive::Said said_;
    Instant start_{};
    Instant now_{};
};

}  // namespace

CANPROOF_FUZZ_REPLAYS_AS_PART(test::slave_part(), "--node 5")
CANPROOF_FUZZ_RECORDS(record_size)
CANPROOF_FUZZ_CLAIMS(req::CO_NMT_001, req::CO_NMT_002, req::CO_NMT_003, req::CO_NMT_009, req::CO_HB_001, req::CO_HB_002,
                     req::CO_HB_004, req::CO_GUARD_001, req::CO_GUARD_002, req::CO_GUARD_007)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Both both;  // the slave is made once, because making it takes longer than running an input
    fuzz::begin_checks(data, size);
    both.restart();
    const std::size_t count = std::min(size / record_size, most_records);
    for (std::size_t i = 0; i < count; ++i) {
        both.happen(data + i * record_size);
    }
    return 0;
}
