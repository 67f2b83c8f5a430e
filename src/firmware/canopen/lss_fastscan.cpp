#include "firmware/canopen/lss_fastscan.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/tables.hpp"
#include "generated/requirements.hpp"

namespace canproof {

namespace {

namespace checks = generated::canopen::t_co_t_lss_bit_check;

constexpr std::size_t id_number_at = 1U;
constexpr std::size_t bit_check_at = 5U;
constexpr std::size_t number_at = 6U;
constexpr std::size_t next_at = 7U;
constexpr std::uint8_t all_confirmed = (1U << lss_number_count) - 1U;

}  // namespace

void LssFastscan::restart() noexcept {
    position_ = static_cast<std::uint8_t>(LssNumber::vendor_id);
    confirmed_ = 0U;
}

static_assert(implements<req::CO_LSS_051> && implements<req::CO_LSS_055> && implements<req::CO_T_LSS_BIT_CHECK>);
LssFastscan::Outcome LssFastscan::scan(const ByteView request, const LssAddress& own) noexcept {
    const auto* const check = checks::find(request[bit_check_at]);
    const checks::Action action = (check == nullptr) ? checks::Action::ignore : check->action;
    if (action == checks::Action::restart) {
        restart();
        return Outcome::matched;
    }
    const bool exists = (request[number_at] < lss_number_count) && (request[next_at] < lss_number_count);
    if ((action == checks::Action::ignore) || !exists || (request[number_at] != position_)) {
        return Outcome::silent;
    }
    const Outcome outcome = compare(request, own);
    const bool confirms = (action == checks::Action::confirm) && (request[next_at] != position_);
    return ((outcome == Outcome::matched) && confirms) ? confirm(position_, request[next_at]) : outcome;
}

static_assert(implements<req::CO_LSS_052> && implements<req::CO_E_LSS_NUMBER>);
LssFastscan::Outcome LssFastscan::compare(const ByteView request, const LssAddress& own) noexcept {
    const std::uint32_t differing = own[request[number_at]] ^ read_u32(request, id_number_at);
    return ((differing >> request[bit_check_at]) == 0U) ? Outcome::matched : Outcome::silent;
}

// A master may lead through the numbers in any order; what it cannot do is leave one out (CO-D-LSS-004).
static_assert(implements<req::CO_LSS_053> && implements<req::CO_LSS_054>);
LssFastscan::Outcome LssFastscan::confirm(const std::uint8_t number, const std::uint8_t next) noexcept {
    confirmed_ = static_cast<std::uint8_t>(confirmed_ | (1U << number));
    position_ = next;
    return (confirmed_ == all_confirmed) ? Outcome::completed : Outcome::matched;
}

}  // namespace canproof
