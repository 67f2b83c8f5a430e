// SPDX-License-Identifier: Apache-2.0
// The floor: a hand-written SDO and PDO server that does only what any server must do for the transactions of the
// benchmark (transactions.hpp). Only the benchmark uses it. It has a hash table of all entries, access rights, lengths,
// toggle bits, sequence numbers and a CRC of two bytes at a time. It has no NMT states, no limits of values and no
// time. Its instructions are counted in the same run and with the same optimisation as those of the node. The
// difference is the cost of what the node does beyond the minimum.
#pragma once

#include <array>
#include <cstring>
#include <vector>

#include "host/codegen/dictionary_rows.hpp"
#include "tests/bench/floor/floor_crc.hpp"
#include "tests/bench/server.hpp"

namespace canproof::bench {

class Floor final : public Server {
  public:
    /// Makes a floor with the entries of `rows`. `domain` is the content of the DOMAIN object `domain_index`.
    Floor(const host::DictionaryRows& rows, std::uint16_t domain_index, const std::vector<std::uint8_t>& domain)
        : values_{rows.layout.image}, constants_{rows.layout.constants}, domain_{domain}, staging_(domain.size()) {
        // room behind the last value, because every value is read as four bytes
        values_.resize(values_.size() + expedited);
        constants_.resize(constants_.size() + expedited);
        for (const ObjectRow& object : rows.objects) {
            for (std::size_t i = 0; i < object.count; ++i) {
                const EntryRow& row = rows.entries[object.first_entry + i];
                auto& pool = row.may(rights::constant) ? constants_ : values_;
                Entry entry{name_of(object.index, row.subindex), row.size, row.rights, pool.data() + row.offset};
                if (object.index == domain_index) {
                    entry.size = static_cast<std::uint32_t>(domain_.size());
                    entry.value = domain_.data();
                }
                add(entry);
            }
        }
    }

    [[gnu::noinline]] void receive(const Frame& frame) override {
        if (frame.id == request_id && frame.length == 8) {
            serve(word_of(frame.data.data()));
        } else if (frame.id == rpdo_ && frame.length >= words * 2) {
            for (std::size_t i = 0; i < words; ++i) {
                std::memcpy(words_[i].value, frame.data.data() + i * 2, 2);
            }
        }
        take_all();
    }
    [[gnu::noinline]] void pump() override {
        send_segments();
        take_all();
    }
    [[gnu::noinline]] std::size_t change(std::uint16_t index, std::uint8_t subindex) override {
        const std::uint32_t name = name_of(index, subindex);
        for (const Word& word : words_) {
            if (word.name == name) {
                Frame& frame = queue_[last_queued_++ % queue_.size()];
                frame.id = tpdo_;
                frame.length = words * 2;
                for (std::size_t i = 0; i < words; ++i) {
                    std::memcpy(frame.data.data() + i * 2, words_[i].value, 2);
                }
                break;
            }
        }
        return take_all();
    }

    void receive_words(std::uint32_t identifier) override {
        rpdo_ = identifier;
        map_words();
    }
    void send_words(std::uint32_t identifier) override {
        tpdo_ = identifier;
        map_words();
    }

  private:
    static constexpr std::uint32_t request_id = 0x605;
    static constexpr std::uint32_t response_id = 0x585;
    static constexpr std::size_t expedited = 4;
    static constexpr std::size_t words = 4;
    static constexpr std::uint32_t crowded = 0x0607'0010;  ///< abort code: the data have the wrong length
    enum class State { idle, uploading, block_downloading, block_ending, block_uploading, block_sent };

    /// An entry of the dictionary in the hash table; `name` is index and sub-index, and 0 in a free slot of the table.
    struct Entry {
        std::uint32_t name{0};
        std::uint32_t size{0};
        std::uint32_t rights{0};
        std::uint8_t* value{nullptr};
    };
    struct Word {
        std::uint32_t name{0};
        std::uint8_t* value{nullptr};
    };

    static constexpr std::uint32_t name_of(std::uint32_t index, std::uint32_t subindex) {
        return index | (subindex << 16U);  // index and sub-index as in bytes 1 to 3 of a request
    }
    static std::uint64_t word_of(const std::uint8_t* bytes) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes, sizeof(word));
        return word;
    }
    static std::size_t slot_of(std::uint32_t name) { return (name * 0x9E37'79B1U) >> 20U; }

    void add(const Entry& entry) {
        std::size_t slot = slot_of(entry.name);
        while (entries_[slot].name != 0) {
            slot = (slot + 1) % entries_.size();
        }
        entries_[slot] = entry;
    }
    Entry* find(std::uint32_t name) {
        std::size_t slot = slot_of(name);
        while (entries_[slot].name != name) {
            if (entries_[slot].name == 0) {
                return nullptr;
            }
            slot = (slot + 1) % entries_.size();
        }
        return &entries_[slot];
    }
    void map_words() {
        for (std::size_t i = 0; i < words; ++i) {
            const Entry* entry = find(name_of(0x5F02, static_cast<std::uint32_t>(i + 1)));
            words_[i] = {entry->name, entry->value};
        }
    }

    void push(std::uint64_t word) {
        Frame& frame = queue_[last_queued_++ % queue_.size()];
        frame.id = response_id;
        frame.length = 8;
        std::memcpy(frame.data.data(), &word, sizeof(word));
    }
    std::size_t take_all() {
        std::size_t count = 0;
        while (first_queued_ != last_queued_) {
            last_ = queue_[first_queued_++ % queue_.size()];
            ++count;
        }
        return count;
    }
    void answer(std::uint32_t command, std::uint64_t request, std::uint64_t data) {
        push(command | (request & 0xFFFF'FF00U) | (data << 32U));
    }
    void abort(std::uint64_t request, std::uint32_t code) {
        state_ = State::idle;
        answer(0x80, request, code);
    }

    void serve(std::uint64_t request) {
        if (state_ == State::block_downloading) {
            take_segment(request);
            return;
        }
        switch ((request >> 5U) & 7U) {
            case 1:
                download(request);
                break;
            case 2:
                upload(request);
                break;
            case 3:
                upload_segment(request);
                break;
            case 5:
                block_upload(request);
                break;
            case 6:
                block_download(request);
                break;
            default:
                abort(request, 0x0504'0001);
                break;
        }
    }
    /// Returns the entry that a request names. If the entry does not exist or lacks the right `right`, sends an SDO
    /// abort and returns null.
    Entry* allowed(std::uint64_t request, std::uint32_t right) {
        Entry* entry = find((request >> 8U) & 0xFF'FFFFU);
        if (entry == nullptr || (entry->rights & right) == 0) {
            abort(request, entry == nullptr ? 0x0602'0000 : 0x0601'0000);
            return nullptr;
        }
        return entry;
    }

    void upload(std::uint64_t request) {
        const Entry* entry = allowed(request, rights::read);
        if (entry == nullptr) {
            return;
        }
        if (entry->size <= expedited) {
            const auto unused = static_cast<std::uint32_t>(expedited - entry->size);
            std::uint32_t data = 0;
            std::memcpy(&data, entry->value, sizeof(data));
            answer(0x43U | (unused << 2U), request, data & (0xFFFF'FFFFU >> (unused * 8)));
            return;
        }
        from_ = entry->value;
        left_ = entry->size;
        toggle_ = 0;
        state_ = State::uploading;
        answer(0x41, request, entry->size);
    }
    void upload_segment(std::uint64_t request) {
        if (state_ != State::uploading || (request & 0x10U) != toggle_) {
            abort(request, 0x0503'0000);
            return;
        }
        toggle_ ^= 0x10U;
        const std::size_t count = left_ < 7 ? left_ : 7;
        std::uint64_t data = 0;
        if (count == 7) {
            std::memcpy(&data, from_, 7);
        } else {
            std::memcpy(&data, from_, count);
        }
        from_ += count;
        left_ -= count;
        push((data << 8U) | (request & 0x10U) | ((7 - count) << 1U) | (left_ == 0 ? 1U : 0U));
        state_ = left_ == 0 ? State::idle : State::uploading;
    }
    void download(std::uint64_t request) {
        const Entry* entry = allowed(request, rights::write);
        if (entry == nullptr) {
            return;
        }
        const std::uint32_t size = 4U - ((request >> 2U) & 3U);
        if (size != entry->size) {
            abort(request, crowded);
            return;
        }
        const std::uint64_t data = request >> 32U;
        switch (size) {
            case 1:
                std::memcpy(entry->value, &data, 1);
                break;
            case 2:
                std::memcpy(entry->value, &data, 2);
                break;
            default:
                std::memcpy(entry->value, &data, size);
                break;
        }
        answer(0x60, request, 0);
    }

    void block_download(std::uint64_t request) {
        if ((request & 1U) != 0) {
            end_block_download(request);
            return;
        }
        target_ = allowed(request, rights::write);
        if (target_ == nullptr) {
            return;
        }
        capacity_ = target_->size;
        size_ = 0;
        sequence_ = 0;
        crc_.start();
        state_ = State::block_downloading;
        answer(0xA4, request, 127);
    }
    void take_segment(std::uint64_t request) {
        const std::uint32_t sequence = request & 0x7FU;
        const bool last = (request & 0x80U) != 0;
        if (sequence == sequence_ + 1) {
            if (size_ + 7 <= capacity_ && !last) {
                const std::uint64_t data = request >> 8U;
                std::memcpy(staging_.data() + size_, &data, 7);
                crc_.add_seven(data);
            } else {
                tail_ = request >> 8U;  // copied later: the end request says how many of the seven bytes are data
            }
            size_ += 7;
            sequence_ = sequence;
            state_ = last ? State::block_ending : state_;
        }
        if (last || sequence == 127) {
            push(0xA2U | (sequence_ << 8U) | (127U << 16U));
            sequence_ = 0;
        }
    }
    void end_block_download(std::uint64_t request) {
        const std::size_t unused = (request >> 2U) & 7U;
        const std::size_t begun = size_ - 7;
        if (state_ != State::block_ending || size_ - unused > capacity_) {
            abort(request, crowded);
            return;
        }
        std::memcpy(staging_.data() + begun, &tail_, 7 - unused);
        crc_.add(tail_, 7 - unused);
        if (crc_.value() != ((request >> 8U) & 0xFFFFU)) {
            abort(request, 0x0504'0004);
            return;
        }
        domain_.swap(staging_);
        target_->value = domain_.data();
        state_ = State::idle;
        push(0xA1);
    }
    void block_upload(std::uint64_t request) {
        const std::uint32_t sub_command = request & 3U;
        if (sub_command == 0) {
            const Entry* entry = allowed(request, rights::read);
            if (entry == nullptr) {
                return;
            }
            from_ = entry->value;
            left_ = entry->size;
            block_size_ = (request >> 32U) & 0x7FU;
            sequence_ = block_size_;
            crc_.start();
            state_ = State::block_uploading;
            answer(0xC6, request, entry->size);
        } else if (state_ == State::block_uploading && sub_command == 3) {
            sequence_ = 0;
        } else if (state_ == State::block_uploading && sub_command == 2 && ((request >> 8U) & 0xFFU) == sequence_) {
            block_size_ = (request >> 16U) & 0x7FU;
            sequence_ = 0;
            if (left_ == 0) {
                push(0xC1U | (unused_ << 2U) | (std::uint64_t{crc_.value()} << 8U));
                state_ = State::block_sent;
            }
        } else if (state_ == State::block_sent && sub_command == 1) {
            state_ = State::idle;
        } else {
            abort(request, 0x0504'0001);
        }
    }
    void send_segments() {
        while (state_ == State::block_uploading && left_ != 0 && sequence_ < block_size_) {
            ++sequence_;
            std::uint64_t data = 0;
            if (left_ > 7) {
                std::memcpy(&data, from_, 7);
                crc_.add_seven(data);
                from_ += 7;
                left_ -= 7;
                push((data << 8U) | sequence_);
            } else {
                std::memcpy(&data, from_, left_);
                crc_.add(data, left_);
                unused_ = 7 - left_;
                left_ = 0;
                push((data << 8U) | sequence_ | 0x80U);
            }
        }
    }

    std::array<Entry, 4096> entries_{};
    std::vector<std::uint8_t> values_;
    std::vector<std::uint8_t> constants_;
    std::vector<std::uint8_t> domain_;
    std::vector<std::uint8_t> staging_;
    std::array<Frame, 128> queue_{};
    std::size_t first_queued_{0};
    std::size_t last_queued_{0};
    std::array<Word, words> words_{};
    std::uint32_t rpdo_{0};
    std::uint32_t tpdo_{0};

    State state_{State::idle};
    std::uint64_t toggle_{0};
    const std::uint8_t* from_{nullptr};
    std::size_t left_{0};
    Entry* target_{nullptr};
    std::size_t capacity_{0};
    std::size_t size_{0};
    std::uint64_t tail_{0};
    std::uint64_t unused_{0};
    std::uint64_t sequence_{0};
    std::uint64_t block_size_{0};
    FloorCrc crc_;
};

}  // namespace canproof::bench
