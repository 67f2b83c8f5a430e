// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/lss.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/index.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof {

namespace {

namespace index = generated::canopen::index;

namespace requests = generated::canopen::lss_requests;

constexpr std::size_t full_length = 8U;

static_assert(implements<req::CO_E_LSS_COMMAND> && implements<req::CO_T_LSS>);
const requests::Row* request_row(const std::uint8_t specifier) noexcept {
    for (const requests::Row& row : requests::rows) {
        if (static_cast<std::uint32_t>(row.command) == specifier) {
            return &row;
        }
    }
    return nullptr;
}

static_assert(implements<req::CO_E_LSS_ANSWER>);
std::uint8_t answer_specifier(const LssCommand command) noexcept {
    if (command == LssCommand::select_serial_number) {
        return static_cast<std::uint8_t>(LssAnswer::selected);
    }
    if ((command == LssCommand::identify_serial_high) || (command == LssCommand::fastscan)) {
        return static_cast<std::uint8_t>(LssAnswer::identified);
    }
    if (command == LssCommand::identify_non_configured) {
        return static_cast<std::uint8_t>(LssAnswer::non_configured);
    }
    return static_cast<std::uint8_t>(command);
}

/// Returns the distance of a command specifier from the first one of its service: the position of this frame in the
/// sequence of frames of that service.
constexpr std::uint32_t offset_from(const LssCommand first, const LssCommand command) noexcept {
    return static_cast<std::uint32_t>(command) - static_cast<std::uint32_t>(first);
}

/// The condition of one frame of identify remote slave: the slave's number is at least the bound (`lowest`), at most
/// the bound (`highest`), or equal to the bound (both are set).
struct IdentityBound {
    LssNumber number;
    bool lowest;
    bool highest;
};

/// The frames of identify remote slave in their order. Vendor-ID and product code must match exactly.
constexpr std::array<IdentityBound, 6U> identity_bounds{{{LssNumber::vendor_id, true, true},
                                                         {LssNumber::product_code, true, true},
                                                         {LssNumber::revision_number, true, false},
                                                         {LssNumber::revision_number, false, true},
                                                         {LssNumber::serial_number, true, false},
                                                         {LssNumber::serial_number, false, true}}};

/// Returns how many frames of a sequence have matched in order, now that frame number `step` has come. `done`: the
/// number before this frame. `fits`: this frame matches.
constexpr std::uint8_t follow(const std::uint8_t done, const std::uint32_t step, const bool fits) noexcept {
    static_assert(implements<req::CO_LSS_068> && implements<req::CO_LSS_077>);
    const bool in_order = (step == 0U) || (step == done);
    return (in_order && fits) ? static_cast<std::uint8_t>(step + 1U) : std::uint8_t{0U};
}

}  // namespace

static_assert(implements<req::CO_K_LSS_LOWEST_NODE_ID> && implements<req::CO_K_LSS_HIGHEST_NODE_ID>);
bool is_lss_node_id(const std::uint8_t node_id) noexcept {
    const bool is_one =
        (node_id >= generated::canopen::lss_lowest_node_id) && (node_id <= generated::canopen::lss_highest_node_id);
    return is_one || (node_id == unconfigured_node_id);
}

static_assert(implements<req::CO_T_LSS_BIT_RATE>);
std::uint32_t LssProfile::bit_rate(const std::uint8_t index) const noexcept {
    for (const LssBitRate& row : bit_rates_) {
        if (std::uint32_t{row.index} == index) {
            return row.bit_rate;
        }
    }
    return 0U;
}

void Lss::power_on(const LssConfiguration& stored) noexcept {
    stored_ = stored;
    active_ = stored;
    switching_ = Switching::none;
}

// Restores the stored node-ID and the stored bit rate: for LSS, reset node equals power-on (CO-D-LSS-008).
static_assert(implements<req::CO_LSS_017>);
void Lss::restore(const Instant now) noexcept {
    pending_ = stored_;
    if (active_.bit_rate != stored_.bit_rate) {
        active_.bit_rate = stored_.bit_rate;
        application_.set_bit_rate(active_.bit_rate, now);
    }
}

static_assert(implements<req::CO_LSS_004> && implements<req::CO_LSS_011> && implements<req::CO_LSS_086>);
std::uint8_t Lss::take_node_id() noexcept {
    state_ = LssState::waiting;
    selected_ = 0U;
    identified_ = 0U;
    scan_.restart();
    active_.node_id = pending_.node_id;
    return active_.node_id;
}

bool Lss::receive(const Frame& frame, const NmtState nmt, const Instant now) noexcept {
    const requests::Row* const row = request_row(frame.data[0]);
    static_assert(implements<req::CO_LSS_060> && implements<req::CO_LSS_080>);
    if ((row == nullptr) || (std::uint32_t{frame.length} <= row->parameters) || !is_served(row->served, nmt)) {
        return false;
    }
    const LssState before = state_;
    std::uint32_t said{0U};
    static_assert(implements<req::CO_LSS_073> && implements<req::CO_LSS_082>);
    if (execute(row->command, frame.data, now, said) && (row->answer_length != 0U)) {
        static_assert(implements<req::CO_LSS_061> && implements<req::CO_LSS_063> &&
                      implements<req::CO_K_LSS_RESPONSE_ID>);
        const bool in_full = frame.length == full_length;
        static_assert(implements<req::CO_LSS_081> && implements<req::CO_LSS_085>);
        const std::uint8_t length = in_full ? static_cast<std::uint8_t>(full_length) : row->answer_length;
        const std::uint64_t answer = (std::uint64_t{said} << 8U) | answer_specifier(row->command);
        queue_.push_seldom(generated::canopen::lss_response_cob_id, length, answer);
    }
    static_assert(implements<req::CO_LSS_018> && implements<req::CO_LSS_031>);
    const bool left = (before == LssState::configuration) && (state_ == LssState::waiting);
    const bool has_got_node_id =
        (active_.node_id == unconfigured_node_id) && (pending_.node_id != unconfigured_node_id);
    return left && (profile_.resets_when_left() || has_got_node_id);
}

static_assert(implements<req::CO_LSS_005> && implements<req::CO_LSS_006> && implements<req::CO_LSS_070>);
bool Lss::is_served(const Served when, const NmtState nmt) const noexcept {
    const bool configuring = state_ == LssState::configuration;
    switch (when) {
        case Served::always:
            return true;
        case Served::waiting:
            return !configuring;
        case Served::configuration:
            return configuring;
        case Served::setting:
        default:
            return configuring && (nmt != NmtState::operational);
    }
}

static_assert(implements<req::CO_LSS_040> && implements<req::CO_LSS_041> && implements<req::CO_LSS_044>);
bool Lss::execute(const LssCommand command, const Request& request, const Instant now, std::uint32_t& said) noexcept {
    const auto number = static_cast<std::uint32_t>(field_le<1U, sizeof(std::uint32_t)>(request));
    switch (command) {
        case LssCommand::switch_state_global:
            switch_globally(request[1]);
            return true;
        case LssCommand::configure_node_id:
            said = static_cast<std::uint32_t>(configure_node_id(request[1]));
            return true;
        case LssCommand::configure_bit_timing:
            said = static_cast<std::uint32_t>(configure_bit_timing(request[1], request[2]));
            return true;
        case LssCommand::activate_bit_timing:
            activate(milliseconds(field_le<1U, sizeof(std::uint16_t)>(request)), now);
            return true;
        case LssCommand::store_configuration:
            said = static_cast<std::uint32_t>(store());
            return true;
        case LssCommand::select_vendor_id:
        case LssCommand::select_product_code:
        case LssCommand::select_revision_number:
        case LssCommand::select_serial_number:
            return select(offset_from(LssCommand::select_vendor_id, command), number);
        case LssCommand::identify_vendor_id:
        case LssCommand::identify_product_code:
        case LssCommand::identify_revision_low:
        case LssCommand::identify_revision_high:
        case LssCommand::identify_serial_low:
        case LssCommand::identify_serial_high:
            return identify(offset_from(LssCommand::identify_vendor_id, command), number);
        case LssCommand::identify_non_configured:
            return !is_configured();
        case LssCommand::fastscan:
            return scan(request);
        case LssCommand::inquire_vendor_id:
        case LssCommand::inquire_product_code:
        case LssCommand::inquire_revision_number:
        case LssCommand::inquire_serial_number:
            said = own(offset_from(LssCommand::inquire_vendor_id, command));
            return true;
        case LssCommand::inquire_node_id:
            said = active_.node_id;
            return true;
        default:
            return false;
    }
}

static_assert(implements<req::CO_LSS_001> && implements<req::CO_LSS_067> && implements<req::CO_E_LSS_STATE>);
void Lss::switch_globally(const std::uint8_t mode) noexcept {
    if (mode == static_cast<std::uint32_t>(LssState::waiting)) {
        state_ = LssState::waiting;
    } else if (mode == static_cast<std::uint32_t>(LssState::configuration)) {
        state_ = LssState::configuration;
    } else {
        // an unknown mode is ignored
    }
}

static_assert(implements<req::CO_LSS_002> && implements<req::CO_LSS_003>);
bool Lss::select(const std::uint32_t number, const std::uint32_t wanted) noexcept {
    static_assert(implements<req::CO_LSS_069>);
    selected_ = follow(selected_, number, own(number) == wanted);
    if (selected_ == lss_number_count) {
        state_ = LssState::configuration;
    }
    return selected_ != 0U;
}

static_assert(implements<req::CO_LSS_042> && implements<req::CO_LSS_043>);
bool Lss::identify(const std::uint32_t step, const std::uint32_t bound) noexcept {
    const IdentityBound& asked = identity_bounds[step];
    const std::uint32_t number = own(static_cast<std::uint32_t>(asked.number));
    const bool fits = (!asked.lowest || (number >= bound)) && (!asked.highest || (number <= bound));
    static_assert(implements<req::CO_LSS_078>);
    identified_ = follow(identified_, step, fits);
    return identified_ != 0U;
}

static_assert(implements<req::CO_LSS_050>);
bool Lss::scan(const Request& request) noexcept {
    if (is_configured()) {
        return false;
    }
    const LssFastscan::Outcome outcome = scan_.scan(request, own(scan_.position()));
    if (outcome == LssFastscan::Outcome::completed) {
        state_ = LssState::configuration;
    }
    return outcome != LssFastscan::Outcome::silent;
}

static_assert(implements<req::CO_LSS_010> && implements<req::CO_LSS_071> && implements<req::CO_E_LSS_ERROR>);
LssError Lss::configure_node_id(const std::uint8_t node_id) noexcept {
    if (!is_lss_node_id(node_id)) {
        return LssError::not_supported;
    }
    pending_.node_id = node_id;
    return LssError::none;
}

static_assert(implements<req::CO_LSS_012> && implements<req::CO_LSS_072> && implements<req::CO_K_LSS_STANDARD_TABLE>);
LssError Lss::configure_bit_timing(const std::uint8_t table, const std::uint8_t index) noexcept {
    const std::uint32_t bit_rate = profile_.bit_rate(index);
    if ((table != generated::canopen::lss_standard_bit_timing_table) || (bit_rate == 0U)) {
        return LssError::not_supported;
    }
    pending_.bit_rate = bit_rate;
    return LssError::none;
}

static_assert(implements<req::CO_LSS_016>);
LssError Lss::store() noexcept {
    const LssError error = application_.store_configuration(pending_);
    if (error == LssError::none) {
        stored_ = pending_;
        stored_.damaged = false;
    }
    return error;
}

static_assert(implements<req::CO_LSS_014> && implements<req::CO_LSS_015> && implements<req::CO_LSS_019>);
void Lss::activate(const Duration delay, const Instant now) noexcept {
    delay_ = delay;
    switching_ = Switching::before;
    due_ = later(now, delay);
    advance(now);
}

static_assert(implements<req::CO_LSS_013>);
void Lss::switch_bit_rate(const Instant now) noexcept {
    if (switching_ == Switching::before) {
        active_.bit_rate = pending_.bit_rate;
        application_.set_bit_rate(active_.bit_rate, now);
        switching_ = Switching::after;
        due_ = later(now, delay_);
    }
    if (due_ <= now) {
        switching_ = Switching::none;
        due_ = never;
    }
}

bool Lss::is_configured() const noexcept {
    return (active_.node_id != unconfigured_node_id) || (pending_.node_id != unconfigured_node_id);
}

std::uint32_t Lss::own(const std::uint32_t number) const noexcept {
    return objects_.read(index::identity, static_cast<std::uint8_t>(number + 1U));
}

}  // namespace canproof
