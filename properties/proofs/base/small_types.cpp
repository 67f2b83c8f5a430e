// SPDX-License-Identifier: Apache-2.0
// Theorems on the small types of firmware/base: results, time, sequence numbers, slots, rows of tables and commit
// markers. They cover every function of these types for all arguments.
#include "firmware/base/commit_marker.hpp"
#include "firmware/base/result.hpp"
#include "firmware/base/sequence_number.hpp"
#include "firmware/base/slots.hpp"
#include "firmware/base/table_row.hpp"
#include "firmware/base/time.hpp"
#include "properties/proofs/support/proof.hpp"

namespace canproof::proofs {

void a_result_is_what_it_was_made_of() {
    shows("a result has its value and no error, or its error and the value zero");
    const auto value = any<std::uint32_t>();
    const auto error = any<std::uint8_t>();
    using Number = Result<std::uint32_t, std::uint8_t>;
    claim(Number::success(value).ok());
    claim(Number::success(value).value() == value);
    claim(Number::success(value).error() == 0U);
    claim(!Number::failure(error).ok());
    claim(Number::failure(error).error() == error);
    claim(Number::failure(error).value() == 0U);
}

void a_deadline_never_wraps() {
    shows("a time plus a duration is never before that time, and exact unless it lies behind the end of time");
    const Instant start{any<std::uint64_t>()};
    const Duration length{any<std::uint64_t>()};
    const Instant end = start + length;
    claim(start <= end);
    claim((end == never) || ((end.us - start.us) == length.us));
    claim((length.us > (UINT64_MAX - start.us)) ? (end == never) : (elapsed(start, end).us == length.us));
}

void a_later_start_is_no_earlier_end() {
    shows("the end of a duration is monotone in its start and in its length");
    const Instant a{any<std::uint64_t>()};
    const Instant b{any<std::uint64_t>()};
    const Duration c{any<std::uint64_t>()};
    const Duration d{any<std::uint64_t>()};
    assume((a <= b) && (c.us <= d.us));
    claim((a + c) <= (b + d));
}

void elapsed_time_is_never_negative() {
    shows("the time from one instant to another is their difference, and zero when they are the wrong way round");
    const Instant a{any<std::uint64_t>()};
    const Instant b{any<std::uint64_t>()};
    claim(elapsed(a, b).us == ((a <= b) ? (b.us - a.us) : 0U));
}

void instants_are_ordered() {
    shows("instants compare as their numbers, and the earliest of two is the smaller one");
    const Instant a{any<std::uint64_t>()};
    const Instant b{any<std::uint64_t>()};
    claim((a == b) == (a.us == b.us));
    claim((a != b) == (a.us != b.us));
    claim((a < b) == (a.us < b.us));
    claim((a > b) == (a.us > b.us));
    claim((a <= b) == (a.us <= b.us));
    claim((earliest(a, b) <= a) && (earliest(a, b) <= b));
    claim((earliest(a, b) == a) || (earliest(a, b) == b));
    claim(a <= never);
}

void durations_have_their_units() {
    shows("milliseconds are 1000 us and inhibit times 100 us, exactly, for every 16-bit count: those of the objects");
    const std::uint64_t count = any<std::uint16_t>();
    claim(microseconds(count).us == count);
    // multiplies by sums of powers of two: 1000 = 1024 - 16 - 8, 100 = 64 + 32 + 4
    claim(milliseconds(count).us == ((count << 10U) - (count << 4U) - (count << 3U)));
    claim(hundreds_of_microseconds(count).us == ((count << 6U) + (count << 5U) + (count << 2U)));
}

void later_is_the_sum() {
    shows("later() and sum_or_never() give the sum of a time and a duration");
    const Instant start{any<std::uint64_t>()};
    const Duration length{any<std::uint64_t>()};
    claim(later(start, length) == (start + length));
    claim(sum_or_never(start.us, length.us) == (start + length).us);
}

void an_event_is_due_at_its_time() {
    shows("an event is due when its time is reached, or lies more than a period ahead");
    const Instant next{any<std::uint64_t>()};
    const Duration period{any<std::uint64_t>()};
    const Instant now{any<std::uint64_t>()};
    const bool is_ahead = (next.us > now.us) && ((next.us - now.us) > period.us);
    claim(is_due(next, period, now) == ((next.us <= now.us) || is_ahead));
}

void the_next_event_is_ahead_by_at_most_a_period() {
    shows(
        "the next time of an event that is due is one period after the event if that is still ahead, else after now; "
        "it never lies in the past, and is not due before its time");
    const Instant due{any<std::uint64_t>()};
    const Duration period{any<std::uint64_t>()};
    const Instant now{any<std::uint64_t>()};
    const Instant next = next_after(due, period, now);
    const bool is_in_step = (due <= now) && ((due + period) > now);
    claim(next == (is_in_step ? (due + period) : (now + period)));
    claim((now <= next) && (next <= (now + period)));
    const Instant before{any<std::uint64_t>()};
    assume((now <= before) && (before < next));
    claim(!is_due(next, period, before));
}

void sequence_numbers_wrap() {
    shows("of two sequence numbers less than 2^31 apart the later one is newer, across the wrap of 32 bits as well");
    const auto earlier = any<std::uint32_t>();
    const auto distance = any<std::uint32_t>();
    assume(distance < 0x80000000U);
    const std::uint32_t later = earlier + distance;
    claim(is_newer(later, earlier) == (distance != 0U));
    claim(!is_newer(earlier, later));
}

void slots_reach_their_places() {
    shows("slots reach each of their places, and a part of them lies within them");
    const std::size_t count = any_size();
    std::uint8_t* const places = any_memory(count);
    const Slots<std::uint8_t> slots{places, count};
    claim((slots.size() == count) && (slots.empty() == (count == 0U)));
    claim((slots.begin() == places) && (slots.end() == (places + count)));
    const std::size_t from = any<std::size_t>();
    const std::size_t wanted = any<std::size_t>();
    const Slots<std::uint8_t> part = slots.part(from, wanted);
    const std::size_t start = (from < count) ? from : count;
    claim(part.begin() == (places + start));
    claim(part.end() == (part.begin() + part.size()));
    claim(part.size() == ((wanted < (count - start)) ? wanted : (count - start)));
    const std::size_t at = any<std::size_t>();
    assume(at < part.size());
    claim(&part[at] == (places + start + at));
}

void empty_slots_have_no_places() {
    shows("slots without memory are empty, and so are their parts");
    const Slots<std::uint32_t> none{};
    claim(none.empty() && (none.size() == 0U));
    claim(none.begin() == none.end());
    claim(none.part(any<std::size_t>(), any<std::size_t>()).empty());
}

void a_missing_row_is_what_the_caller_says() {
    shows("cell_or() gives the cell of a row, and without a row what the caller says");
    struct Row {
        std::uint16_t first;
        std::uint32_t second;
    };
    const Row row = any<Row>();
    const auto otherwise = any<std::uint32_t>();
    claim(cell_or(&row, &Row::second, otherwise) == row.second);
    claim(cell_or(static_cast<const Row*>(nullptr), &Row::second, otherwise) == otherwise);
}

void a_bank_is_judged_by_its_marker() {
    shows("a bank of 0 to 16 bytes is unused when void or blank, and damaged only when readable and committed");
    auto bytes = any<std::array<std::uint8_t, 16U>>();
    const std::size_t size = any<std::size_t>();
    assume(size <= bytes.size());
    const ByteView bank = ByteView{bytes}.part(0U, size);
    const bool readable = any<bool>();
    const auto committed = any<std::uint8_t>();
    bool blank = (bank[0] == 0x00U) || (bank[0] == 0xFFU);
    for (std::size_t i = 0U; i < bytes.size(); ++i) {
        blank = blank && ((i >= size) || (bank[i] == bank[0]));
    }
    const BankState state = state_by_marker(readable, bank, committed);
    const bool unused = readable && ((bank[commit_marker_at] == void_marker) || blank);
    claim((state == BankState::unused) == unused);
    claim((state == BankState::damaged) == (readable && !unused && (bank[commit_marker_at] == committed)));
    claim(state != BankState::sound);
}

}  // namespace canproof::proofs
