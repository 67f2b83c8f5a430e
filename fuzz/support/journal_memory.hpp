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
        to.copy(0, ByteView{bytes_.data() + at, to.size()});
        return true;
    }
    bool write(std::size_t at, ByteView bytes) override {
        if (at > bytes_.size() || bytes.size() > bytes_.size() - at) {
            return false;
        }
        const std::size_t count = std::min(bytes.size(), writes_left_);
        const auto place = bytes_.begin() + static_cast<std::ptrdiff_t>(at);
        journal_.push_back({at, old_bytes_.size()});
        old_bytes_.insert(old_bytes_.end(), place, place + static_cast<std::ptrdiff_t>(count));
        std::copy_n(bytes.data(), count, place);
        writes_left_ -= writes_left_ == SIZE_MAX ? 0 : count;
        return count == bytes.size();
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
    void open_journal() {
        journal_.clear();
        old_bytes_.clear();
    }
    /// Returns the number of bytes written since then.
    std::size_t written() const { return old_bytes_.size(); }
    /// Returns the content at the last call of open_journal().
    Image before_journal() const {
        Image image = bytes_;
        std::size_t end = old_bytes_.size();
        for (auto write = journal_.rbegin(); write != journal_.rend(); ++write) {
            put_back(*write, write->first, end, image);
            end = write->first;
        }
        return image;
    }
    /// Undoes all writes after the first `count` bytes of the journal. The memory is then as after a power cut at that
    /// byte.
    void cut_after(std::size_t count) {
        while (old_bytes_.size() > count) {
            const Write& last = journal_.back();
            const std::size_t kept = std::max(count, last.first);
            put_back(last, kept, old_bytes_.size(), bytes_);
            old_bytes_.resize(kept);
            if (kept == last.first) {
                journal_.pop_back();
            }
        }
    }
    const Image& image() const { return bytes_; }
    /// Replaces the content without recording it.
    void replace(const Image& image) {
        bytes_ = image;
        open_journal();
    }

  private:
    /// A write from address `at` on. The old bytes of all writes are together; those of this write begin at `first`.
    struct Write {
        std::size_t at;
        std::size_t first;
    };
    /// Puts the old bytes number `begin` to `end` back to their places.
    void put_back(const Write& write, std::size_t begin, std::size_t end, Image& image) const {
        std::copy(old_bytes_.begin() + static_cast<std::ptrdiff_t>(begin),
                  old_bytes_.begin() + static_cast<std::ptrdiff_t>(end),
                  image.begin() + static_cast<std::ptrdiff_t>(write.at + begin - write.first));
    }

    Image bytes_;
    std::vector<Write> journal_;
    Image old_bytes_;
    std::size_t writes_left_{SIZE_MAX};
    bool unreadable_{false};
};

}  // namespace canproof::fuzz
