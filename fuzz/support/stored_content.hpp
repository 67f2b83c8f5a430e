// SPDX-License-Identifier: Apache-2.0
// A model of a memory with commits: whole copies of the content that it must have, and the lines that the next commit
// has to store.
#pragma once

#include <algorithm>
#include <optional>
#include <set>

#include "fuzz/support/journal_memory.hpp"
#include "fuzz/support/require.hpp"

namespace canproof::fuzz {

class StoredContent {
  public:
    /// A blank memory of `size` bytes, in lines of `line_size` bytes.
    StoredContent(std::size_t size, std::size_t line_size) : present_(size, blank), line_size_{line_size} {}

    /// Returns what a read returns.
    const Image& present() const { return present_; }
    std::size_t changed_lines() const { return changed_.size(); }
    /// Returns how many lines have changed or are not blank.
    std::size_t used_lines() const {
        std::set<std::size_t> used = changed_;
        for (std::size_t at = 0; at < present_.size(); ++at) {
            if (present_[at] != blank) {
                used.insert(at / line_size_);
            }
        }
        return used.size();
    }

    /// The range must be within the memory.
    void write(std::size_t at, const Image& bytes) {
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            if (present_[at + i] != bytes[i]) {
                present_[at + i] = bytes[i];
                changed_.insert((at + i) / line_size_);
            }
        }
    }
    /// Notes a commit that has ended well. `can_fall_back`: if it is damaged, the commit before it is in force.
    void commit(bool can_fall_back) {
        before_ = can_fall_back ? std::optional{confirmed_} : std::nullopt;
        confirmed_ = present_;
        changed_.clear();
    }
    /// Notes a commit that has failed, or a start of the device, with the content after it. Requires that this is the
    /// content of the last commit. With `may_be_new`, it may also be all that was to be stored.
    void reopen(const Image& found, bool may_be_new) {
        require(found == confirmed_ || (may_be_new && found == present_), "neither the old nor the new content");
        before_.reset();
        confirmed_ = present_ = found;
        changed_.clear();
    }
    bool can_fall_back() const { return before_.has_value(); }
    /// Notes that the last commit is damaged.
    void fall_back() {
        confirmed_ = present_ = *before_;
        before_.reset();
        changed_.clear();
    }

  private:
    static constexpr std::uint8_t blank = 0xFF;

    Image present_;
    Image confirmed_{present_};
    std::optional<Image> before_;
    std::size_t line_size_;
    std::set<std::size_t> changed_;
};

}  // namespace canproof::fuzz
