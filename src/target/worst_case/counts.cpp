// SPDX-License-Identifier: Apache-2.0
// A plugin of QEMU (TCG) that counts how often a device runs given functions, calls and loops in each work, and
// compares sums of these counts with limits. A work is a power-on, frame, tick or command, or a frame at a deadline.
//
// The file of its argument `in=FILE` has these lines; addresses are hexadecimal:
//   begin ADDRESS, end ADDRESS    the functions before and behind each work
//   due ADDRESS                   the function before the beginning of a work at the time of a deadline
//   kind KIND DUE ADDRESS         the function that is called first in a work of this kind; at a deadline its kind is
//   DUE
//   changes FROM TO ADDRESS       a work of kind FROM that calls this function has kind TO
//   at COUNTER ADDRESS            counts each time that the block at this address runs
//   jump COUNTER SOURCE TARGET    counts each time that the block at TARGET runs directly after the instruction at
//                                 SOURCE
//   limit KIND MOST EACH N COUNTER… M COUNTER… A COUNTER… B COUNTER…    the sum of N counters is at most MOST + EACH *
//                                 (sum of M counters) in each work in which one of A counters, if there are any, and
//                                 none of B counters has counted
// At the end it writes lines to the file of its argument `out=FILE`:
//   work KIND COUNT               how many works of each kind ran
//   counter COUNTER KIND MOST     the most that a counter reached in one work
//   excess LIMIT KIND EXCESS      the most by which a work exceeded a limit, counted from 0; negative when none did
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "target/qemu/plugin.hpp"

namespace {

constexpr std::size_t kinds = 5;  // power_on, frame, tick, command, due_frame
constexpr std::size_t no_kind = kinds;

struct Limit {
    std::size_t kind{0};
    std::int64_t most{0};
    std::int64_t each{0};
    std::vector<std::size_t> sum{};
    std::vector<std::size_t> per{};
    std::vector<std::size_t> needs{};
    std::vector<std::size_t> excludes{};
    std::int64_t excess{INT64_MIN};
};

/// An action that follows when a block runs that contains an address.
struct Event {
    enum Action { due, begin, end, kind, changes, count } action;
    std::size_t first{0};
    std::size_t second{0};
};

struct Block {
    std::uint64_t last{0};
    std::vector<Event> events{};
    std::multimap<std::uint64_t, std::size_t>
        jumps{};  ///< counters by the instruction from which this block is reached
};

/// The only object of this type is never destroyed, because QEMU calls ends() after the destructors of static
/// variables.
struct Record {
    std::multimap<std::uint64_t, Event> events{};                                 ///< by address
    std::multimap<std::uint64_t, std::pair<std::uint64_t, std::size_t>> jumps{};  ///< (source, counter) by target
    std::vector<Limit> limits{};
    std::vector<std::uint32_t> counters{};
    std::vector<std::array<std::uint32_t, kinds>> most{};
    std::array<std::uint64_t, kinds> works{};
    std::vector<std::unique_ptr<Block>> blocks{};
    std::uint64_t before{0};
    bool inside{false};
    bool is_due{false};  ///< the work is one at the time of a deadline
    bool next_is_due{false};
    std::size_t kind{no_kind};
    std::string out{};
};
Record& record = *new Record;

std::int64_t sum_of(const std::vector<std::size_t>& counters) {
    std::int64_t sum = 0;
    for (const std::size_t one : counters) {
        sum += record.counters[one];
    }
    return sum;
}

void judge() {
    ++record.works[record.kind];
    for (std::size_t i = 0; i < record.counters.size(); ++i) {
        std::uint32_t& most = record.most[i][record.kind];
        most = record.counters[i] > most ? record.counters[i] : most;
    }
    for (Limit& limit : record.limits) {
        const bool applies = (limit.needs.empty() || sum_of(limit.needs) > 0) && sum_of(limit.excludes) == 0;
        if (limit.kind == record.kind && applies) {
            const std::int64_t excess = sum_of(limit.sum) - limit.most - (limit.each * sum_of(limit.per));
            limit.excess = excess > limit.excess ? excess : limit.excess;
        }
    }
}

void happens(const Event& event) {
    switch (event.action) {
        case Event::due:
            record.next_is_due = true;
            break;
        case Event::begin:
            record.inside = true;
            record.is_due = std::exchange(record.next_is_due, false);
            record.kind = no_kind;
            record.counters.assign(record.counters.size(), 0);
            break;
        case Event::end:
            if (record.inside && record.kind != no_kind) {
                judge();
            }
            record.inside = false;
            break;
        case Event::kind:
            if (record.kind == no_kind) {
                record.kind = record.is_due ? event.second : event.first;
            }
            break;
        case Event::changes:
            record.kind = record.kind == event.first ? event.second : record.kind;
            break;
        case Event::count:
            ++record.counters[event.first];
            break;
    }
}

void runs(unsigned int, void* data) {
    const auto* const block = static_cast<Block*>(data);
    for (const Event& event : block->events) {
        happens(event);
    }
    if (!block->jumps.empty()) {
        const auto [first, last] = block->jumps.equal_range(record.before);
        for (auto one = first; one != last; ++one) {
            ++record.counters[one->second];
        }
    }
    record.before = block->last;
}

void translated(PluginId, qemu_plugin_tb* block) {
    auto made = std::make_unique<Block>();
    const std::size_t size = qemu_plugin_tb_n_insns(block);
    for (std::size_t i = 0; i < size; ++i) {
        made->last = qemu_plugin_insn_vaddr(qemu_plugin_tb_get_insn(block, i));
        const auto [first, last] = record.events.equal_range(made->last);
        for (auto one = first; one != last; ++one) {
            made->events.push_back(one->second);
        }
        if (i == 0) {
            const auto [from, to] = record.jumps.equal_range(made->last);
            for (auto one = from; one != to; ++one) {
                made->jumps.insert(one->second);
            }
        }
    }
    qemu_plugin_register_vcpu_tb_exec_cb(block, runs, no_registers, made.get());
    record.blocks.push_back(std::move(made));
}

std::vector<std::size_t> numbers(std::istringstream& line) {
    std::size_t count = 0;
    line >> count;
    std::vector<std::size_t> read(count);
    for (std::size_t& one : read) {
        line >> one;
    }
    return read;
}

std::size_t counter(std::istringstream& line) {
    std::size_t number = 0;
    line >> number;
    if (number >= record.counters.size()) {
        record.counters.resize(number + 1);
        record.most.resize(number + 1);
    }
    return number;
}

std::uint64_t address(std::istringstream& line) {
    std::uint64_t read = 0;
    line >> std::hex >> read >> std::dec;
    return read;
}

bool read_line(const std::string& text) {
    std::istringstream line{text};
    std::string word;
    std::size_t first = 0;
    std::size_t second = 0;
    line >> word;
    if (word == "begin" || word == "end" || word == "due") {
        record.events.emplace(address(line),
                              Event{word == "begin" ? Event::begin : (word == "end" ? Event::end : Event::due)});
    } else if (word == "kind") {
        line >> first >> second;
        record.events.emplace(address(line), Event{Event::kind, first, second});
    } else if (word == "changes") {
        line >> first >> second;
        record.events.emplace(address(line), Event{Event::changes, first, second});
    } else if (word == "at") {
        first = counter(line);
        record.events.emplace(address(line), Event{Event::count, first});
    } else if (word == "jump") {
        first = counter(line);
        const std::uint64_t source = address(line);
        record.jumps.emplace(address(line), std::pair{source, first});
    } else if (word == "limit") {
        Limit limit;
        line >> limit.kind >> limit.most >> limit.each;
        limit.sum = numbers(line);
        limit.per = numbers(line);
        limit.needs = numbers(line);
        limit.excludes = numbers(line);
        record.limits.push_back(limit);
    } else {
        return false;
    }
    return !line.fail();
}

void ends(PluginId, void*) {
    std::ofstream out{record.out};
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        out << "work " << kind << ' ' << record.works[kind] << '\n';
        for (std::size_t i = 0; i < record.most.size(); ++i) {
            out << "counter " << i << ' ' << kind << ' ' << record.most[i][kind] << '\n';
        }
    }
    for (std::size_t i = 0; i < record.limits.size(); ++i) {
        if (record.limits[i].excess != INT64_MIN) {
            out << "excess " << i << ' ' << record.limits[i].kind << ' ' << record.limits[i].excess << '\n';
        }
    }
    out.close();
    if (!out) {
        std::fprintf(stderr, "cannot write %s\n", record.out.c_str());
    }
}

}  // namespace

int qemu_plugin_install(PluginId id, const void*, int count, char** arguments) {
    std::string in;
    for (int i = 0; i < count; ++i) {
        if (std::strncmp(arguments[i], "in=", 3) == 0) {
            in = arguments[i] + 3;
        } else if (std::strncmp(arguments[i], "out=", 4) == 0) {
            record.out = arguments[i] + 4;
        }
    }
    std::ifstream file{in};
    std::string line;
    while (std::getline(file, line)) {
        if (!read_line(line)) {
            std::fprintf(stderr, "counts: %s: cannot read \"%s\"\n", in.c_str(), line.c_str());
            return 1;
        }
    }
    if (record.out.empty() || record.limits.empty()) {
        std::fprintf(stderr, "counts: in=FILE with limits, or out=FILE is missing\n");
        return 1;
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    qemu_plugin_register_atexit_cb(id, ends, nullptr);
    return 0;
}
