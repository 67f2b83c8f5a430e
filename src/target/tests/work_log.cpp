#include "work_log.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>

#include "instruction_clock.hpp"

namespace canproof::target {

namespace {

/// Its texts take their memory at once: a short one in the midst of a free 64 KiB would leave no room for a DOMAIN.
struct Dearest {
    explicit Dearest(const char* name) : kind{name} {
        what.reserve(40);
        where.reserve(160);
    }

    const char* kind;
    std::uint32_t count{0};
    std::uint32_t worth{0};  ///< what it is the dearest by
    std::uint32_t instructions{0};
    std::string what{"-"};
    std::string where{"-"};
};

enum Kind : std::size_t { power_on, frame, tick, command, share };
std::array<Dearest, 5> dearest{Dearest{"power_on"}, Dearest{"frame"}, Dearest{"tick"}, Dearest{"command"},
                               Dearest{"share"}};

/// Frames that command more than a service: NMT reset node and reset communication, LSS switch state global (to
/// waiting, it resets the communication) and store configuration; SDO writes of 1010h and 1011h.
bool is_command(const std::string& text) {
    const bool resets = text.rfind("000#81", 0) == 0 || text.rfind("000#82", 0) == 0 || text.rfind("7E5#04", 0) == 0;
    const bool stores = text.rfind("7E5#17", 0) == 0;
    const bool downloads = text.size() == 20 && text[0] == '6' && text[4] == '2';
    const std::string index = downloads ? text.substr(6, 4) : std::string{};
    return resets || stores || index == "1010" || index == "1110";
}

/// Least bits that a frame takes on the bus: 44 and its data, no stuff bits, three between frames (ISO 11898-1).
std::uint32_t bits_of(const std::string& text) {
    const std::size_t data = text.size() - text.find('#') - 1;
    const bool remote = text.find('R') != std::string::npos;
    const std::size_t bits = 47 + (remote ? 0 : 4 * data) + (text.find('#') == 8 ? 20 : 0);
    return static_cast<std::uint32_t>(bits);
}

void note(Kind which, std::uint32_t worth, std::uint32_t instructions, const std::string& what,
          const std::string& where) {
    Dearest& kind = dearest[which];
    ++kind.count;
    if (worth > kind.worth || kind.count == 1) {
        kind.worth = worth;
        kind.instructions = instructions;
        kind.what = what;
        kind.where = where;
    }
}

std::uint32_t counted = 0;
std::FILE* every_work = nullptr;

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

void work_begins() {
    clock().start();
}

void work_stops() {
    counted = clock().instructions();
}

void note_work(test::Work work, const std::string& what, const std::string& where) {
    if (every_work != nullptr) {
        const Kind kind = work == test::Work::tick ? tick : (work == test::Work::power_on ? power_on : frame);
        std::fprintf(every_work, "%s %lu %s %s\n", dearest[kind].kind, static_cast<unsigned long>(counted),
                     what.c_str(), where.c_str());
    }
    if (work != test::Work::frame) {
        note(work == test::Work::tick ? tick : power_on, counted, counted, what, where);
        return;
    }
    note(is_command(what) ? command : frame, counted, counted, what, where);
    if (!is_command(what)) {
        note(share, counted / bits_of(what), counted, what, where);
    }
}

bool write_work(const std::string& path) {
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    bool any = false;
    for (const Dearest& kind : dearest) {
        any = any || kind.count > 0;
        if (file != nullptr) {
            std::fprintf(file, "%s %lu %lu %s %s\n", kind.kind, static_cast<unsigned long>(kind.count),
                         static_cast<unsigned long>(kind.instructions), kind.what.c_str(), kind.where.c_str());
        }
    }
    if (every_work != nullptr) {
        std::fclose(every_work);
    }
    return file != nullptr && std::fclose(file) == 0 && any;
}

}  // namespace canproof::target
