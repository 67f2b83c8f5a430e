// SPDX-License-Identifier: Apache-2.0
// Lets errors start and end in any order, with commands, bus-off, inhibit times and writes between them. Compares the
// messages, the error register and the list of the last four errors with a naive model. Input: records of two bytes, an
// event and its number.
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
#include "properties/support/naive_emcy.hpp"
#include "tests/support/slave_register.hpp"

namespace {

using namespace canproof;
using fuzz::require;
namespace naive = naive_emcy;

constexpr std::size_t record_size = 2;
constexpr std::size_t most_records = 200;

class Both {
  public:
    /// Restarts the slave and the model.
    void restart() {
        now_ = start_ = fuzz::begin_input();
        device_.node().set_can_state(CanState::error_active, now_);
        device_.node().set_overrun(false, now_);
        device_.power_on(5, now_);
        drain();
        sent_.clear();
        model_ = naive::Node{};
    }

    void happen(const naive::Event& event) {
        naive::apply(model_, event);
        const naive::EventFrame asked = naive::frame_of(event);
        Node& node = device_.node();
        if (asked.is_one) {
            Frame frame = data_frame(asked.id, static_cast<std::uint8_t>(asked.data.size()));
            std::copy(asked.data.begin(), asked.data.end(), frame.data.begin());
            fuzz::deliver(device_, frame, now_);
        } else if (event.kind == 6) {
            node.set_can_state(static_cast<CanState>(event.a % 4U), now_);
        } else if (event.kind == 7) {
            node.set_overrun(event.a % 2U != 0, now_);
        } else if (event.kind == 8) {
            node.set_error(ErrorId::internal_software, event.a % 2U != 0, now_);
        }
        drain();
        pass(event.kind == 9 ? event.a : 0);
        compare();
    }

  private:
    void pass(std::uint64_t ms) {
        fuzz::keep_deadlines(device_, now_, now_ + milliseconds(ms), [this] { drain(); });
    }
    void drain() {
        fuzz::require_consistent(device_);
        while (!queue_.empty()) {
            const Frame frame = queue_.pop();
            if (frame.id == 0x085) {
                require(frame.length == 8, "an emergency message has eight bytes");
                sent_.emplace_back(elapsed(start_, now_).us / 1000U, frame.data);
            }
        }
    }
    void compare() {
        const ObjectDictionary& objects = device_.objects();
        require(model_.take_sent() == std::exchange(sent_, {}), "messages");
        require(objects.read(0x1001, 0) == model_.error_register(), "1001h", model_.error_register());
        const auto& list = model_.list();
        require(objects.read(0x1003, 0) == list.size(), "1003h:0", list.size());
        for (unsigned i = 0; i < 4; ++i) {
            const unsigned code = i < list.size() ? list[i] : 0U;
            require(objects.read(0x1003, static_cast<std::uint8_t>(i + 1)) == code, "1003h", code);
        }
    }

    host::Memory memory_{4096};
    TransmitQueue queue_;
    host::GenericDevice device_{test::slave_part(), memory_, queue_};
    naive::Node model_;
    naive::Sent sent_;
    Instant start_{};
    Instant now_{};
};

}  // namespace

CANPROOF_FUZZ_REPLAYS_AS_PART(test::slave_part(), "--node 5")
CANPROOF_FUZZ_RECORDS(record_size)
CANPROOF_FUZZ_CLAIMS(req::CO_EMCY_001, req::CO_EMCY_002, req::CO_EMCY_003, req::CO_EMCY_004, req::CO_EMCY_008,
                     req::CO_EMCY_023, req::CO_EMCY_033)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Both both;  // made once for all inputs, because making the slave takes longer than running an input
    fuzz::begin_checks(data, size);
    both.restart();
    const std::size_t count = std::min(size / record_size, most_records);
    for (std::size_t i = 0; i < count; ++i, data += record_size) {
        both.happen({data[0] % naive::event_kinds, data[1]});
    }
    return 0;
}
