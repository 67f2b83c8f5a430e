// SPDX-License-Identifier: Apache-2.0
// LSS slave: sets node-ID and bit rate over the bus (CiA 305; AX130751 3.1, AX188001 3.1, AX060805 4.1). The master's
// frames have identifier 7E5h, the answers 7E4h.
#pragma once

#include "firmware/base/requirement.hpp"
#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/lss_fastscan.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "firmware/canopen/transmit_queue.hpp"
#include "generated/canopen/constants.hpp"
#include "generated/canopen/requirements.hpp"
#include "generated/canopen/tables.hpp"

namespace canproof {

using generated::canopen::LssAnswer;
using generated::canopen::LssCommand;
using generated::canopen::LssError;
using generated::canopen::LssState;
using generated::canopen::unconfigured_node_id;

/// Returns whether LSS may assign this node-ID: 1…127, or unconfigured_node_id, which removes the node-ID (CiA 305,
/// 6.4.2).
bool is_lss_node_id(std::uint8_t node_id) noexcept;

/// The settings that LSS changes.
struct LssConfiguration {
    std::uint8_t node_id{unconfigured_node_id};  ///< 1…127, or unconfigured_node_id
    std::uint32_t bit_rate{0U};                  ///< bit/s
    /// The stored settings cannot be read; node_id and bit_rate are then the shipped ones.
    bool damaged{false};
};

/// One row of a device's bit timing table.
struct LssBitRate {
    std::uint8_t index{0U};
    std::uint32_t bit_rate{0U};  ///< bit/s; 0 where the index is reserved
};

/// Returns the rows of a generated table with the columns `index` and `bit_rate`.
template <typename Row, std::size_t N>
constexpr std::array<LssBitRate, N> lss_bit_rates(const std::array<Row, N>& rows) noexcept {
    std::array<LssBitRate, N> rates{};
    for (std::size_t i = 0U; i < N; ++i) {
        rates[i] = LssBitRate{rows[i].index, rows[i].bit_rate};
    }
    return rates;
}

/// The properties of a device's LSS.
class LssProfile {
  public:
    /// Creates the profile of a device without LSS.
    constexpr LssProfile() noexcept = default;
    /// Creates the profile of a device with LSS. `bit_rates` must outlive the profile. `resets_when_left`: the node
    /// resets its communication at each switch from LSS configuration to LSS waiting.
    template <std::size_t N>
    constexpr LssProfile(const std::array<LssBitRate, N>& bit_rates, const bool resets_when_left) noexcept
        : bit_rates_{table_view(bit_rates)}, offered_{true}, resets_when_left_{resets_when_left} {}

    constexpr bool is_offered() const noexcept { return offered_; }
    constexpr bool resets_when_left() const noexcept { return resets_when_left_; }
    /// Returns the bit rate in bit/s for an index of the bit timing table; 0 for a reserved index and for one that is
    /// not in the table.
    std::uint32_t bit_rate(std::uint8_t index) const noexcept;

  private:
    TableView<LssBitRate> bit_rates_{};
    bool offered_{false};
    bool resets_when_left_{false};
};

/// The functions of the device that LSS calls. A device without LSS does not override them.
// Defined in the header only: host classes with type information derive from it, and the firmware is compiled without
// type information.
class LssApplication {
  public:
    LssApplication(const LssApplication&) = delete;
    LssApplication& operator=(const LssApplication&) = delete;
    LssApplication(LssApplication&&) = delete;
    LssApplication& operator=(LssApplication&&) = delete;

    /// Switches the CAN controller to `bit_rate` bit/s now.
    virtual void set_bit_rate(const std::uint32_t bit_rate, const Instant now) {
        static_cast<void>(bit_rate);
        static_cast<void>(now);
    }
    /// Stores the settings for the next power-on.
    virtual LssError store_configuration(const LssConfiguration& configuration) {
        static_assert(implements<req::CO_LSS_075>);
        static_cast<void>(configuration);
        return LssError::not_supported;
    }

  protected:
    LssApplication() = default;
    ~LssApplication() = default;
};

class Lss {
  public:
    Lss(const LssProfile& profile, const ObjectDictionary& objects, TransmitQueue& queue,
        LssApplication& application) noexcept
        : profile_{profile}, objects_{objects}, queue_{queue}, application_{application} {}

    /// Starts with the stored settings at power-on.
    void power_on(const LssConfiguration& stored) noexcept;
    /// Returns whether the stored settings could not be read at power-on and none have been stored since.
    bool is_damaged() const noexcept { return stored_.damaged; }
    /// Serves NMT reset node: discards settings that were configured and not stored, and switches back to the stored
    /// bit rate. A call of take_node_id() must follow.
    void restore(Instant now) noexcept;
    /// Serves NMT reset communication: makes the pending node-ID active and returns it. Returns unconfigured_node_id
    /// when there is none.
    std::uint8_t take_node_id() noexcept;

    /// Returns whether a frame is an LSS request; always false for a device without LSS.
    bool is_request(const Frame& frame) const noexcept {
        static_assert(implements<req::CO_LSS_062> && implements<req::CO_LSS_064> &&
                      implements<req::CO_K_LSS_REQUEST_ID>);
        return (frame.id == generated::canopen::lss_request_cob_id) && !frame.extended && !frame.remote &&
               profile_.is_offered();
    }
    /// Serves one request. `nmt` is the NMT state of the node. Call it only while is_silent() is false. Returns true
    /// when the node must now reset its communication.
    bool receive(const Frame& frame, NmtState nmt, Instant now) noexcept;
    void advance(const Instant now) noexcept {
        if (due_ <= now) {
            switch_bit_rate(now);
        }
    }
    Instant next_deadline() const noexcept { return due_; }

    /// Returns whether the bit rate is being switched: the node sends no frame and ignores received ones.
    bool is_silent() const noexcept { return switching_ != Switching::none; }

    /// Returns whether the invariant between two requests holds (properties/invariants): each counter is within the
    /// length of its sequence of requests. The pending node-ID is one that LSS can give. A deadline exists exactly
    /// while the bit rate is being switched.
    bool is_consistent() const noexcept;

  private:
    using Served = generated::canopen::lss_requests::Served;
    enum class Switching : std::uint8_t { none, before, after };
    using Request = LssFastscan::Request;

    bool is_served(Served when, NmtState nmt) const noexcept;
    /// Executes a request. Returns false when the request must be ignored. Returns true otherwise; if its command has
    /// an answer, `said` holds the content of the answer after the command specifier.
    bool execute(LssCommand command, const Request& request, Instant now, std::uint32_t& said) noexcept;
    void switch_globally(std::uint8_t mode) noexcept;
    bool select(std::uint32_t number, std::uint32_t wanted) noexcept;
    bool identify(std::uint32_t step, std::uint32_t bound) noexcept;
    bool scan(const Request& request) noexcept;
    LssError configure_node_id(std::uint8_t node_id) noexcept;
    LssError configure_bit_timing(std::uint8_t table, std::uint8_t index) noexcept;
    LssError store() noexcept;
    void switch_bit_rate(Instant now) noexcept;
    void activate(Duration delay, Instant now) noexcept;

    bool is_configured() const noexcept;
    /// Returns the part of this device's LSS address that `number`, an LssNumber, names.
    std::uint32_t own(std::uint32_t number) const noexcept;

    LssProfile profile_;
    const ObjectDictionary& objects_;
    TransmitQueue& queue_;
    LssApplication& application_;
    LssState state_{LssState::waiting};
    LssConfiguration stored_{};
    LssConfiguration pending_{};
    LssConfiguration active_{};
    std::uint8_t selected_{0U};    ///< number of matching frames of switch state selective so far
    std::uint8_t identified_{0U};  ///< number of matching frames of identify remote slave so far
    LssFastscan scan_{};
    Switching switching_{Switching::none};
    Duration delay_{};
    Instant due_{never};
};

}  // namespace canproof
