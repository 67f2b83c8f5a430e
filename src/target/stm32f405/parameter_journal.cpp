// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/parameter_journal.hpp"

#include "firmware/base/crc32.hpp"
#include "firmware/base/requirement.hpp"
#include "firmware/base/sequence_number.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

namespace {

constexpr std::uint32_t blank = 0xFFFFFFFFU;
constexpr std::uint8_t blank_byte = 0xFFU;

// Header: slot 0 of a sector. Its first word marks a completed erase; the other words make the sector valid.
constexpr std::uint32_t erased_mark = 0x00000000U;
constexpr std::uint32_t journal_magic = 0x4A504F43U;  // "COPJ" in memory
constexpr std::size_t mark_at = 0U;
constexpr std::size_t magic_at = 1U;
constexpr std::size_t generation_at = 2U;
constexpr std::size_t header_crc_at = 3U;

// The first word of a slot has three parts. Bits 0 to 11 are the number of the line, bits 12 to 30 are the number of
// the commit, and bit 31 marks the last slot of a commit.
constexpr std::size_t place_at = 0U;
constexpr std::size_t line_at = 1U;
constexpr std::size_t slot_crc_at = 5U;
constexpr std::uint32_t line_mask = 0xFFFU;
constexpr std::uint32_t number_shift = 12U;
constexpr std::uint32_t number_mask = 0x7FFFFU;
constexpr std::uint32_t last_of_commit = bit(31U);
constexpr std::size_t words_a_line = ParameterJournal::line_size / sizeof(std::uint32_t);

template <std::size_t N>
std::uint32_t crc_of(const std::array<std::uint32_t, N>& words, const std::size_t from,
                     const std::size_t end) noexcept {
    Crc32 crc{};
    std::array<std::uint8_t, sizeof(std::uint32_t)> bytes{};
    for (std::size_t i = from; i < end; ++i) {
        set_field_le<0U, 4U>(bytes, words[i]);
        crc.add(ByteView{bytes});
    }
    return crc.value();
}

constexpr std::uint32_t number_of(const std::uint32_t place) noexcept {
    return (place >> number_shift) & number_mask;
}

}  // namespace

Slots<Register> ParameterJournal::slot_at(const std::size_t sector, const std::size_t slot) const noexcept {
    return sectors_[sector].words.part(slot * slot_words, slot_words);
}

/// Returns whether a sector has a valid header; sets `generation` to the generation in that header.
bool ParameterJournal::is_in_use(const std::size_t sector, std::uint32_t& generation) const noexcept {
    Slot header{};
    for (std::size_t i = 0U; i < slot_words; ++i) {
        header[i] = slot_at(sector, 0U)[i].read();
    }
    generation = header[generation_at];
    return (header[mark_at] == erased_mark) && (header[magic_at] == journal_magic) &&
           (header[header_crc_at] == crc_of(header, magic_at, header_crc_at));
}

bool ParameterJournal::is_erased(const std::size_t sector) const noexcept {
    const Slots<Register> words = sectors_[sector].words;
    bool erased = words[mark_at].read() == erased_mark;
    const Slots<Register> others = words.part(magic_at, words.size());
    for (const Register& word : others) {
        erased = erased && (word.read() == blank);
    }
    return erased;
}

bool ParameterJournal::is_blank(const std::size_t sector, const std::size_t slot) const noexcept {
    bool all_blank{true};
    for (const Register& word : slot_at(sector, slot)) {
        all_blank = all_blank && (word.read() == blank);
    }
    return all_blank;
}

bool ParameterJournal::read_slot(const std::size_t slot, Slot& content) const noexcept {
    for (std::size_t i = 0U; i < slot_words; ++i) {
        content[i] = slot_at(active_, slot)[i].read();
    }
    const bool has_line = (content[place_at] & line_mask) < line_count();
    return has_line && (content[slot_crc_at] == crc_of(content, place_at, slot_crc_at));
}

static_assert(implements<req::CO_FLASH_002>);
void ParameterJournal::open() noexcept {
    active_ = no_sector;
    generation_ = 0U;
    for (std::size_t sector = 0U; sector < sector_count; ++sector) {
        std::uint32_t generation{0U};
        const bool in_use = is_in_use(sector, generation);
        if (in_use && ((active_ == no_sector) || is_newer(generation, generation_))) {
            active_ = sector;
            generation_ = generation;
        }
    }
    replay();
}

/// Fills the bytes in RAM from the complete commits in the journal.
void ParameterJournal::replay() noexcept {
    for (std::size_t at = 0U; at < bytes_.size(); ++at) {
        bytes_.set(at, blank_byte);
    }
    for (std::uint32_t& bits : changed_) {
        bits = 0U;
    }
    next_slot_ = 1U;
    if (active_ == no_sector) {
        return;
    }
    std::size_t first_of_commit{1U};
    for (std::size_t slot = 1U; slot < slots_of(active_); ++slot) {
        Slot content{};
        if (is_blank(active_, slot)) {
            continue;
        }
        next_slot_ = slot + 1U;
        const bool is_sound = read_slot(slot, content);
        if (!is_sound) {
            continue;
        }
        number_ = number_of(content[place_at]);
        if ((content[place_at] & last_of_commit) != 0U) {
            apply(first_of_commit, slot, number_);
            first_of_commit = slot + 1U;
        }
    }
}

/// Copies the lines of commit `number` from the slots `from` to `last`; slots of an interrupted commit among them are
/// skipped.
void ParameterJournal::apply(const std::size_t from, const std::size_t last, const std::uint32_t number) noexcept {
    for (std::size_t slot = from; slot <= last; ++slot) {
        Slot content{};
        if (!read_slot(slot, content) || (number_of(content[place_at]) != number)) {
            continue;
        }
        const std::size_t start = (content[place_at] & line_mask) * line_size;
        for (std::size_t word = 0U; word < words_a_line; ++word) {
            bytes_.put_le<sizeof(std::uint32_t)>(start + (word * sizeof(std::uint32_t)), content[line_at + word]);
        }
    }
}

bool ParameterJournal::prepare() noexcept {
    flash_.begin();
    bool done = is_erased(spare());
    if (!done) {
        done = erase(spare());
    }
    flash_.finish();
    return done;
}

bool ParameterJournal::erase(const std::size_t sector) noexcept {
    bool done = flash_.erase(sectors_[sector].number);
    if (done) {
        done = flash_.program(sectors_[sector].words[mark_at], erased_mark);
    }
    return done;
}

bool ParameterJournal::read(const std::size_t at, MutableBytes to) const {
    const bool is_inside = (at <= bytes_.size()) && (to.size() <= (bytes_.size() - at));
    if (is_inside) {
        to.copy(0U, bytes_.view().part(at, to.size()));
    }
    return is_inside;
}

bool ParameterJournal::write(const std::size_t at, const ByteView bytes) {
    const bool is_inside = (at <= bytes_.size()) && (bytes.size() <= (bytes_.size() - at));
    const std::size_t count = is_inside ? bytes.size() : 0U;
    for (std::size_t i = 0U; i < count; ++i) {
        if (bytes_[at + i] != std::uint32_t{bytes[i]}) {
            bytes_.set(at + i, bytes[i]);
            set_changed((at + i) / line_size, true);
        }
    }
    return is_inside;
}

static_assert(implements<req::CO_FLASH_002> && implements<req::CO_FLASH_003> && implements<req::CO_FLASH_005>);
bool ParameterJournal::commit() {
    const std::size_t count = changed_count();
    if (count == 0U) {
        return true;
    }
    number_ = (number_ + 1U) & number_mask;
    const bool has_room = (active_ != no_sector) && (count <= (slots_of(active_) - next_slot_));
    flash_.begin();
    const bool done = has_room ? append() : move();
    flash_.finish();
    if (!done) {
        open();
    }
    return done;
}

bool ParameterJournal::append() noexcept {
    return write_lines(active_, changed_count());
}

/// Starts the other sector with all lines that are not blank. Its header is written last: until then the old sector is
/// valid.
bool ParameterJournal::move() noexcept {
    const std::size_t to = spare();
    note_filled_lines();
    next_slot_ = 1U;
    bool done = is_erased(to);
    if (!done) {
        done = erase(to);
    }
    if (done) {
        done = write_lines(to, changed_count());
    }
    Slot header{};
    header[magic_at] = journal_magic;
    header[generation_at] = generation_ + 1U;
    header[header_crc_at] = crc_of(header, magic_at, header_crc_at);
    if (done) {
        done = write_words(slot_at(to, 0U), header, magic_at, header_crc_at);
    }
    if (done) {
        active_ = to;
        ++generation_;
    }
    return done;
}

/// Writes all changed lines to the next slots; `lines` is their number.
bool ParameterJournal::write_lines(const std::size_t sector, const std::size_t lines) noexcept {
    std::size_t left{lines};
    for (std::size_t line = 0U; line < line_count(); ++line) {
        if (!has_changed(line)) {
            continue;
        }
        --left;
        if (!write_slot(sector, line, left == 0U)) {
            return false;
        }
        set_changed(line, false);
    }
    return true;
}

/// Writes a slot. Its CRC, which makes it valid, is written last.
bool ParameterJournal::write_slot(const std::size_t sector, const std::size_t line, const bool is_last) noexcept {
    Slot content{};
    content[place_at] = static_cast<std::uint32_t>(line) | (number_ << number_shift) | (is_last ? last_of_commit : 0U);
    for (std::size_t word = 0U; word < words_a_line; ++word) {
        content[line_at + word] = read_u32(bytes_.view(), (line * line_size) + (word * sizeof(std::uint32_t)));
    }
    content[slot_crc_at] = crc_of(content, place_at, slot_crc_at);
    const Slots<Register> words = slot_at(sector, next_slot_);
    ++next_slot_;
    return write_words(words, content, place_at, slot_crc_at);
}

/// Programs the words `from` to `last` of a slot; the last one, a CRC, makes them valid. When an operation fails, sets
/// word `from` to 0: the CRC may be in the flash, although its operation failed, and is then wrong.
static_assert(implements<req::CO_FLASH_003>);
bool ParameterJournal::write_words(const Slots<Register>& words, const Slot& content, const std::size_t from,
                                   const std::size_t last) noexcept {
    bool done{words.size() == slot_words};
    for (std::size_t i = from; i <= last; ++i) {
        if (done) {
            done = flash_.program(words[i], content[i]);
        }
    }
    if (!done) {
        for (Register& word : words.part(from, 1U)) {
            static_cast<void>(flash_.program(word, 0U));
        }
    }
    return done;
}

void ParameterJournal::set_changed(const std::size_t line, const bool changed) noexcept {
    std::uint32_t& bits = changed_[line / 32U];
    bits = changed ? (bits | bit_of(line)) : (bits & ~bit_of(line));
}

std::size_t ParameterJournal::changed_count() const noexcept {
    std::size_t count{0U};
    for (std::size_t line = 0U; line < line_count(); ++line) {
        count += has_changed(line) ? 1U : 0U;
    }
    return count;
}

/// Marks all lines that are not blank as changed, because a new sector needs them all.
void ParameterJournal::note_filled_lines() noexcept {
    for (std::size_t at = 0U; at < bytes_.size(); ++at) {
        if (bytes_[at] != std::uint32_t{blank_byte}) {
            set_changed(at / line_size, true);
        }
    }
}

}  // namespace canproof::stm32f405
