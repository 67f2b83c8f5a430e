// SPDX-License-Identifier: Apache-2.0
#include "host/conform/steps/need.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/base/cia301.hpp"
#include "host/conform/language/expression.hpp"
#include "host/conform/language/filter.hpp"

namespace canproof::host::conform {

namespace {

constexpr std::uint32_t unknown_command = 0x05040001U;

using Unmet = std::function<std::string(Context&)>;

const char* const known =
    "use 1017, 1017:00, 1017:00: FILTER, no 100C, some: FILTER, tpdos >= 1, rpdos >= 1, guarding, lss, block upload, "
    "block download, sync producer, power, exact power, bit rate, saves, restores, remote frames, eds SECTION.KEY = "
    "VALUE";

bool has(const Context& context, unsigned index, unsigned subindex = 0) {
    return context.sheet.find(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(subindex)).entry != nullptr;
}

std::string ask_block(Context& context, bool upload) {
    std::optional<bool>& answer = upload ? context.block_upload : context.block_download;
    if (!answer) {
        try {
            SdoOutcome outcome;
            if (upload) {
                outcome = context.sdo.block_read({cia301::device_type, 0}, {});
            } else {
                const ObjectPlace place{cia301::producer_heartbeat_time, 0};
                if (!has(context, place.index)) {
                    return "the EDS has no object 1017h (Producer heartbeat time) that a block download could write";
                }
                outcome = context.sdo.block_write(place, context.sdo.read(place).data, {});
            }
            answer = outcome.abort != unknown_command;
        } catch (const NoAnswer&) {
            throw;
        } catch (const SlaveFailed&) {
            // the slave has block transfer, because it did not abort; the case itself checks the transfer
            answer = true;
        }
    }
    return *answer ? "" : fmt::format("the slave has no block {} (abort 05040001h)", upload ? "upload" : "download");
}

/// Reads sub-index 1 of 1010h (store parameters) or 1011h (restore defaults). Returns an empty text when its bit 0 is
/// set, which means that the slave offers the command; otherwise the reason why the need is not met.
std::string ask_capability(Context& context, unsigned index) {
    const ObjectPlace place{static_cast<std::uint16_t>(index), 1};
    if (!has(context, index, 1)) {
        return fmt::format("the EDS has no entry {}", words_of(place));
    }
    const SdoOutcome outcome = context.sdo.read(place);
    const bool can = outcome.abort == 0 && (from_little_endian(outcome.data, 0, 4) & 1) != 0;
    return can ? ""
               : fmt::format(
                     "a read of {} does not return bit 0 = 1, so the slave does not offer the command of this object",
                     words_of(place));
}

std::string unless(bool met, const char* reason) {
    return met ? "" : reason;
}

Unmet parse_word_need(Scanner& line) {
    struct Word {
        const char* words;
        Unmet unmet;
    };
    static const std::vector<Word> all{
        {"guarding",
         [](Context& c) {
             return unless(has(c, cia301::guard_time) && has(c, cia301::life_time_factor),
                           "the EDS has no node guarding (100Ch guard time and 100Dh life time factor)");
         }},
        {"lss", [](Context& c) { return unless(c.sheet.part.info.lss, "by the EDS, the slave has no LSS"); }},
        {"block upload", [](Context& c) { return ask_block(c, true); }},
        {"block download", [](Context& c) { return ask_block(c, false); }},
        {"sync producer",
         [](Context& c) {
             const SheetEntry id = c.sheet.find(cia301::sync_cob_id, 0);
             const bool met = id.entry != nullptr && is_writable(*id.entry) && has(c, cia301::sync_period);
             return unless(
                 met,
                 "the EDS has no SYNC producer (writable 1005h COB-ID SYNC, and 1006h communication cycle period)");
         }},
        {"power",
         [](Context& c) {
             return unless(c.link.target().power_switch() != PowerSwitch::nobody,
                           "in this run, nobody can switch the slave off and on (on a bus, --by-hand lets you do it)");
         }},
        {"exact power",
         [](Context& c) {
             return unless(c.link.target().power_switch() == PowerSwitch::program,
                           "in this run, no program can switch the slave off to the millisecond");
         }},
        {"bit rate",
         [](Context& c) {
             return unless(c.link.target().follows_bit_rate(),
                           "this bus does not take over a new bit rate of the slave");
         }},
        {"remote frames",
         [](Context& c) { return unless(c.link.target().has_remote_frames(), "this bus carries no remote frames"); }},
        {"saves", [](Context& c) { return ask_capability(c, cia301::store_parameters); }},
        {"restores", [](Context& c) { return ask_capability(c, cia301::restore_parameters); }},
    };
    for (const Word& one : all) {
        if (line.take_word(one.words)) {
            line.finish();
            return one.unmet;
        }
    }
    return {};
}

Unmet parse_count(Scanner& line, bool transmit) {
    line.want(">=", "write tpdos >= 1");
    const Expression count = parse_expression(line, Radix::decimal);
    line.finish();
    return [count, transmit](Context& context) {
        const std::size_t has = context.sheet.pdos(transmit).size();
        const auto wanted = number_of(count(context.root));
        return static_cast<std::int64_t>(has) >= wanted
                   ? std::string{}
                   : fmt::format("the EDS has {} {}(s), the case needs {}", has, transmit ? "TPDO" : "RPDO", wanted);
    };
}

Unmet parse_some(Scanner& line) {
    line.want(":", "write some: readable, size > 4");
    const Filter filter = parse_filter(line, "");
    return [filter](Context& context) {
        return filter.select(context.sheet).empty() ? "the EDS has no entry that is " + filter.words : std::string{};
    };
}

Unmet parse_key(Scanner& line) {
    const std::string section = line.up_to(".");
    const std::string key = line.word();
    const bool equal = !line.take("!=");
    if (equal) {
        line.want("=", "write eds DummyUsage.Dummy0005 = 1");
    }
    const std::string value = line.rest();
    return [=](Context& context) {
        const auto found = context.sheet.key(section, key);
        const bool met = found && ((*found == value) == equal);
        return met ? std::string{}
                   : fmt::format("the EDS has {} = {} in [{}]; the case needs {}{}", key,
                                 found ? *found : std::string{"nothing"}, section, equal ? "" : "not ", value);
    };
}

unsigned hex_word(Scanner& line, std::size_t digits) {
    const std::string word = line.word();
    if (word.size() != digits || word.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) {
        line.fail(fmt::format("`{}` is no condition for `needs`", line.line()), known);
    }
    return static_cast<unsigned>(std::stoul(word, nullptr, 16));
}

Unmet parse_absent(Scanner& line) {
    const auto index = static_cast<std::uint16_t>(hex_word(line, 4));
    line.finish();
    return [index](Context& context) {
        return context.sheet.object(index) == nullptr ? std::string{} : fmt::format("the EDS has {:04X}h", index);
    };
}

Unmet parse_object_need(Scanner& line) {
    const auto index = static_cast<std::uint16_t>(hex_word(line, 4));
    if (line.at_end()) {
        return [index](Context& context) {
            return context.sheet.object(index) != nullptr ? std::string{}
                                                          : fmt::format("the EDS has no object {:04X}h", index);
        };
    }
    line.want(":", "write 1017:00");
    const ObjectPlace place{index, static_cast<std::uint8_t>(hex_word(line, 2))};
    Filter filter;
    if (line.take(":")) {
        filter = parse_filter(line, "");
    }
    line.finish();
    return [place, filter](Context& context) -> std::string {
        const SheetEntry one = context.sheet.find(place.index, place.subindex);
        if (one.entry == nullptr) {
            return fmt::format("the EDS has no entry {}", words_of(place));
        }
        return filter.passes(one) ? "" : fmt::format("{} is not {} in the EDS", words_of(place), filter.words);
    };
}

}  // namespace

Need parse_need(Scanner& line) {
    Need need;
    need.words = line.line();
    if (const Unmet found = parse_word_need(line)) {
        need.unmet = found;
    } else if (line.take_word("no")) {
        need.unmet = parse_absent(line);
    } else if (line.take_word("some")) {
        need.unmet = parse_some(line);
    } else if (line.take_word("tpdos")) {
        need.unmet = parse_count(line, true);
    } else if (line.take_word("rpdos")) {
        need.unmet = parse_count(line, false);
    } else if (line.take_word("eds")) {
        need.unmet = parse_key(line);
    } else {
        need.unmet = parse_object_need(line);
    }
    return need;
}

}  // namespace canproof::host::conform
