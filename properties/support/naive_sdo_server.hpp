// SPDX-License-Identifier: Apache-2.0
// A naive SDO server, written from CiA 301. It stores whole values and whole blocks in containers, without a limit of
// memory. Properties check that the server of the firmware gives the same answers. Shares no code with the firmware.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "properties/support/naive_sdo_objects.hpp"

namespace canproof::naive {

class Server {
  public:
    /// The present activity of the server.
    enum class Doing {
        nothing,
        download,
        upload,
        block_download,
        block_download_end,
        block_start,
        block_upload,
        block_end
    };

    explicit Server(const Objects& objects) : store_{objects} {}

    /// Restarts the server at time 0 with the initial values of all objects.
    void restart() {
        store_.restore();
        doing_ = Doing::nothing;
        now_ = 0;
        progress_ = 0;
    }

    const Objects& objects() const { return store_.objects(); }
    Doing doing() const { return doing_; }
    /// Returns how many segments of the sub-block the client has not acknowledged yet.
    std::size_t pieces_out() const { return out_; }
    std::uint8_t next_toggle() const { return toggle_; }
    /// Returns the bytes received in a download so far.
    const Bytes& received() const { return data_; }
    /// Returns the number that the next segment of a block download must have.
    std::uint8_t next_sequence() const { return static_cast<std::uint8_t>(in_order_ + 1); }

    /// Returns all answers to one request, in their order; valid until the next call.
    const std::vector<Message>& ask(const Message& request, std::uint64_t now_ms) {
        pass(now_ms);
        now_ = now_ms;
        serve(request);
        return answers_;
    }
    /// Lets time pass until `now_ms`. Returns the messages that the server sends without a request, such as the abort
    /// at a time-out.
    const std::vector<Message>& pass(std::uint64_t now_ms) {
        answers_.clear();
        if (doing_ != Doing::nothing && now_ms >= progress_ + 1000) {
            abort(0x05040000);
        }
        return answers_;
    }

  private:
    void serve(const Message& m) {
        const int specifier = m[0] / 32;
        if (doing_ == Doing::block_download) {
            block_segment(m);
        } else if (specifier == 1) {
            name(m);
            (m[0] & 2) != 0 ? expedited_download(m) : begin_download(m, (m[0] & 1) != 0, Doing::download);
        } else if (specifier == 2) {
            name(m);
            begin_upload();
        } else if (specifier == 4) {
            doing_ = Doing::nothing;
        } else if (specifier == 5 && m[0] % 4 == 0) {
            name(m);
            begin_block_upload(m);
        } else if (specifier == 6 && m[0] % 2 == 0) {
            name(m);
            begin_download(m, (m[0] & 2) != 0, Doing::block_download);
        } else if (specifier == 7) {
            name(m);
            abort(0x05040001);
        } else {
            go_on(m, specifier);
        }
    }

    void go_on(const Message& m, int specifier) {
        if (specifier == 0 && doing_ == Doing::download) {
            download_segment(m);
        } else if (specifier == 3 && doing_ == Doing::upload) {
            upload_segment(m);
        } else if (specifier == 5 && m[0] % 4 == 3 && doing_ == Doing::block_start) {
            doing_ = Doing::block_upload;
            progress_ = now_;
            send_sub_block();
        } else if (specifier == 5 && m[0] % 4 == 2 && doing_ == Doing::block_upload) {
            acknowledged(m);
        } else if (specifier == 5 && m[0] % 4 == 1 && doing_ == Doing::block_end) {
            doing_ = Doing::nothing;
        } else if (specifier == 6 && doing_ == Doing::block_download_end) {
            end_block_download(m);
        } else {
            if (doing_ == Doing::nothing) {
                index_ = 0;
                subindex_ = 0;
            }
            abort(0x05040001);
        }
    }

    // -- the object ---------------------------------------------------------------------------------------------------

    void name(const Message& m) {
        doing_ = Doing::nothing;
        index_ = static_cast<std::uint16_t>(m[1] + 256 * m[2]);
        subindex_ = m[3];
    }
    std::uint32_t find(Entry*& entry) { return store_.find(index_, subindex_, entry); }
    std::uint32_t read(Bytes& value) { return store_.read(index_, subindex_, value); }
    std::uint32_t write(const Bytes& value) { return store_.write(index_, subindex_, value); }

    // -- answers ------------------------------------------------------------------------------------------------------

    void say(Message m) { answers_.push_back(m); }
    Message with_object(int command) const {
        return {static_cast<std::uint8_t>(command),
                static_cast<std::uint8_t>(index_ % 256),
                static_cast<std::uint8_t>(index_ / 256),
                subindex_,
                0,
                0,
                0,
                0};
    }
    static void put(Message& m, std::size_t at, std::uint64_t number, std::size_t bytes) {
        for (std::size_t i = 0; i < bytes; ++i) {
            m[at + i] = static_cast<std::uint8_t>(number >> (8 * i));
        }
    }
    static std::uint32_t number_at_4(const Message& m) {
        return m[4] + 0x100U * m[5] + 0x10000U * m[6] + 0x1000000U * m[7];
    }
    void abort(std::uint32_t code) {
        doing_ = Doing::nothing;
        Message m = with_object(0x80);
        put(m, 4, code, 4);
        say(m);
    }
    bool refused(std::uint32_t code) {
        if (code != 0) {
            abort(code);
        }
        return code != 0;
    }

    // -- download -----------------------------------------------------------------------------------------------------

    void expedited_download(const Message& m) {
        std::size_t length = 4U - (m[0] / 4) % 4U;
        Entry* entry = nullptr;
        if ((m[0] & 1) == 0) {
            length = 4;
            if (find(entry) == 0 && entry->writable && entry->capacity < 4 &&
                (entry->kind != Entry::Kind::domain || entry->has_memory)) {
                length = entry->capacity;
            }
        }
        if (!refused(write(Bytes(m.begin() + 4, m.begin() + 4 + static_cast<std::ptrdiff_t>(length))))) {
            say(with_object(0x60));
        }
    }
    void begin_download(const Message& m, bool sized, Doing how) {
        Entry* entry = nullptr;
        if (refused(find(entry)) || refused(entry->writable ? 0 : 0x06010002)) {
            return;
        }
        const bool is_domain = entry->kind == Entry::Kind::domain;
        if (refused(is_domain && !entry->has_memory ? 0x05040005 : 0) ||
            refused(sized && number_at_4(m) > entry->capacity ? 0x06070012 : 0) ||
            refused(!entry->has_memory ? 0x05040005 : 0)) {
            return;
        }
        announced_ = sized ? std::optional<std::size_t>{number_at_4(m)} : std::nullopt;
        capacity_ = entry->capacity;
        data_.clear();
        toggle_ = 0;
        in_order_ = 0;
        with_crc_ = (m[0] & 4) != 0;
        doing_ = how;
        progress_ = now_;
        Message answer = with_object(how == Doing::download ? 0x60 : 0xA4);
        answer[4] = how == Doing::download ? 0 : 127;
        say(answer);
    }
    bool toggled(const Message& m) {
        if ((m[0] & 0x10) != toggle_) {
            abort(0x05030000);
            return false;
        }
        toggle_ ^= 0x10;
        return true;
    }
    void download_segment(const Message& m) {
        if (!toggled(m)) {
            return;
        }
        const std::ptrdiff_t length = 7 - (m[0] / 2) % 8;
        data_.insert(data_.end(), m.begin() + 1, m.begin() + 1 + length);
        if (refused(data_.size() > capacity_ ? 0x06070012 : 0)) {
            return;
        }
        progress_ = now_;
        if ((m[0] & 1) != 0) {
            if (refused(announced_ && *announced_ != data_.size() ? 0x06070010 : write(data_))) {
                return;
            }
            doing_ = Doing::nothing;
        }
        say({static_cast<std::uint8_t>(0x20 + (m[0] & 0x10))});
    }
    void block_segment(const Message& m) {
        if (m[0] == 0x80) {
            doing_ = Doing::nothing;
            return;
        }
        progress_ = now_;
        const int number = m[0] % 128;
        const bool last = m[0] >= 128;
        if (refused(number == 0 ? 0x05040003 : 0)) {
            return;
        }
        bool complete = false;
        if (number == in_order_ + 1) {
            if (refused(data_.size() > capacity_ ? 0x06070012 : 0)) {
                return;
            }
            data_.insert(data_.end(), m.begin() + 1, m.end());
            ++in_order_;
            complete = last;
        }
        if (last || number == 127) {
            say({0xA2, static_cast<std::uint8_t>(in_order_), 127});
            in_order_ = 0;
        }
        if (complete) {
            doing_ = Doing::block_download_end;
        }
    }
    void end_block_download(const Message& m) {
        const std::size_t unused = (m[0] / 4) % 8;
        data_.resize(data_.size() - unused);
        if (refused(data_.size() > capacity_ ? 0x06070012 : 0) ||
            refused(with_crc_ && crc16(data_) != m[1] + 256 * m[2] ? 0x05040004 : 0) ||
            refused(announced_ && *announced_ != data_.size() ? 0x06070010 : write(data_))) {
            return;
        }
        doing_ = Doing::nothing;
        say({0xA1});
    }

    // -- upload -------------------------------------------------------------------------------------------------------

    void begin_upload() {
        if (refused(read(data_))) {
            return;
        }
        if (!data_.empty() && data_.size() <= 4) {
            Message m = with_object(0x43 + 4 * (4 - static_cast<int>(data_.size())));
            std::copy(data_.begin(), data_.end(), m.begin() + 4);
            say(m);
            return;
        }
        pieces_ = pieces_of_seven(data_);
        done_ = 0;
        toggle_ = 0;
        doing_ = Doing::upload;
        progress_ = now_;
        Message m = with_object(0x41);
        put(m, 4, data_.size(), 4);
        say(m);
    }
    void upload_segment(const Message& m) {
        if (!toggled(m)) {
            return;
        }
        progress_ = now_;
        const Bytes& piece = pieces_[done_];
        ++done_;
        const bool last = done_ == pieces_.size();
        Message answer{static_cast<std::uint8_t>((m[0] & 0x10) + 2 * (7 - piece.size()) + (last ? 1 : 0))};
        std::copy(piece.begin(), piece.end(), answer.begin() + 1);
        say(answer);
        if (last) {
            doing_ = Doing::nothing;
        }
    }
    void begin_block_upload(const Message& m) {
        if (refused(read(data_)) || refused(m[4] < 1 || m[4] > 127 ? 0x05040002 : 0)) {
            return;
        }
        if (m[5] > 0 && data_.size() <= m[5]) {
            begin_upload();
            return;
        }
        pieces_ = pieces_of_seven(data_);
        done_ = 0;
        out_ = 0;
        block_size_ = m[4];
        with_crc_ = (m[0] & 4) != 0;
        doing_ = Doing::block_start;
        progress_ = now_;
        Message answer = with_object(0xC6);
        put(answer, 4, data_.size(), 4);
        say(answer);
    }
    void send_sub_block() {
        out_ = std::min<std::size_t>(block_size_, pieces_.size() - done_);
        for (std::size_t i = 0; i < out_; ++i) {
            const Bytes& piece = pieces_[done_ + i];
            const bool last = done_ + i + 1 == pieces_.size();
            Message m{static_cast<std::uint8_t>((last ? 128 : 0) + i + 1)};
            std::copy(piece.begin(), piece.end(), m.begin() + 1);
            say(m);
        }
    }
    void acknowledged(const Message& m) {
        if (refused(m[1] > out_ ? 0x05040003 : 0) || refused(m[2] < 1 || m[2] > 127 ? 0x05040002 : 0)) {
            return;
        }
        progress_ = now_;
        done_ += m[1];
        block_size_ = m[2];
        if (done_ < pieces_.size()) {
            send_sub_block();
            return;
        }
        Message end{static_cast<std::uint8_t>(0xC1 + 4 * (7 - pieces_.back().size()))};
        put(end, 1, with_crc_ ? crc16(data_) : 0, 2);
        say(end);
        doing_ = Doing::block_end;
    }

    ObjectStore store_;
    std::vector<Message> answers_;
    Doing doing_{Doing::nothing};
    std::uint64_t now_{0};
    std::uint64_t progress_{0};
    std::uint16_t index_{0};
    std::uint8_t subindex_{0};
    std::uint8_t toggle_{0};
    std::optional<std::size_t> announced_;
    std::size_t capacity_{0};
    bool with_crc_{false};
    Bytes data_;
    std::vector<Bytes> pieces_;
    std::size_t done_{0};
    std::size_t out_{0};
    std::uint8_t block_size_{0};
    int in_order_{0};
};

}  // namespace canproof::naive
