// SPDX-License-Identifier: Apache-2.0
#include "firmware/canopen/sdo_block.hpp"

namespace canproof {

bool SdoBlockDownload::is_consistent(const MutableBytes place, const bool is_ending) const noexcept {
    return (place_.view().data() == place.view().data()) && (place_.size() == place.size()) &&
           (size_ <= (place.size() + sdo::segment_capacity)) && (in_order_ < generated::canopen::sdo_block_size) &&
           (complete_ == is_ending) && (!is_ending || (size_ >= sdo::segment_capacity));
}

bool SdoBlockUpload::is_consistent(const ByteView value) const noexcept {
    const std::size_t size = value.size();
    const std::size_t reached = base_ + (std::size_t{sent_} * sdo::segment_capacity);
    const bool is_start = (size == 0U) && (reached == 0U);
    const bool is_end =
        (reached >= size) && ((reached < (size + sdo::segment_capacity)) || (reached == sdo::segment_capacity));
    return (value_.data() == value.data()) && (value_.size() == size) && is_block_size(block_size_) &&
           (sent_ <= block_size_) && !complete_ && (base_ <= size) &&
           (last_sent_ ? ((sent_ > 0U) && is_end) : ((reached < size) || is_start));
}

}  // namespace canproof
