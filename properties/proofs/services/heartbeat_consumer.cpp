// SPDX-License-Identifier: Apache-2.0
// Theorems on the heartbeat consumer: for any frame, any time, any state and any settings in 1016h (consumer heartbeat
// time).
#include "firmware/canopen/heartbeat_consumer.hpp"

#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/node.hpp"

namespace canproof::proofs {

namespace {

constexpr std::size_t producers = HeartbeatConsumer::max_producers;

struct Watching {
    AnyDictionary dictionary{};
    HeartbeatConsumer consumer{dictionary.objects};

    Watching() {
        leave_open(consumer);
        assume(consumer.is_consistent());
    }
};

}  // namespace

void reset_watches_what_1016h_names() {
    shows("reset() watches exactly the producer of an active entry of 1016h, has heard nobody, and is consistent");
    proves<req::CO_HB_002, req::CO_HB_003>();
    AnyDictionary dictionary{};
    HeartbeatConsumer consumer{dictionary.objects};
    leave_open(consumer);
    assume(consumer.failed_ < (1U << producers));
    consumer.reset();
    const std::uint32_t entry = dictionary.objects.read(HeartbeatConsumer::index, 1U);
    const std::uint32_t time = entry & 0xFFFFU;
    const std::uint32_t node_id = (entry >> 16U) & 0xFFU;
    const bool active = (time != 0U) && (node_id >= 1U) && (node_id <= 127U);
    claim(consumer.watches_[0].identifier == (active ? (0x700U + node_id) : 0U));
    claim(consumer.watches_[0].time.us == (active ? (std::uint64_t{time} * 1000U) : 0U));
    claim(consumer.next_deadline() == never);
    claim(consumer.failed() == 0U);
    claim(consumer.is_consistent());
}

void a_heartbeat_begins_a_new_wait() {
    shows("a heartbeat of a watched producer ends its failure and moves its deadline; any other frame changes nothing");
    proves<req::CO_HB_002>();
    Watching node{};
    const Frame frame = any_frame();
    assume(frame.is_plain());  // the node passes only data frames with 11-bit identifiers to the consumer
    assume(frame.id != 0U);    // identifier 0 belongs to NMT, which the node handles first
    const Instant now = any_time();
    const auto slot = any<std::uint8_t>();
    assume(slot < producers);
    const HeartbeatConsumer::Watch before = node.consumer.watches_[slot];
    const bool had_failed = ((node.consumer.failed() >> slot) & 1U) != 0U;
    const bool heard = node.consumer.receive(frame, now);
    const bool hit = heard && (frame.id == before.identifier);
    claim(!heard || (frame.length == 1U));
    claim(node.consumer.watches_[slot].deadline == (hit ? (now + before.time) : before.deadline));
    claim((((node.consumer.failed() >> slot) & 1U) != 0U) == (had_failed && !hit));
    claim(node.consumer.is_consistent());
}

void a_silent_producer_fails_in_time() {
    shows("advance() fails exactly the producers whose deadline has come, and no deadline is left behind");
    proves<req::CO_HB_002>();
    Watching node{};
    const Instant now = any_time();
    const auto slot = any<std::uint8_t>();
    assume(slot < producers);
    const bool is_late = node.consumer.watches_[slot].deadline <= now;
    const bool had_failed = ((node.consumer.failed() >> slot) & 1U) != 0U;
    node.consumer.advance(now);
    claim((((node.consumer.failed() >> slot) & 1U) != 0U) == (had_failed || is_late));
    claim(node.consumer.next_deadline() > now);
    claim(node.consumer.is_consistent());
}

void a_write_to_1016h_restarts_one_entry() {
    shows(
        "after a write to an entry of 1016h, whatever its sub-index, the consumer is consistent and no other entry "
        "changed");
    proves<req::CO_HB_003>();
    Watching node{};
    node.dictionary.objects.write(HeartbeatConsumer::index, 1U, any<std::uint32_t>());
    EntryRow row{};
    row.subindex = any<std::uint8_t>();
    const auto slot = any<std::uint8_t>();
    assume((slot < producers) && ((slot + 1U) != row.subindex));
    const Instant deadline = node.consumer.watches_[slot].deadline;
    const std::uint32_t identifier = node.consumer.watches_[slot].identifier;
    node.consumer.after_write(EntryRef{&row, static_cast<std::uint16_t>(HeartbeatConsumer::index)});
    claim(node.consumer.watches_[slot].deadline == deadline);
    claim(node.consumer.watches_[slot].identifier == identifier);
    claim(node.consumer.is_consistent());
}

}  // namespace canproof::proofs
