// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/frame_readers.hpp"

#include <algorithm>

namespace canproof::host {

namespace {

constexpr std::uint32_t base_mask = 0x7FFU;
constexpr std::uint32_t extended_mask = 0x1FFFFFFFU;
constexpr std::uint32_t extended_mark = 0x80000000U;  // a bit above the 29 bits of an identifier

bool names_one(const AcceptanceFilter& filter) {
    return filter.mask == (filter.extended ? extended_mask : base_mask);
}

std::uint32_t key_of(std::uint32_t id, bool extended) {
    return extended ? id | extended_mark : id;
}

std::uint32_t key_of(const AcceptanceFilter& filter) {
    return key_of(filter.id & filter.mask, filter.extended);  // accepts() compares only the bits of the mask
}

}  // namespace

void FrameReaders::remove(std::size_t reader) {
    const auto found = filters_.find(reader);
    if (found == filters_.end()) {
        return;
    }
    for (const AcceptanceFilter& one : found->second) {
        const auto place = by_identifier_.find(key_of(one));
        if (place != by_identifier_.end()) {
            std::vector<std::size_t>& readers = place->second;
            readers.erase(std::remove(readers.begin(), readers.end(), reader), readers.end());
            if (readers.empty()) {
                by_identifier_.erase(place);
            }
        }
    }
    const auto is_its_own = [reader](const Wide& one) { return one.reader == reader; };
    wide_.erase(std::remove_if(wide_.begin(), wide_.end(), is_its_own), wide_.end());
    filters_.erase(found);
}

void FrameReaders::set(std::size_t reader, const std::vector<AcceptanceFilter>& filters) {
    const auto known = filters_.find(reader);
    if (known != filters_.end() && known->second == filters) {
        return;
    }
    remove(reader);
    if (filters.empty()) {
        return;
    }
    filters_[reader] = filters;
    for (const AcceptanceFilter& one : filters) {
        if (names_one(one)) {
            by_identifier_[key_of(one)].push_back(reader);
        } else {
            wide_.push_back({reader, one});
        }
    }
}

std::vector<std::size_t> FrameReaders::of(const Frame& frame) const {
    std::vector<std::size_t> readers;
    const auto found = by_identifier_.find(key_of(frame.id, frame.extended));
    if (found != by_identifier_.end()) {
        readers = found->second;
    }
    for (const Wide& one : wide_) {
        if (one.filter.accepts(frame)) {
            readers.push_back(one.reader);
        }
    }
    std::sort(readers.begin(), readers.end());
    readers.erase(std::unique(readers.begin(), readers.end()), readers.end());
    return readers;
}

}  // namespace canproof::host
