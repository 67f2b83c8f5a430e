// SPDX-License-Identifier: Apache-2.0
// A non-volatile memory that records the order in which its bytes are written, so that a test can cut the power after
// any byte.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "firmware/base/non_volatile_memory.hpp"

namespace canproof::fuzz {

using Image = std::vector<std::uint8_t>;

class JournalMemory final : public NonVolatileMemory {
  public:
    explicit JournalMemory(Image image) : bytes_(std::move(image)) {}

    std::size_t size() const override { return bytes_.size(); }
    bool read(std::size_t at, MutableBytes to) const override {
        if (unreadable_ || at > bytes_.size() || to.size() > bytes_.size() - at) {
            return false;
        }
        for (std::size_t i = 0; i < to.size(); ++i) {
            to.set(i, bytes_[at + i]);
        }
        return true;
    }
    bool write(std::size_t at, ByteView bytes) override {
        if (at > bytes_.size() || bytes.size() > bytes_.size() - at) {
            return false;
        }
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            if (writes_left_ == 0) {
                return false;
            }
            --writes_left_;
            journal_.push_back({at + i, bytes_[at + i]});
            bytes_[at + i] = bytes[i];
        }
        return true;
    }
    bool commit() override { return true; }

    /// Makes every write fail after the next `count` bytes, as in a worn memory.
    void fail_after(std::size_t count) { writes_left_ = count; }
    void forbid_reading() { unreadable_ = true; }
    void heal() {
        writes_left_ = SIZE_MAX;
        unreadable_ = false;
    }

    /// Heals the memory if `how` is odd. Otherwise forbids reading if bit 1 of `how` is set, or makes every write fail
    /// after `count` bytes.
    void fail(unsigned how, std::size_t count) {
        if ((how & 1U) != 0) {
            heal();
        } else if ((how & 2U) != 0) {
            forbid_reading();
        } else {
            fail_after(count);
        }
    }

    /// Starts recording, so that cut_after() can undo later writes.
    void open_journal() { journal_.clear(); }
    std::size_t written() const { return journal_.size(); }
    /// Returns the content at the last call of open_journal().
    Image before_journal() const {
        Image image = bytes_;
        std::for_each(journal_.rbegin(), journal_.rend(),
                      [&image](const Write& write) { image[write.at] = write.old; });
        return image;
    }
    /// Undoes all writes after the first `count` bytes of the journal. The memory is then as after a power cut at that
    /// byte.
    void cut_after(std::size_t count) {
        while (journal_.size() > count) {
            bytes_[journal_.back().at] = journal_.back().old;
            journal_.pop_back();
        }
    }
    const Image& image() const { return bytes_; }
    /// Replaces the content without recording it.
    void replace(const Image& image) {
        bytes_ = image;
        journal_.clear();
    }

  private:
    struct Write {
        std::size_t at;
        std::uint8_t old;
    };
    Image bytes_;
    std::vector<Write> journal_;
    std::size_t writes_left_{SIZE_MAX};
    bool unreadable_{false};
};

}  // namespace canproof::fuzz
