// SPDX-License-Identifier: Apache-2.0
// Theorems on LSS, for any frame of a master, any NMT state and any state of the slave. They cover devices with and
// without LSS.
#include "firmware/canopen/lss.hpp"

#include "generated/ax188001/objects.hpp"
#include "generated/ax188001/profile.hpp"
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/node.hpp"

namespace canproof::proofs {

namespace {

namespace device = generated::ax188001;

/// A device that either stores the settings or refuses to. The prover considers both answers. The harness fixes the
/// answer before the call of the firmware.
class AnyApplication final : public LssApplication {
  public:
    explicit AnyApplication(const LssError answer) : answer_{answer} {}
    void set_bit_rate(const std::uint32_t bit_rate, const Instant /*now*/) override { bit_rate_ = bit_rate; }
    LssError store_configuration(const LssConfiguration& configuration) override {
        stored_ = configuration.node_id;
        ++stores_;
        return answer_;
    }

    LssError answer_;
    std::uint32_t bit_rate_{0U};
    std::uint32_t stores_{0U};
    std::uint8_t stored_{0U};
};

struct Slave {
    std::array<std::uint8_t, device::image_size> image{any<std::array<std::uint8_t, device::image_size>>()};
    ObjectDictionary objects{device::tables, MutableBytes{image}, LimitAbort::range};
    TransmitQueue queue{};
    AnyApplication application{any<LssError>()};
    LssProfile profile{device::lss_rates, any<bool>()};
    Lss lss{profile, objects, queue, application};

    Slave() {
        leave_open(lss);
        lss.profile_ = profile;
        assume(lss.is_consistent());
    }
};

/// Returns any frame. The prover proves the theorem for each value of byte 0 (the LSS command) separately.
Frame any_request() {
    Frame frame = any_frame();
    frame.data[0] = each(256U);
    return frame;
}

}  // namespace

void lss_begins_consistent() {
    shows("a new slave that is powered on waits, has nothing due, and is consistent for each node-ID that LSS gives");
    proves<req::CO_LSS_004>();
    Slave slave{};
    Lss fresh{slave.profile, slave.objects, slave.queue, slave.application};
    const LssConfiguration stored{any<std::uint8_t>(), any<std::uint32_t>(), any<bool>()};
    assume(is_lss_node_id(stored.node_id));
    fresh.power_on(stored);
    fresh.restore(any_time());
    claim(fresh.take_node_id() == stored.node_id);
    claim(fresh.is_consistent() && (fresh.state_ == LssState::waiting) && (fresh.next_deadline() == never));
}

void lss_takes_its_frames_alone() {
    shows("a frame is an LSS request exactly when it is a base data frame on 7E5h and the device has LSS");
    proves<req::CO_LSS_062, req::CO_LSS_064, req::CO_FRAME_001>();
    Slave slave{};
    const Frame frame = any_frame();
    const bool own = (frame.id == 0x7E5U) && !frame.extended && !frame.remote;
    claim(slave.lss.is_request(frame) == own);
    slave.lss.profile_ = LssProfile{};
    claim(!slave.lss.is_request(frame));
}

void lss_answers_each_request_at_most_once() {
    shows(
        "any request leaves LSS consistent and is answered at most once, on 7E4h, with eight bytes where it has eight");
    proves<req::CO_LSS_061, req::CO_LSS_063>();
    Slave slave{};
    const Frame frame = any_request();
    const auto nmt = any<NmtState>();
    static_cast<void>(slave.lss.receive(frame, nmt, any_time()));
    claim(slave.lss.is_consistent());
    claim(slave.queue.size() <= 1U);
    claim(slave.application.stores_ <= 1U);
    if (!slave.queue.empty()) {
        const Frame& answer = waiting(slave.queue, 0U);
        claim((answer.id == 0x7E4U) && !answer.extended && !answer.remote);
        claim((answer.length >= 1U) && (answer.length <= 8U) && ((frame.length != 8U) || (answer.length == 8U)));
    }
}

void an_empty_request_changes_nothing() {
    shows("a frame without a command specifier changes nothing in LSS and is not answered");
    proves<req::CO_LSS_060>();
    Slave slave{};
    const Frame frame = any_frame();
    assume(frame.length == 0U);
    const LssState state = slave.lss.state_;
    const std::uint8_t node_id = slave.lss.pending_.node_id;
    claim(!slave.lss.receive(frame, any<NmtState>(), any_time()));
    claim(slave.queue.empty() && (slave.application.stores_ == 0U));
    claim((slave.lss.state_ == state) && (slave.lss.pending_.node_id == node_id));
}

void lss_configures_in_its_state_alone() {
    shows(
        "node-ID and bit rate change, and are stored, in LSS configuration alone, and not while the node is "
        "operational");
    proves<req::CO_LSS_005, req::CO_LSS_070, req::CO_LSS_071, req::CO_LSS_013>();
    Slave slave{};
    const Frame frame = any_request();
    const auto nmt = any<NmtState>();
    const LssState state = slave.lss.state_;
    const LssConfiguration pending = slave.lss.pending_;
    const LssConfiguration active = slave.lss.active_;
    static_cast<void>(slave.lss.receive(frame, nmt, any_time()));
    const bool may = (state == LssState::configuration) && (nmt != NmtState::operational);
    const bool same =
        (slave.lss.pending_.node_id == pending.node_id) && (slave.lss.pending_.bit_rate == pending.bit_rate);
    claim(may || (same && (slave.application.stores_ == 0U)));
    claim(same || (frame.data[0] == 0x11U) || (frame.data[0] == 0x13U));
    claim((slave.application.stores_ == 0U) || (frame.data[0] == 0x17U));
    claim(slave.lss.active_.node_id == active.node_id);
    claim((slave.lss.active_.bit_rate == active.bit_rate) || (may && (frame.data[0] == 0x15U)));
}

void lss_is_selected_by_its_whole_address() {
    shows(
        "switch state selective counts its own numbers in their order alone, and only the fourth selects and is "
        "answered");
    proves<req::CO_LSS_002, req::CO_LSS_003>();
    Slave slave{};
    const Frame frame = any_frame();
    assume((frame.length == 8U) && (frame.data[0] >= 0x40U) && (frame.data[0] <= 0x43U));
    assume(slave.lss.state_ == LssState::waiting);
    const std::uint32_t number = frame.data[0] - 0x40U;
    const std::uint32_t own = slave.objects.read(0x1018U, static_cast<std::uint8_t>(number + 1U));
    const bool in_order = (number == 0U) || (number == slave.lss.selected_);
    const bool fits = in_order && (own == static_cast<std::uint32_t>(field_le<1U, 4U>(frame.data)));
    static_cast<void>(slave.lss.receive(frame, any<NmtState>(), any_time()));
    const bool is_selected = fits && (number == 3U);
    claim(slave.lss.selected_ == (fits ? (number + 1U) : 0U));
    claim((slave.lss.state_ == LssState::configuration) == is_selected);
    claim(slave.queue.size() == (is_selected ? 1U : 0U));
    claim(!is_selected || (waiting(slave.queue, 0U).data[0] == 0x44U));
}

void a_bit_rate_is_switched_in_time() {
    shows("advance() leaves LSS consistent and nothing due, and takes the pending bit rate at the switch");
    proves<req::CO_LSS_014, req::CO_LSS_015>();
    Slave slave{};
    const Instant now = any_time();
    assume(slave.lss.delay_.us <= 65535000U);
    const bool switches = (slave.lss.switching_ == Lss::Switching::before) && (slave.lss.due_ <= now);
    const std::uint32_t active = slave.lss.active_.bit_rate;
    slave.lss.advance(now);
    claim(slave.lss.is_consistent());
    claim(slave.lss.next_deadline() > now);
    claim(slave.lss.active_.bit_rate == (switches ? slave.lss.pending_.bit_rate : active));
    claim(slave.queue.empty());
}

void a_reset_ends_each_sequence() {
    shows("take_node_id() goes to LSS waiting, ends each sequence and activates the pending node-ID");
    proves<req::CO_LSS_004, req::CO_LSS_086, req::CO_LSS_011>();
    Slave slave{};
    const std::uint8_t pending = slave.lss.pending_.node_id;
    claim(slave.lss.take_node_id() == pending);
    claim((slave.lss.state_ == LssState::waiting) && (slave.lss.selected_ == 0U) && (slave.lss.identified_ == 0U));
    claim((slave.lss.scan_.position_ == 0U) && (slave.lss.scan_.confirmed_ == 0U));
    claim(slave.lss.is_consistent());
}

}  // namespace canproof::proofs
