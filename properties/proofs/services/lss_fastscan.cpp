// SPDX-License-Identifier: Apache-2.0
// Theorems on LSS Fastscan, for any request, any state of the scan and any LSS address.
#include "firmware/canopen/lss_fastscan.hpp"

#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

namespace {

/// Offers an input with this request to the fuzz target `lss` (fuzz/lss_fuzz.cpp). In this input, requests come first
/// that restart the scan and confirm the numbers before `position`. These numbers are from the LSS address of the slave
/// in the fuzz target.
void offer_as_seed(const std::uint32_t position, const LssFastscan::Request& request) {
    constexpr std::array<std::uint32_t, 3U> address{0x00000055U, 0xAA020301U, 0x00010002U};
    constexpr std::size_t record_size = 10U;
    std::array<std::uint8_t, 5U * record_size> input{0U, 8U, 0x51U, 0U, 0U, 0U, 0U, 128U};
    for (std::size_t i = 0U; i < address.size(); ++i) {
        const std::size_t at = (i + 1U) * record_size;
        input[at] = (i < position) ? std::uint8_t{0U} : std::uint8_t{0x0FU};  // 0Fh is a pause; the next byte is its
                                                                              // length, 0 ms
        input[at + 1U] = (i < position) ? std::uint8_t{8U} : std::uint8_t{0U};
        input[at + 2U] = 0x51U;
        for (std::size_t byte = 0U; byte < 4U; ++byte) {
            input[at + 3U + byte] = static_cast<std::uint8_t>(address[i] >> (8U * byte));
        }
        input[at + 8U] = static_cast<std::uint8_t>(i);
        input[at + 9U] = static_cast<std::uint8_t>(i + 1U);
    }
    const std::size_t last = 4U * record_size;
    input[last + 1U] = 8U;
    input[last + 2U] = 0x51U;
    for (std::size_t i = 1U; i < request.size(); ++i) {
        input[last + 2U + i] = request[i];
    }
    fuzz_seed("lss", input);
}

}  // namespace

void a_scan_begins_with_nothing_confirmed() {
    shows("a scan begins at the vendor-ID with no number confirmed, and is consistent");
    LssFastscan scan{};
    scan.restart();
    claim(scan.is_consistent());
    claim((scan.position() == 0U) && (scan.confirmed_ == 0U));
}

void a_scan_request_is_answered_as_cia_305_says() {
    shows(
        "a Fastscan request is answered exactly when it restarts the scan, or is sound, in turn and fits the address");
    proves<req::CO_LSS_051, req::CO_LSS_052, req::CO_LSS_079, req::CO_LSS_055>();
    LssFastscan scan = any<LssFastscan>();
    assume(scan.is_consistent());
    const auto request = any<LssFastscan::Request>();
    offer_as_seed(scan.position(), request);
    const auto own = any<std::uint32_t>();
    const std::uint32_t position = scan.position();
    const std::uint32_t bit_check = request[5];
    const std::uint32_t asked = (std::uint32_t{request[4]} << 24U) | (std::uint32_t{request[3]} << 16U) |
                                (std::uint32_t{request[2]} << 8U) | request[1];
    const bool restarts = bit_check == 128U;
    bool fits{true};
    for (std::uint32_t bit = 0U; bit < 32U; ++bit) {
        fits = fits && ((bit < bit_check) || (((own >> bit) & 1U) == ((asked >> bit) & 1U)));
    }
    const bool sound = (bit_check < 32U) && (request[7] < 4U) && (request[6] == position);
    const LssFastscan::Outcome outcome = scan.scan(request, own);
    claim((outcome != LssFastscan::Outcome::silent) == (restarts || (sound && fits)));
    claim(scan.is_consistent());
}

void a_scan_confirms_all_four_numbers() {
    shows("a scan is complete exactly when its last number is confirmed, and a silent request changes nothing");
    proves<req::CO_LSS_053, req::CO_LSS_054>();
    LssFastscan scan = any<LssFastscan>();
    assume(scan.is_consistent());
    const LssFastscan before = scan;
    const auto request = any<LssFastscan::Request>();
    offer_as_seed(before.position_, request);
    const LssFastscan::Outcome outcome = scan.scan(request, any<std::uint32_t>());
    const bool answered = outcome != LssFastscan::Outcome::silent;
    const bool confirms = answered && (request[5] == 0U) && (request[7] != before.position_);
    const std::uint32_t confirmed = before.confirmed_ | (confirms ? (1U << before.position_) : 0U);
    claim((outcome == LssFastscan::Outcome::completed) == (confirmed == 15U));
    claim(answered || ((scan.position_ == before.position_) && (scan.confirmed_ == before.confirmed_)));
    const bool goes_on = confirms && (confirmed != 15U);
    claim(!goes_on || ((scan.position_ == request[7]) && (scan.confirmed_ == confirmed)));
}

}  // namespace canproof::proofs
