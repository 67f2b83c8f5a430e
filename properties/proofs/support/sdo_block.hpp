// SPDX-License-Identifier: Apache-2.0
// States, cases and requests of SDO block transfer.
#pragma once

#include "properties/proofs/support/sdo.hpp"

namespace canproof::proofs {

using State = SdoServer::State;

constexpr bool offers_block = true;
constexpr SdoStates downloading{static_cast<std::size_t>(State::block_downloading), 1U};
/// the end of a block download, and all states of a block upload
constexpr SdoStates others{static_cast<std::size_t>(State::block_download_ending), 4U};
constexpr SdoStates starting{static_cast<std::size_t>(State::block_upload_starting), 1U};
constexpr SdoStates uploading{static_cast<std::size_t>(State::block_uploading), 1U};

constexpr std::size_t most = generated::canopen::sdo_block_queued;  ///< most segments queued at once

/// Returns any request of a block upload (A0h in byte 0) whose two lowest bits in byte 0 are `command`.
inline Frame block_upload_request(const sdo::BlockUploadCommand command) {
    Frame frame = any_frame();
    frame.length = max_frame_length;
    frame.data[0] =
        static_cast<std::uint8_t>((std::uint32_t{frame.data[0]} & 0x1CU) | 0xA0U | static_cast<std::uint32_t>(command));
    return frame;
}

}  // namespace canproof::proofs
