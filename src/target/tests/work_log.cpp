// SPDX-License-Identifier: Apache-2.0
#include "work_log.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>

#include "instruction_clock.hpp"
#include "tests/support/bus_time.hpp"

namespace canproof::target {

namespace {

/// The worst case of one kind of work. Its texts reserve their memory when the image starts, because a short text in
/// the middle of a free 64 KiB block would leave no room for a DOMAIN.
struct WorstWork {
    explicit WorstWork(const char* name) : kind{name} {
        what.reserve(32);
        where.reserve(88);
    }

    const char* kind;
    std::uint32_t count{0};
    std::uint32_t worth{0};  ///< the number whose maximum is the worst case
    std::uint32_t instructions{0};
    std::uint32_t bits{0};
    std::string what{"-"};
    std::string where{"-"};
};

enum Kind : std::size_t { power_on, frame, tick, command, first_tick, crowded_tick, due_frame, due_command, share };
std::array<WorstWork, 9> worst_works{WorstWork{"power_on"},  WorstWork{"frame"},       WorstWork{"tick"},
                                     WorstWork{"command"},   WorstWork{"first_tick"},  WorstWork{"crowded_tick"},
                                     WorstWork{"due_frame"}, WorstWork{"due_command"}, WorstWork{"share"}};

/// Returns whether a frame is a rare command. Rare commands are NMT reset node and reset communication, LSS switch
/// state global (which can reset the communication) and store configuration, and SDO writes of 1010h (store parameters)
/// and 1011h (restore defaults).
bool is_command(const std::string& text) {
    const bool resets = text.rfind("000#81", 0) == 0 || text.rfind("000#82", 0) == 0 || text.rfind("7E5#04", 0) == 0;
    const bool stores = text.rfind("7E5#17", 0) == 0;
    const bool downloads = text.size() == 20 && text[0] == '6' && (text[4] == '2' || text[4] == '3');
    const std::string index = downloads ? text.substr(6, 4) : std::string{};
    return resets || stores || index == "1010" || index == "1110";
}

/// Returns the 11 bits that arbitration compares first.
std::uint32_t base_identifier(const Frame& frame) {
    return frame.extended ? frame.id >> 18U : frame.id;
}

void note(Kind which, std::uint32_t worth, const WorstWork& one) {
    WorstWork& kind = worst_works[which];
    ++kind.count;
    if (worth > kind.worth || kind.count == 1) {
        kind.worth = worth;
        kind.instructions = one.instructions;
        kind.bits = one.bits;
        kind.what = one.what;
        kind.where = one.where;
    }
}

std::uint32_t counted = 0;
std::FILE* every_work = nullptr;

// The last work that was counted. The frames that the device sends because of this work are added until the next work
// begins.
WorstWork last{"-"};
test::Work last_work = test::Work::tick;
std::uint32_t received = 0;
bool waits = false;

void write_line(std::FILE* file, const char* kind, std::uint32_t count, const WorstWork& one) {
    std::fprintf(file, "%s %lu %lu %lu %s %s\n", kind, static_cast<unsigned long>(count),
                 static_cast<unsigned long>(one.instructions), static_cast<unsigned long>(one.bits), one.what.c_str(),
                 one.where.c_str());
}

Kind kind_of(test::Work work) {
    switch (work) {
        case test::Work::power_on:
            return power_on;
        case test::Work::tick:
            return tick;
        case test::Work::first_tick:
            return first_tick;
        case test::Work::crowded_tick:
            return crowded_tick;
        default:
            break;
    }
    if (work == test::Work::due_frame) {
        return is_command(last.what) ? due_command : due_frame;
    }
    return is_command(last.what) ? command : frame;
}

/// Records the last counted work. Called when the device sends no more frames because of this work.
void finish() {
    if (!waits) {
        return;
    }
    waits = false;
    const Kind kind = kind_of(last_work);
    if (every_work != nullptr) {
        write_line(every_work, worst_works[kind].kind, 1, last);
    }
    note(kind, last.instructions, last);
    if (kind == frame && last_work != test::Work::lone_frame) {
        constexpr std::uint32_t parts = 256;  // frames are compared in units of 1/256 instruction per bit
        note(share, last.instructions * parts / last.bits, last);
    }
}

const InstructionClock& clock() {
    static const InstructionClock one;
    return one;
}

}  // namespace

void write_every_work(const std::string& path) {
    every_work = std::fopen(path.c_str(), "wb");
    if (every_work == nullptr) {
        std::fprintf(stderr, "cannot write %s\n", path.c_str());
        std::exit(2);
    }
}

// The plugin worst_case/counts.cpp knows the two functions below by their names.

[[gnu::noinline]] void counting_begins() {
    clock().start();
}

[[gnu::noinline]] void counting_begins_at_deadline() {
    counting_begins();
}

void work_begins(test::Work work) {
    if (work == test::Work::due_frame) {
        counting_begins_at_deadline();
    } else if (work != test::Work::late_frame) {
        counting_begins();
    } else {
        // not counted
    }
}

void work_stops() {
    counted = clock().instructions();
}

void note_work(test::Work work, const std::string& what, const std::string& where) {
    finish();
    waits = true;
    last_work = work;
    last.instructions = counted;
    last.bits = 0;
    last.what = what;
    last.where = where;
}

void note_frame(test::Work work, const Frame& frame, const std::string& what, const std::string& where) {
    if (work == test::Work::late_frame) {
        finish();
        return;
    }
    note_work(work, what, where);
    last.bits = test::fewest_bits(frame);
    received = base_identifier(frame);
}

void note_answer(const Frame& frame) {
    if (waits && last.bits != 0 && base_identifier(frame) <= received) {
        last.bits += test::fewest_bits(frame);
    }
}

bool write_work(const std::string& path) {
    finish();
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    bool any = false;
    for (const WorstWork& kind : worst_works) {
        any = any || kind.count > 0;
        if (file != nullptr) {
            write_line(file, kind.kind, kind.count, kind);
        }
    }
    if (every_work != nullptr) {
        std::fclose(every_work);
    }
    return file != nullptr && std::fclose(file) == 0 && any;
}

}  // namespace canproof::target
