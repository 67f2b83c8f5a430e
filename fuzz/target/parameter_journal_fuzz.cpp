// SPDX-License-Identifier: Apache-2.0
// Fuzzes the parameter journal, the flash driver and the watchdog driver of the microcontroller on models of their
// registers, with any order of stores, failing operations, worn bits, power cuts, resets and refreshes. Input: records
// of four bytes. The first record gives the sizes and the random bits of power cuts; each other one is an event.
#include <optional>
#include <utility>

#include "fuzz/support/claims.hpp"
#include "fuzz/support/stored_content.hpp"
#include "generated/canopen/requirements.hpp"
#include "target/stm32f405/parameter_journal.hpp"
#include "target/stm32f405/watchdog.hpp"
#include "tests/support/stm32f405/flash_model.hpp"
#include "tests/support/stm32f405/watchdog_model.hpp"

namespace {

using namespace canproof;
using fuzz::Image;
using fuzz::require;
using stm32f405::ParameterJournal;

constexpr std::size_t record_size = 4;
constexpr std::size_t words_a_slot = 6;
constexpr std::uint32_t most_polls = 100;  ///< of the flash driver, for one operation
constexpr std::array<std::uint32_t, 5> error_flags{1U << 1U, 1U << 4U, 1U << 5U, 1U << 6U, 1U << 7U};  // RM0090 3.9.5
/// Periods of the watchdog by the updates that do not end (bit 0: prescaler, bit 1: reload), in cycles of its
/// oscillator: 1 s, 0.125 s, 4.096 s and 0.512 s at 32 kHz (watchdog.hpp).
constexpr std::array<std::uint32_t, 4> periods{32000, 4000, 131072, 16384};
constexpr std::uint32_t erase_ms = 500;        ///< data sheet: the longest erase of 16 KiB
constexpr std::uint32_t programs_a_ms = 10;    ///< data sheet: programming takes at most 100 us
constexpr std::uint32_t slowest_khz = 17;      ///< data sheet: the watchdog's oscillator has 17 to 47 kHz
constexpr std::uint32_t oscillator_span = 31;  ///< number of frequencies, in whole kHz

/// The drivers after a reset. Their RAM contains random bytes then.
struct Unit {
    Image bytes;
    std::vector<std::uint32_t> changed;
    stm32f405::Flash flash;
    ParameterJournal journal;
    stm32f405::Watchdog watchdog;

    Unit(test::FlashModel& flash_model, test::WatchdogModel& watchdog_model, std::size_t size)
        : bytes(size, 0xA5),
          changed((size / ParameterJournal::line_size + 31) / 32, 0xA5A5A5A5U),
          flash{flash_model.registers(), most_polls},
          journal{flash, flash_model.sectors(), MutableBytes{bytes.data(), bytes.size()},
                  Slots<std::uint32_t>{changed.data(), changed.size()}},
          watchdog{watchdog_model.registers(), most_polls} {}
};

/// The counts of a flash model, before and during a commit or an erase.
struct Counts {
    std::size_t operations, failures, erases, stalled_reads;

    explicit Counts(const test::FlashModel& model)
        : operations{model.operations()},
          failures{model.failures()},
          erases{model.erases(0) + model.erases(1)},
          stalled_reads{model.stalled_reads()} {}
    Counts since(const Counts& before) const {
        Counts all = *this;
        all.operations -= before.operations;
        all.failures -= before.failures;
        all.erases -= before.erases;
        all.stalled_reads -= before.stalled_reads;
        return all;
    }
};

/// Returns a number of flash operations, mostly a small one: a commit of one line takes six.
std::size_t operations(std::uint8_t byte) {
    return byte < 192 ? byte % 16U : byte;
}

class World {
  public:
    explicit World(const std::uint8_t* shape);
    void act(const std::uint8_t* record);
    /// Repairs all that is not worn out; then the journal stores again.
    void settle();

  private:
    void act_on_hardware(const std::uint8_t* record);
    void reset(unsigned held_updates, bool during_commit);
    void write(const std::uint8_t* record);
    void read(const std::uint8_t* record);
    void commit();
    void check_committed(const Counts& all, bool moved);
    void prepare();
    bool is_too_slow(const Counts& all) const;
    void check_controller(bool ended) const;
    void wear(const std::uint8_t* record);
    void damage(std::size_t word, std::uint32_t bit);
    void refresh();
    void pass(std::uint32_t ms);
    void pass_during(const Counts& all);
    bool is_worn() { return flash_.sector(0).is_worn() || flash_.sector(1).is_worn(); }
    Image content() const;

    std::size_t size_;
    std::size_t slots_;
    test::FlashModel flash_;
    std::optional<test::WatchdogModel> watchdog_;
    std::optional<Unit> unit_;
    fuzz::StoredContent stored_;

    std::optional<std::size_t> used_slots_;  ///< of the sector in use, if no failure has left slots between the others
    std::pair<std::size_t, std::size_t> last_word_{};  ///< sector and word that the last commit has ended with
    bool prepared_{false};                             ///< the other sector is erased
    bool is_stuck_{false};                             ///< an operation does not end, or will not end
    std::uint32_t busy_reads_{3};
    unsigned held_updates_{0};
    std::uint32_t khz_{32};
    std::uint64_t cycles_{0};  ///< of the watchdog's oscillator since the last refresh
};

World::World(const std::uint8_t* shape)
    : size_{(1U + shape[0] % 16U) * ParameterJournal::line_size},
      slots_{size_ / ParameterJournal::line_size + 2U + shape[1] % 12U},
      flash_{shape[3], slots_ * words_a_slot + shape[2] % words_a_slot},
      stored_{size_, ParameterJournal::line_size} {
    reset(0, false);
}

void World::act(const std::uint8_t* record) {
    flash_.end_operation();  // the time between two events is longer than an operation
    switch (record[0] % 20) {
        case 0:
        case 1:
        case 2:
            write(record);
            break;
        case 3:
        case 4:
        case 5:
            write(record);
            commit();
            break;
        case 6:
            commit();
            break;
        case 7:
            prepare();
            break;
        case 8:
            record[1] % 2 == 0 ? damage(record[2], record[3]) : reset(record[1] % 4 == 1 ? record[2] : 0, false);
            break;
        case 9:
            read(record);
            break;
        case 10:
            pass(record[1] * (1U + record[2] % 8U));
            break;
        case 11:
            refresh();
            break;
        default:
            act_on_hardware(record);
    }
    require(content() == stored_.present(), "another content than was stored");
    require(flash_.faults().empty() && flash_.sector(0).faults().empty() && flash_.sector(1).faults().empty() &&
                watchdog_->faults().empty(),
            "a driver does what the reference manual forbids");
}

void World::act_on_hardware(const std::uint8_t* record) {
    switch (record[0] % 20) {
        case 12:
            flash_.cut_power_after(1U + operations(record[1]));
            break;
        case 13: {
            std::deque<bool> effects;
            for (unsigned i = 0; i <= record[3] % 3U; ++i) {
                effects.push_back((record[2] >> i & 1U) != 0);
            }
            flash_.fail_each_after(operations(record[1]), effects, error_flags[(record[2] >> 3U) % error_flags.size()]);
            break;
        }
        case 14:
            is_stuck_ = record[1] % 2 == 0;
            is_stuck_ ? flash_.hang_in_next_operation() : flash_.stay_busy(false);
            break;
        case 15:
            busy_reads_ = record[1] % 2 == 0 ? most_polls - 1U + record[2] % 3U : 1U + record[2];
            flash_.be_busy_for(busy_reads_);
            break;
        case 16:
            wear(record);
            break;
        case 17:
            flash_.raise(record[1] & 0xF3U);
            break;
        case 18:
            khz_ = slowest_khz + record[2] % oscillator_span;
            break;
        default:
            watchdog_->registers().key.write(record[2]);  // no key has its upper byte at 0
    }
}

/// Resets the chip, or restores its power. `during_commit`: a power cut has interrupted a commit.
void World::reset(unsigned held_updates, bool during_commit) {
    unit_.reset();
    flash_.restore_power();
    is_stuck_ = false;
    held_updates_ = held_updates % 4U;
    cycles_ = 0;
    watchdog_.emplace();
    watchdog_->hold_updates((held_updates_ & 1U) != 0, (held_updates_ & 2U) != 0);
    unit_.emplace(flash_, *watchdog_, size_);
    require(unit_->watchdog.start() == (held_updates_ == 0), "the start of the watchdog tells the wrong result");
    unit_->journal.open();
    stored_.reopen(content(), during_commit);
}

void World::write(const std::uint8_t* record) {
    const std::size_t at = record[1] % (size_ + 4U);
    const Image bytes(record[2] % 24U, record[3]);
    const bool is_inside = at + bytes.size() <= size_;
    require(unit_->journal.write(at, ByteView{bytes.data(), bytes.size()}) == is_inside, "a write beyond the end", at);
    if (is_inside) {
        stored_.write(at, bytes);
    }
}

void World::read(const std::uint8_t* record) {
    const std::size_t at = record[1] % (size_ + 4U);
    const Image before(record[2] % 24U, record[3]);
    Image bytes = before;
    const bool is_inside = at + bytes.size() <= size_;
    require(unit_->journal.read(at, MutableBytes{bytes.data(), bytes.size()}) == is_inside, "a read beyond the end");
    const auto from = stored_.present().begin() + static_cast<std::ptrdiff_t>(is_inside ? at : 0);
    require(is_inside ? std::equal(bytes.begin(), bytes.end(), from) : bytes == before, "another byte is read", at);
}

void World::commit() {
    if (stored_.changed_lines() == 0) {
        const std::size_t operations = flash_.operations();
        require(unit_->journal.commit() && flash_.operations() == operations, "a commit of nothing");
        return;
    }
    const Counts before{flash_};
    const std::uint32_t generation = unit_->journal.generation();
    const bool done = unit_->journal.commit();
    const Counts all = Counts{flash_}.since(before);
    if (!flash_.has_power()) {
        used_slots_.reset();
        prepared_ = false;
        return reset(0, true);
    }
    const bool did_not_end = is_stuck_ || is_too_slow(all);
    const bool must_fail = did_not_end || all.failures > 0;
    require(done != must_fail, "a commit tells the wrong result", all.failures);
    check_controller(!did_not_end);
    if (done) {
        require(all.stalled_reads == 0, "the flash is read before its operation has ended");
        check_committed(all, unit_->journal.generation() != generation);
    } else {
        used_slots_.reset();
        prepared_ = false;
        stored_.reopen(content(), did_not_end || all.failures > 1);
    }
    pass_during(all);
}

/// Compares the number of operations with that of the format: a slot has six words. A new sector begins with a header,
/// of which the commit writes three words and the erase the first one.
void World::check_committed(const Counts& all, bool moved) {
    const std::size_t changed = stored_.changed_lines();
    const std::size_t used = stored_.used_lines();
    const std::size_t expected = moved ? words_a_slot * used + 3 + 2 * all.erases : words_a_slot * changed;
    require(all.operations == expected, "another number of flash operations", all.operations);
    require(all.erases == 0 || (moved && !prepared_) || is_worn(), "an erase that is not necessary", all.erases);
    if (is_worn()) {
        used_slots_.reset();  // a worn slot is not blank: the journal begins behind it
    } else if (used_slots_) {
        require(moved == (changed > slots_ - *used_slots_), "the other sector is started too early or too late");
        used_slots_ = moved ? 1 + used : *used_slots_ + changed;
    } else if (moved) {
        used_slots_ = 1 + used;
    }
    prepared_ = prepared_ && !moved;
    stored_.commit(!moved);
    last_word_ = flash_.last_programmed();
}

void World::prepare() {
    const Counts before{flash_};
    const bool done = unit_->journal.prepare();
    const Counts all = Counts{flash_}.since(before);
    const bool was_prepared = std::exchange(prepared_, false);
    if (!flash_.has_power()) {
        return reset(0, false);
    }
    const bool began = all.operations > 0 || all.failures > 0;
    require(!is_stuck_ || !began || !done, "an erase that does not end is not reported");
    require(is_stuck_ || done == (all.failures == 0 && !is_too_slow(all)), "an erase tells the wrong result");
    require(all.erases <= 1, "more than one erase", all.erases);
    require(!was_prepared || is_worn() || !began, "an erased sector is erased");
    check_controller(!is_stuck_ && !is_too_slow(all));
    prepared_ = done;
    pass_during(all);
}

/// Returns whether an operation was busy for more reads of FLASH_SR than the driver makes.
bool World::is_too_slow(const Counts& all) const {
    return busy_reads_ > most_polls && (all.operations > 0 || all.failures > 0);
}

/// `ended`: the last operation has ended in time. Otherwise the flash stays unlocked.
void World::check_controller(bool ended) const {
    require(!ended || flash_.is_locked(), "the flash stays unlocked");
    require(flash_.caches_data(), "the data cache stays off");
}

/// Wears a bit out so that it keeps its present value.
void World::wear(const std::uint8_t* record) {
    test::SectorModel& sector = flash_.sector(record[1] % 2);
    const std::size_t word = record[2] % sector.cells().size();
    const std::uint32_t bit = 1U << record[3] % 32U;
    const bool is_high = (sector.cells()[word] & bit) != 0;
    sector.wear(word, is_high ? bit : 0, is_high ? 0 : bit);
    prepared_ = false;
}

/// Changes a bit in the last slot of the last commit, and resets the chip. Then the commit before it is in force.
void World::damage(std::size_t word, std::uint32_t bit) {
    if (stored_.can_fall_back()) {
        const auto [sector, last] = last_word_;
        flash_.sector(sector).cells()[last / words_a_slot * words_a_slot + word % words_a_slot] ^= 1U << bit % 32U;
        stored_.fall_back();
        reset(0, false);
    }
}

void World::refresh() {
    unit_->watchdog.refresh();
    cycles_ = 0;
}

void World::pass(std::uint32_t ms) {
    watchdog_->pass(ms, khz_);
    cycles_ += ms * khz_;
    const bool is_over = cycles_ > periods[held_updates_];
    require(watchdog_->has_bitten() == is_over, "the watchdog has another period", cycles_);
    if (is_over) {
        reset(0, false);
    }
}

/// Passes the time of flash operations, after a refresh. The watchdog must outlast them.
void World::pass_during(const Counts& all) {
    if (all.operations > 0) {
        refresh();
        const std::size_t resets_after = held_updates_ == 0 ? 680 : 0;  // ms: the shortest period (watchdog.hpp)
        const auto ms = erase_ms * all.erases + all.operations / programs_a_ms;
        require(resets_after == 0 || ms < resets_after, "a commit takes longer than the watchdog's period", ms);
        pass(static_cast<std::uint32_t>(ms));
    }
}

Image World::content() const {
    Image bytes(size_);
    require(unit_->journal.read(0, MutableBytes{bytes.data(), bytes.size()}), "the content cannot be read");
    return bytes;
}

void World::settle() {
    flash_.be_busy_for(3);
    busy_reads_ = 3;
    reset(0, false);
    const std::uint8_t stores[][record_size]{{7, 0, 0, 0}, {3, 0, 16, 0x5A}, {8, 1, 0, 0}};
    const bool can_store = !is_worn();
    for (const auto& record : stores) {
        act(record);
    }
    require(!can_store || stored_.present()[0] == 0x5A, "a store after a repair is lost");
}

}  // namespace

CANPROOF_FUZZ_CLAIMS(req::CO_FLASH_001, req::CO_FLASH_002, req::CO_FLASH_003, req::CO_FLASH_005)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < record_size) {
        return 0;
    }
    World world{data};
    for (std::size_t at = record_size; size - at >= record_size; at += record_size) {
        world.act(data + at);
    }
    world.settle();
    return 0;
}
