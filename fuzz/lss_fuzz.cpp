// SPDX-License-Identifier: Apache-2.0
// Sends frames of an LSS master, of any bytes and lengths and at any times, to a node without a node-ID, and later with
// the node-ID that it was given. Input: records of ten bytes: the event, a length or time, and eight bytes of data.
#include <algorithm>
#include <memory>

#include "fuzz/support/claims.hpp"
#include "fuzz/support/frame_probe.hpp"
#include "fuzz/support/keep_deadlines.hpp"
#include "fuzz/support/replays_as.hpp"
#include "fuzz/support/require.hpp"
#include "fuzz/support/require_consistent.hpp"
#include "generated/canopen/requirements.hpp"
#include "host/register/load.hpp"
#include "host/register/register.hpp"
#include "host/register/spec_files.hpp"
#include "host/sim/devices/generic_device.hpp"
#include "host/sim/devices/memory.hpp"

namespace {

using namespace canproof;
using fuzz::require;

constexpr std::size_t record_size = 10;
constexpr std::uint32_t request_id = 0x7E5;
constexpr std::uint32_t response_id = 0x7E4;
constexpr std::array<std::uint32_t, 4> address{0x00000055, 0xAA020301, 0x00010002, 0x20261121};

/// Returns the description of a device (a part of a requirements register) that has an LSS address and nothing else.
const host::Part& part() {
    static const host::LoadResult loaded = [] {
        host::SpecFiles files;
        files["spec/manuals/s.toml"] =
            "key = \"S1\"\ntitle = \"t\"\npublisher = \"p\"\nrevision = \"1\"\ndate = \"2026-11-21\"\n"
            "[[section]]\nref = \"1\"\ntitle = \"t\"\ndisposition = \"normative\"\n";
        files["spec/devices/slave/device.toml"] =
            "name = \"slave\"\ntitle = \"t\"\nvendor = \"v\"\nprefix = \"AO4\"\nmanual = \"S1\"\npart_numbers = "
            "[\"n\"]\n"
            "node_id = 5\nbit_rate = 125000\nbit_rates = [125000]\nsource = [\"S1:1\"]\n[services]\nlss = true\n";
        files["spec/devices/slave/objects.toml"] = R"toml([[object]]
index = 0x1018
name = "Identity Object"
source = ["S1:1"]
  [[object.entry]]
  sub = 1
  name = "Vendor-ID"
  type = "UNSIGNED32"
  access = "ro"
  default = 0x00000055
  [[object.entry]]
  sub = 2
  name = "Product Code"
  type = "UNSIGNED32"
  access = "ro"
  default = 0xAA020301
  [[object.entry]]
  sub = 3
  name = "Revision Number"
  type = "UNSIGNED32"
  access = "ro"
  default = 0x00010002
  [[object.entry]]
  sub = 4
  name = "Serial Number"
  type = "UNSIGNED32"
  access = "ro"
  default = 0x20261121
)toml";
        return host::load_register(files);
    }();
    require(loaded.faults.empty());
    return *loaded.content.part("slave");
}

/// Tracks the LSS state of the slave from the frames on the bus. When the frames do not show whether the slave is in
/// the LSS state configuration, it counts as possibly in this state.
class Watch {
  public:
    void request(const Frame& frame, bool answered, Instant now) {
        const std::uint8_t specifier = frame.data[0];
        if (specifier == 0x51 && answered) {
            fastscan(frame);
        } else if (specifier == 0x15 && frame.length >= 3) {
            const Instant end = now + milliseconds(2U * read_u16(frame.payload(), 1));
            quiet_until_ = end > quiet_until_ ? end : quiet_until_;
        } else if (specifier == 0x04 && frame.length >= 2 && frame.data[1] == 1) {
            may_configure_ = true;
        } else if (specifier == 0x04 && frame.length >= 2 && frame.data[1] == 0) {
            may_configure_ =
                may_configure_ && now < quiet_until_;  // no frame is received while the bit rate is switched
        } else if (specifier == 0x43 && answered) {
            may_configure_ = true;
        }
    }
    void booted() { may_configure_ = false; }
    /// Returns whether the slave may be in the LSS state configuration: after a switch state service, or because
    /// Fastscan confirmed all four numbers of the LSS address.
    bool may_configure() const { return may_configure_; }

  private:
    void fastscan(const Frame& frame) {
        const std::uint8_t check = frame.data[5];
        const std::uint8_t which = frame.data[6];
        require(check <= 31 || check == 128);
        if (check == 128) {
            confirmed_ = 0;
            return;
        }
        require(which <= 3 && ((address[which] ^ read_u32(frame.payload(), 1)) >> check) == 0);
        confirmed_ |= check == 0 && frame.data[7] != which ? 1U << which : 0U;
        may_configure_ = may_configure_ || confirmed_ == 0xF;
    }
    unsigned confirmed_{0};
    bool may_configure_{false};
    Instant quiet_until_{};
};

bool is_answer_to(std::uint8_t asked, std::uint8_t answer) {
    switch (asked) {
        case 0x43:
            return answer == 0x44;
        case 0x4B:
        case 0x51:
            return answer == 0x4F;
        case 0x4C:
            return answer == 0x50;
        default:
            return answer == asked;
    }
}

bool needs_configuration(std::uint8_t specifier) {
    return specifier == 0x11 || specifier == 0x13 || specifier == 0x17 || (specifier >= 0x5A && specifier <= 0x5E);
}

/// Checks that the slave sends at most one LSS answer, which fits the request, and no other frames except boot-up
/// messages.
void check_answers(TransmitQueue& queue, const Frame& request, Watch& watch, Instant now) {
    bool answered = false;
    bool booted = false;
    while (!queue.empty()) {
        const Frame frame = queue.pop();
        require(!frame.extended && !frame.remote && frame.length >= 1 && frame.length <= 8);
        if (frame.id == response_id) {
            require(!answered && request.id == request_id && request.length >= 1);
            require((frame.length == 8) == (request.length == 8));
            require(is_answer_to(request.data[0], frame.data[0]));
            require(!needs_configuration(request.data[0]) || watch.may_configure());
            answered = true;
        } else {
            require(frame.id > 0x700 && frame.id <= 0x77F && frame.length == 1 && frame.data[0] == 0);
            booted = true;
        }
    }
    if (request.id == request_id) {
        watch.request(request, answered, now);
    }
    if (booted) {
        watch.booted();
    }
}

}  // namespace

CANPROOF_FUZZ_REPLAYS_AS_PART(part(), "--node 255")
CANPROOF_FUZZ_CLAIMS(req::CO_LSS_052, req::CO_LSS_054, req::CO_LSS_063, req::CO_LSS_085)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static host::Memory memory{64};
    static TransmitQueue queue;
    // one device for all inputs, because making it takes longer than running an input
    static host::GenericDevice device{part(), memory, queue};
    fuzz::begin_checks(data, size);
    const auto check = [] { fuzz::require_consistent(device); };
    queue = TransmitQueue{};
    std::fill(memory.bytes().begin(), memory.bytes().end(), std::uint8_t{0xFF});
    Instant now = fuzz::begin_input();
    Watch watch;
    device.power_on(LssConfiguration{255, 125000}, now);
    require(queue.empty());
    for (; size >= record_size; data += record_size, size -= record_size) {
        const std::uint8_t what = data[0] & 0x0FU;
        if (what == 0x0F) {  // time passes
            const Instant end = now + milliseconds(data[1]);
            fuzz::keep_deadlines(device, now, end, check);
            require(queue.empty());
            continue;
        }
        const bool is_nmt = what == 0x0E;
        const auto length = static_cast<std::uint8_t>(is_nmt ? 2 : std::min(data[1] & 0x0F, 8));
        Frame frame = data_frame(is_nmt ? 0U : request_id, length);
        std::copy_n(data + 2, length, frame.data.begin());
        fuzz::deliver(device, frame, now);
        check();
        check_answers(queue, frame, watch, now);
    }
    // Ends a change of the bit rate, because the next input switches the same device on.
    while (device.next_deadline() != never) {
        fuzz::keep_deadlines(device, now, device.next_deadline(), check);
    }
    return 0;
}
