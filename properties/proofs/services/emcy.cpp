// SPDX-License-Identifier: Apache-2.0
// Theorems on the EMCY service, for any table of errors: 1001h (error register), 1003h (error list) and the content of
// an emergency message.
#include "firmware/canopen/emcy.hpp"

#include "generated/canopen/index.hpp"
#include "generated/canopen/requirements.hpp"
#include "properties/proofs/support/node.hpp"

namespace canproof::proofs {

namespace {

namespace index = generated::canopen::index;

constexpr std::uint32_t list_length = 10U;  ///< length of 1003h (error list) in the CAN-CBX-AO412

struct Reporting {
    AnyDictionary dictionary{};
    TransmitQueue queue{};
    ErrorTable errors{any<ErrorTable>()};
    bool keeps_history{any<bool>()};
    bool counts{any<bool>()};
    Emcy emcy{dictionary.objects, queue, errors, keeps_history ? ErrorList::history : ErrorList::active,
              counts ? EmcyContent::listed_errors : EmcyContent::detail};

    Reporting() {
        leave_open(emcy);
        emcy.list_ = keeps_history ? ErrorList::history : ErrorList::active;
        emcy.content_ = counts ? EmcyContent::listed_errors : EmcyContent::detail;
        assume(emcy.is_consistent());
    }
    std::uint32_t listed(const std::uint32_t sub) const {
        return dictionary.objects.read(index::error_list, static_cast<std::uint8_t>(sub));
    }
};

}  // namespace

void the_error_register_shows_what_lasts() {
    shows("1001h holds a bit exactly when an error that lasts has it, and a change of 1001h is noticed");
    proves<req::CO_EMCY_012, req::CO_EMCY_025>();
    Reporting node{};
    const std::uint32_t bit = any<std::uint8_t>() & 7U;
    const bool had_changed = node.emcy.register_changed_;
    const std::uint8_t before = node.emcy.shown_register_;
    bool lasts{false};
    for (std::size_t i = 0U; i < max_errors; ++i) {
        lasts =
            lasts || ((((node.emcy.active_ >> i) & 1U) != 0U) && (((node.errors[i].register_bits >> bit) & 1U) != 0U));
    }
    node.emcy.show_register();
    const std::uint32_t shown = node.dictionary.objects.read(index::error_register, 0U);
    claim((((shown >> bit) & 1U) != 0U) == lasts);
    claim(node.emcy.register_changed_ == (had_changed || (shown != before)));
    claim(node.emcy.is_consistent());
}

void a_listed_error_comes_first() {
    shows("a new error stands at 1003h:1, the others move up by one, and the oldest leaves a full list");
    proves<req::CO_EMCY_013, req::CO_EMCY_026>();
    Reporting node{};
    const auto entry = any<std::uint32_t>();
    const std::uint32_t count = each(list_length + 1U);
    node.dictionary.objects.write(index::error_list, 0U, count);
    std::array<std::uint32_t, list_length> before{};
    for (std::uint32_t sub = 1U; sub <= list_length; ++sub) {
        before[sub - 1U] = node.listed(sub);
    }
    node.emcy.enter_into_list(entry);
    claim(node.listed(1U) == entry);
    for (std::uint32_t sub = 1U; (sub <= count) && (sub < list_length); ++sub) {
        claim(node.listed(sub + 1U) == before[sub - 1U]);
    }
    claim(node.listed(0U) == ((count < list_length) ? (count + 1U) : list_length));
    claim(node.emcy.is_consistent());
}

void a_cured_error_leaves_the_list() {
    shows("of a list of up to three errors a cured one leaves, and the others keep their order without a gap");
    proves<req::CO_EMCY_007>();
    Reporting node{};
    const auto entry = any<std::uint32_t>();
    const std::uint32_t count = node.listed(0U);
    assume(count <= 3U);
    std::array<std::uint32_t, 3U> kept{};
    std::size_t stays{0U};
    for (std::uint32_t sub = 1U; sub <= 3U; ++sub) {
        const bool remains = (sub <= count) && (node.listed(sub) != entry);
        if (remains) {
            kept[stays] = node.listed(sub);
            ++stays;
        }
    }
    node.emcy.remove_from_list(entry);
    claim(node.listed(0U) == stays);
    for (std::uint32_t sub = 1U; sub <= 3U; ++sub) {
        claim((sub > count) || (node.listed(sub) == kept[sub - 1U]));
    }
    claim(node.emcy.is_consistent());
}

void an_emergency_message_holds_what_cia_301_says() {
    shows("an emergency message has eight bytes on the identifier of 1014h: code, 1001h, then what the device adds");
    proves<req::CO_EMCY_001, req::CO_EMCY_023, req::CO_EMCY_033, req::CO_EMCY_010>();
    Reporting node{};
    Emcy::Pending pending{any<std::uint8_t>(), any<bool>()};
    assume(pending.error < max_errors);
    const Frame message = node.emcy.message(pending);
    const ErrorRow& row = node.errors[pending.error];
    const std::uint32_t code = pending.cured ? 0U : row.code;
    const std::uint32_t detail = pending.cured ? 0U : (std::uint32_t{row.detail} | node.emcy.channel_[pending.error]);
    claim(message.id == (node.dictionary.objects.read(index::emcy_cob_id, 0U) & 0x7FFU));
    claim((message.length == 8U) && !message.extended && !message.remote);
    claim((message.data[0] == (code & 0xFFU)) && (message.data[1] == (code >> 8U)));
    claim(message.data[2] == node.emcy.shown_register_);
    claim(message.data[3] == (node.counts ? (node.listed(0U) & 0xFFU) : (detail & 0xFFU)));
    claim(message.data[4] == (node.counts ? 0U : (detail >> 8U)));
    claim((message.data[5] == 0U) && (message.data[6] == 0U) && (message.data[7] == 0U));
}

void at_most_two_messages_of_an_error_wait() {
    shows("with up to four messages waiting, announcing an error leaves at most two of it, the last one as it stands");
    proves<req::CO_EMCY_002, req::CO_EMCY_006, req::CO_EMCY_022>();
    Reporting node{};
    const auto error = any<std::uint8_t>();
    const bool cured = any<bool>();
    node.emcy.pending_count_ = each(5U);
    assume((error < max_errors) && !node.emcy.enabled_);
    assume(node.emcy.is_consistent());
    std::size_t before{0U};
    bool alternates{true};  // whether, of two waiting messages of the error, one reports its beginning and the other
                            // its end
    bool newest{false};
    for (std::size_t i = 0U; i < 4U; ++i) {
        const bool own = (i < node.emcy.pending_count_) && (node.emcy.pending_[i].error == error);
        alternates = alternates && (!own || (before == 0U) || (node.emcy.pending_[i].cured != newest));
        newest = own ? node.emcy.pending_[i].cured : newest;
        before += own ? 1U : 0U;
    }
    assume((before <= 2U) && alternates);
    const bool is_on = (node.dictionary.objects.read(index::emcy_cob_id, 0U) & 0x80000000U) == 0U;
    node.emcy.announce(error, cured, any_time());
    std::size_t after{0U};
    bool last{!cured};
    for (std::size_t i = 0U; i < 5U; ++i) {
        const bool own = (i < node.emcy.pending_count_) && (node.emcy.pending_[i].error == error);
        after += own ? 1U : 0U;
        last = own ? node.emcy.pending_[i].cured : last;
    }
    claim(after <= 2U);
    claim(is_on || (after == before));
    claim(!is_on || (last == cured));
    claim(node.queue.empty());
    claim(node.emcy.is_consistent());
}

}  // namespace canproof::proofs
