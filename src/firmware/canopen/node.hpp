// SPDX-License-Identifier: Apache-2.0
// A CANopen slave: the services, connected to one object dictionary. NodeProfile and Application hold what differs
// between devices.
#pragma once

#include "firmware/base/requirement.hpp"
#include "firmware/canopen/emcy.hpp"
#include "firmware/canopen/error_control.hpp"
#include "firmware/canopen/heartbeat_consumer.hpp"
#include "firmware/canopen/lss.hpp"
#include "firmware/canopen/nmt.hpp"
#include "firmware/canopen/object_access.hpp"
#include "firmware/canopen/parameter_store.hpp"
#include "firmware/canopen/pdo_memory.hpp"
#include "firmware/canopen/sdo_server.hpp"
#include "firmware/canopen/sync.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

/// The properties in which the devices differ on the bus, apart from their objects.
struct NodeProfile {
    LimitAbort limit_abort{LimitAbort::high_low};
    ErrorList error_list{ErrorList::history};
    EmcyContent emcy_content{EmcyContent::listed_errors};
    /// Bit n: a remote frame on the identifier of RPDO n + 1 reads the values of this RPDO back (CAN-CBX-AO412, 7.7.2).
    std::uint8_t rpdos_answering_remote{0U};
    /// A write to 1010h store parameters in another state than pre-operational gets 08000022h (CAN-CBX-AO412, 7.9.12).
    bool saves_in_pre_operational_only{false};
    bool block_sdo{false};  ///< the device supports SDO block transfer
    LssProfile lss{};       ///< bit rates and behaviour of the device's LSS; the default is no LSS
    TpdoTrigger tpdo_trigger{TpdoTrigger::value_change};
};

/// The functions of the device that the node calls. All its functions are defined in this header, because host classes
/// with type information derive from this class and the firmware is compiled without type information.
class Application : public LssApplication {
  public:
    Application(const Application&) = delete;
    Application& operator=(const Application&) = delete;
    Application(Application&&) = delete;
    Application& operator=(Application&&) = delete;

    /// Returns AbortCode::none when an entry of Service::program can be accessed in the present state of the device,
    /// otherwise the reason. The default permits every access.
    virtual AbortCode check_access(const EntryRef& entry) {
        static_cast<void>(entry);
        return AbortCode::none;
    }
    /// Checks a write to an entry of Service::device or Service::program after all other checks. Returns
    /// AbortCode::none to permit it. The default permits every write.
    virtual AbortCode before_write(const EntryRef& entry, const ByteView value) {
        static_cast<void>(entry);
        static_cast<void>(value);
        return AbortCode::none;
    }
    /// Applies the new value of an entry of Service::device or Service::program.
    virtual void after_write(const EntryRef& entry, Instant now) = 0;
    /// Stores what the device keeps outside the dictionary, after a write to 1010h store parameters has stored the
    /// parameter groups `saved`. The returned abort code is the answer to that write.
    virtual AbortCode save(const ParameterGroups saved) {
        static_cast<void>(saved);
        return AbortCode::none;
    }
    /// Puts the values of this unit (serial number, calibration) into the dictionary after the defaults of a group were
    /// loaded.
    virtual void put_factory_values(ParameterGroup group) = 0;
    /// Resets all states of the device after power-on or NMT reset node. The parameters are loaded already.
    virtual void restart(Instant now) = 0;
    /// Notifies the device that the node has queued the boot-up message and entered pre-operational. If it boots in
    /// bus-off, the message is lost, and if 1029h:1 (error behaviour) is 2 the node is already in NMT state stopped.
    virtual void booted(Instant now) = 0;
    /// Returns the value of a DOMAIN entry without copying it; the value stays unchanged until commit() or a reset.
    /// Fails with 06010000h when the device has no memory for this entry, with 08000024h when the entry has no value.
    /// A value of no bytes is a value.
    virtual Result<ByteView, AbortCode> domain_value(const EntryRef& entry) {
        static_assert(implements<req::CO_SDO_046>);
        static_cast<void>(entry);
        return Result<ByteView, AbortCode>::failure(AbortCode::unsupported_access);
    }
    /// Returns the memory that collects the new value of a DOMAIN entry, or of an entry longer than the SDO server's
    /// buffer. Empty when there is none. Its contents have no effect until the download is complete.
    virtual MutableBytes staging(const EntryRef& entry) {
        static_cast<void>(entry);
        return MutableBytes{};
    }
    /// Takes the first `length` bytes of the staging memory as the new value of a DOMAIN entry. Returns an abort code
    /// when the device refuses the whole value; the old value then stays.
    virtual AbortCode commit(const EntryRef& entry, const std::size_t length, const Instant now) {
        static_cast<void>(entry);
        static_cast<void>(length);
        static_cast<void>(now);
        return AbortCode::unsupported_access;
    }
    /// Notifies the device that the first communication error of 1029h:1 (heartbeat, guarding, overdue RPDO, bus-off)
    /// began (`failed`) or the last one ended. The device is not notified of an error that begins or ends while another
    /// one is present.
    virtual void communication_failed(const bool failed, const Instant now) {
        static_cast<void>(failed);
        static_cast<void>(now);
    }

  protected:
    Application() = default;
    ~Application() = default;
};

/// The memory of a node's settings, for a check that nothing but the node changes them.
struct NodeSettings {
    std::uint32_t changes{0U};  ///< another number after each change of a setting
    ByteView values{};          ///< the settings in the object dictionary
    Slots<ReceivePdo> received{};
    Slots<TransmitPdo> sent{};
    Slots<PdoLine> received_lines{};
    Slots<PdoLine> sent_lines{};
};

class Node final : private ObjectAccess {
  public:
    /// `errors` and the memory that `pdos` refers to must outlive the node.
    Node(ObjectDictionary& objects, NonVolatileMemory& memory, TransmitQueue& queue, Application& application,
         const ErrorTable& errors, const NodeProfile& profile, const PdoMemory& pdos) noexcept;

    /// Starts the node at power-on. `stored` holds the settings that LSS stored, or the node-ID (1…127) of the
    /// switches. `can_state` and `overrun` are as in set_controller(). While the controller is bus-off, the boot-up
    /// message is lost and emergency messages wait. Without a node-ID the node stays in initialising until LSS
    /// assigns one.
    void power_on(const LssConfiguration& stored, const std::uint8_t can_state, const bool overrun,
                  const Instant now) noexcept {
        set_controller(can_state, overrun, now);
        switch_on(stored, now);
    }
    /// Processes one frame from the bus. Frames without meaning for this node are ignored.
    void receive(const Frame& frame, Instant now) noexcept;
    /// Does what is due at `now`.
    void advance(const Instant now) noexcept {
        if ((idle_until_ <= now) || (sdo_.idle_until() <= now)) {
            act(now);
        } else {
            sdo_.send_waiting(now);
        }
        advance_pdos(now);
    }
    /// Returns the earliest time at which advance() has work to do.
    Instant next_deadline() const noexcept {
        return earliest(earliest(next_of_others(), sdo_.next_deadline()), tpdos_.next_deadline());
    }

    void set_can_state(CanState state, Instant now) noexcept;
    /// Sets the state of the CAN controller as a physical input reports it. `state` is a number of CanState; greater
    /// numbers count as bus-off.
    void set_controller(std::uint8_t state, bool overrun, Instant now) noexcept;
    /// Begins or ends an overrun: `lost` is true when a frame was lost because the controller or a queue was full.
    void set_overrun(bool lost, Instant now) noexcept;
    /// Begins or ends an error that the device has detected.
    void set_error(const ErrorId error, const bool present, const Instant now) noexcept {
        if (emcy_.is_active(error) != present) {
            change_error(error, present, now);
        }
    }
    /// Changes the NMT state as 1029h (error behaviour) demands in entry `subindex` for its class of errors.
    void apply_error_behaviour(std::uint8_t subindex, Instant now) noexcept;
    /// Plans the self-start: the node enters operational at `at`, unless one of these comes first: an NMT command, a
    /// reset, or an error for which 1029h error behaviour demands a state. A communication error that is present
    /// already and has such a demand also prevents the self-start.
    void start_at(Instant at) noexcept;

    /// Notifies the TPDOs of a new process value. A TPDO of type 254 or 255 that this triggers is sent by the next
    /// advance() that its inhibit time allows, a TPDO of type 0 at the next SYNC.
    void process_value_changed(const std::uint16_t index, const std::uint8_t subindex, const Instant now) noexcept {
        tpdos_.value_changed(index, subindex, now);
    }

    /// See ParameterStore::tag_saves().
    void tag_saves(const std::uint8_t tag) noexcept { store_.tag_saves(tag); }
    std::uint8_t saved_tag() const noexcept { return store_.saved_tag(); }

    NmtState state() const noexcept { return state_; }
    /// Returns the state of the CAN controller that set_controller() has set last.
    CanState can_state() const noexcept { return can_state_; }
    /// Returns the active node-ID; unconfigured_node_id when there is none.
    std::uint8_t node_id() const noexcept { return node_id_; }
    bool has_error(const ErrorId error) const noexcept { return emcy_.is_active(error); }
    /// Returns the receive PDOs that are overdue: bit n for RPDO n + 1. An RPDO is overdue from the end of its event
    /// time until a frame with accepted values is received.
    std::uint8_t overdue_rpdos() const noexcept { return rpdos_.overdue(); }
    NodeSettings settings() const noexcept {
        return NodeSettings{objects_.setting_changes(),
                            objects_.settings(),
                            rpdos_.all(),
                            tpdos_.all(),
                            rpdos_.lines(),
                            tpdos_.lines()};
    }

    /// Returns whether what the node adds to the invariants of its services holds between two calls
    /// (properties/invariants). The services that work are those of the NMT state, and error control shows this state,
    /// except in initialising. No SDO transfer is open in a state without SDO.
    bool is_consistent() const noexcept;
    /// Returns the name of the first service that is not consistent, or "node" for the node itself; nullptr when all
    /// are consistent (properties/invariants). In initialising, without a node-ID, only the services count that need no
    /// boot-up.
    const char* inconsistent_service() const noexcept;

  private:
    Result<ByteView, AbortCode> read(std::uint16_t index, std::uint8_t subindex) override;
    AbortCode write(std::uint16_t index, std::uint8_t subindex, ByteView value, Instant now) override;
    Result<WritePlace, AbortCode> writable(std::uint16_t index, std::uint8_t subindex) override;

    AbortCode before_received(const EntryRef& entry, std::uint64_t bits) override;
    void after_put(const EntryRef& entry, const bool changes, const Instant now) override {
        if (entry.row->service != Service::none) {
            take_effect(entry, now);
        }
        if (changes) {
            note_change(entry, now);
        }
    }
    bool is_watched(const std::uint64_t marks) const override { return tpdos_.is_watched(marks); }

    /// Returns the next deadline of all services except SDO and the TPDOs.
    Instant next_of_others() const noexcept;
    /// Makes the next advance() check all services, because one of them may have work now.
    void wake() noexcept { idle_until_ = Instant{}; }
    void act(Instant now) noexcept;
    bool serve_sdo(const Frame& frame, Instant now) noexcept;
    void serve(const Frame& frame, Instant now) noexcept;
    void advance_pdos(const Instant now) noexcept {
        if (tpdos_.next_deadline() <= now) {
            send_pdos(now);
        }
    }
    /// Sends the TPDOs that are due. Not inlined, so that receive() needs no register for the address of `tpdos_`.
    [[gnu::noinline]] void send_pdos(const Instant now) noexcept { tpdos_.advance(now); }
    /// Ends the processing of a frame.
    void settle(const Instant now) noexcept {
        if (idle_until_ <= now) {  // the frame has changed more than values of entries
            watch_communication(now);
            tell_register(now);
        }
        advance_pdos(now);
    }
    void change_error(ErrorId error, bool present, Instant now) noexcept;
    void serve_sync(const Frame& frame, Instant now) noexcept;
    void serve_remote(const Frame& request, Instant now) noexcept;
    void serve_data(const Frame& frame, Instant now) noexcept;
    void obey(NmtCommand command, Instant now) noexcept;
    void configure(const Frame& frame, Instant now) noexcept;
    void follow_switching(const Instant now) noexcept {
        if (switching_ != lss_.is_silent()) {
            switch_bit_rate(now);
        }
    }
    void switch_bit_rate(Instant now) noexcept;
    bool may_send() const noexcept;
    void switch_on(const LssConfiguration& stored, Instant now) noexcept;
    void reset_node(Instant now) noexcept;
    void reset_communication(Instant now) noexcept;
    void load_group(ParameterGroup group) noexcept;
    void load_all() noexcept;
    void tell_damage(Instant now) noexcept;
    void boot_up(Instant now) noexcept;
    void enter(NmtState state, Instant now) noexcept;
    void admit_services(Instant now) noexcept;

    [[gnu::noinline]] void serve_upload(const sdo::Request& request, Instant now) noexcept;
    [[gnu::noinline]] void serve_special_upload(const sdo::Request& request, EntryRef found, Instant now) noexcept;
    Result<ByteView, AbortCode> read_entry(EntryRef entry) noexcept;
    [[gnu::noinline]] AbortCode write_special(EntryRef entry, ByteView value, Instant now) noexcept;
    /// Returns why an entry that lookup() returned cannot be accessed now; AbortCode::none when it can.
    AbortCode check_access(const EntryRef& entry) noexcept {
        if (!entry.exists()) {
            return objects_.missing(entry.index);
        }
        return (entry.row->service == Service::program) ? check_program(entry) : AbortCode::none;
    }
    AbortCode check_program(const EntryRef& entry) noexcept;
    AbortCode before_write(const EntryRef& entry, ByteView value) noexcept;
    AbortCode check_parameter(const EntryRef& entry, std::uint32_t value) const noexcept;
    void after_write(const EntryRef& entry, Instant now) noexcept;
    /// Applies a write in the service that owns the entry.
    void take_effect(const EntryRef& entry, const Instant now) noexcept {
        after_write(entry, now);
        wake();
    }
    /// Notifies the TPDOs of a value that has changed.
    static_assert(implements<req::CO_PDO_042>);
    void note_change(const EntryRef& entry, const Instant now) noexcept {
        if (entry.may(rights::tpdo)) {
            process_value_changed(entry.index, entry.row->subindex, now);
        }
    }
    /// Clears 1020h verify configuration if an SDO has changed a value that is part of the configuration.
    static_assert(implements<req::CO_VERIFY_005>);
    void note_configuration(const EntryRef& entry) noexcept {
        if (entry.may(rights::stored) && !entry.may(rights::rpdo)) {
            forget_verification(entry.index);
        }
    }
    AbortCode store(const EntryRef& entry, std::uint32_t value) noexcept;
    void forget_verification(std::uint16_t changed_index) noexcept;
    AbortCode write_domain(const EntryRef& entry, ByteView value, Instant now) noexcept;

    /// The present communication faults, as bits.
    struct CommunicationFaults {
        /// Bit n: the heartbeat of the producer in 1016h:n + 1 (consumer heartbeat time) is missing.
        static constexpr std::uint32_t silent_producers = 0xFFU;
        static constexpr std::uint32_t guarding = 0x100U;
        static constexpr std::uint32_t bus_off = 0x400U;
        static constexpr std::uint32_t rpdo_short = 0x800U;
        static constexpr std::uint32_t rpdo_refused = 0x1000U;
        static constexpr std::uint32_t first_rpdo_overdue = 16U;  ///< number of the bit that stands for RPDO1
        static constexpr std::uint32_t rpdo_overdue = 0xFF0000U;  ///< bit n + 16: RPDO n + 1 is overdue

        std::uint32_t bits{0U};

        bool has(const std::uint32_t any) const noexcept { return (bits & any) != 0U; }
        /// Returns whether one of the faults is a communication error of 1029h:1 (error behaviour).
        bool is_error() const noexcept { return has(silent_producers | guarding | rpdo_overdue | bus_off); }
    };

    CommunicationFaults communication_faults() const noexcept;
    /// Returns whether there is no communication fault now and none at the last check.
    bool communicates() const noexcept {
        return (faults_.bits == 0U) && (heartbeats_.failed() == 0U) && !error_control_.life_guarding_failed() &&
               !rpdos_.has_failed() && (can_state_ != CanState::bus_off);
    }
    void watch_communication(const Instant now) noexcept {
        if (!communicates()) {
            take_note(now);
        }
    }
    [[gnu::noinline]] void take_note(Instant now) noexcept;
    void announce(CommunicationFaults faults, Instant now) noexcept;
    std::uint32_t error_behaviour(std::uint8_t subindex) const noexcept;
    /// Returns whether an error prevents a self-start: a communication error is present, and 1029h:1 (error behaviour)
    /// is not 1 (no change of state).
    bool error_prevents_start() const noexcept;
    void consume_sync(std::uint8_t counter, Instant now) noexcept;
    /// Tells the TPDOs that 1001h (error register) has changed.
    void tell_register(const Instant now) noexcept {
        if (emcy_.take_register_change()) {
            register_changed(now);
        }
    }
    void register_changed(Instant now) noexcept;

    ObjectDictionary& objects_;
    TransmitQueue& queue_;
    Application& application_;
    // The members that the node uses most come first: an instruction of two bytes then reaches them.
    NmtState state_{NmtState::initialising};
    CanState can_state_{CanState::error_active};
    std::uint8_t node_id_{0U};
    bool communication_failed_{false};
    bool overrun_{false};
    bool switching_{false};  ///< LSS changes the bit rate: the node is silent
    AllowedServices allowed_{};
    CommunicationFaults faults_{};
    Instant start_at_{never};
    Instant idle_until_{};  ///< until then only TPDOs and SDO can be due; wake() sets it to 0
    NodeProfile profile_;
    ParameterStore store_;
    Sync sync_;
    ErrorControl error_control_;
    HeartbeatConsumer heartbeats_;
    ReceivePdos rpdos_;
    TransmitPdos tpdos_;
    Lss lss_;
    SdoServer sdo_;
    Emcy emcy_;
};

}  // namespace canproof
