// SPDX-License-Identifier: Apache-2.0
// The layout of SDO frames (CiA 301, 7.2.4.3): command specifiers and the fields beside them.
#pragma once

#include "firmware/canopen/frame.hpp"

namespace canproof::sdo {

/// The eight bytes of a client's frame; a frame of another length is no request.
using Request = std::array<std::uint8_t, max_frame_length>;

constexpr std::size_t index_position = 1U;
constexpr std::size_t subindex_position = 3U;
constexpr std::size_t data_position = 4U;     ///< position of the data of an initiate frame or the code of an abort
constexpr std::size_t segment_capacity = 7U;  ///< number of data bytes in a segment
constexpr std::uint32_t expedited_capacity = 4U;

/// The object of an initiate or abort frame: index and sub-index at their place in the first four bytes, zero at the
/// place of the command.
struct NamedObject {
    std::uint32_t bits{0U};

    std::uint16_t index() const noexcept {
        return static_cast<std::uint16_t>((bits >> (8U * index_position)) & 0xFFFFU);
    }
    std::uint8_t subindex() const noexcept { return static_cast<std::uint8_t>(bits >> (8U * subindex_position)); }
};
inline NamedObject named_object(const Request& request) noexcept {
    return NamedObject{static_cast<std::uint32_t>(field_le<0U, 4U>(request)) & 0xFFFFFF00U};
}

/// Returns the size of a download that the client gives in its initiate frame.
inline std::uint32_t announced_size(const Request& request) noexcept {
    return static_cast<std::uint32_t>(field_le<data_position, 4U>(request));
}

/// Returns the seven bytes of `value` from byte `from` on, the first in the lowest bits; bytes after the end are zero.
inline std::uint64_t read_segment(const ByteView value, const std::size_t from) noexcept {
    constexpr std::uint64_t seven_bytes = 0x00FFFFFFFFFFFFFFU;
    return get_le<segment_capacity + 1U>(value, from) & seven_bytes;
}

/// The upper three bits of byte 0 of a request.
enum class ClientCommand : std::uint8_t {
    download_segment = 0U,
    initiate_download = 1U,
    initiate_upload = 2U,
    upload_segment = 3U,
    abort = 4U,
    block_upload = 5U,
    block_download = 6U,
    unassigned = 7U
};

/// Returns the command of a request: the upper three bits of byte 0.
inline ClientCommand command_of(const Request& request) noexcept {
    return static_cast<ClientCommand>(std::uint32_t{request[0]} >> 5U);
}

/// The lowest two bits of byte 0 in a ClientCommand::block_upload request.
enum class BlockUploadCommand : std::uint8_t { initiate = 0U, end = 1U, acknowledge = 2U, start = 3U };

// Byte 0 of the server's frames.
constexpr std::uint32_t download_segment_done = 0x20U;
constexpr std::uint32_t upload_initiated = 0x40U;
constexpr std::uint32_t download_done = 0x60U;
constexpr std::uint32_t aborted = 0x80U;
constexpr std::uint32_t block_download_initiated = 0xA0U;
constexpr std::uint32_t block_download_done = 0xA1U;
constexpr std::uint32_t block_acknowledged = 0xA2U;
constexpr std::uint32_t block_upload_initiated = 0xC0U;
constexpr std::uint32_t block_upload_ended = 0xC1U;

// Bits of byte 0.
constexpr std::uint32_t toggle_bit = 0x10U;
constexpr std::uint32_t expedited_flag = 0x02U;
constexpr std::uint32_t size_flag = 0x01U;
constexpr std::uint32_t last_segment_flag = 0x01U;
constexpr std::uint32_t block_crc_flag = 0x04U;
constexpr std::uint32_t block_size_flag = 0x02U;
constexpr std::uint32_t block_end_flag = 0x01U;  ///< in block download: end of the transfer, not its initiation
constexpr std::uint32_t block_last_segment_flag = 0x80U;

/// Returns byte 0 of the answer that contains a whole value of `size` (1…4) bytes.
constexpr std::uint32_t expedited_upload(const std::uint32_t size) noexcept {
    return (upload_initiated | expedited_flag | size_flag) + ((expedited_capacity - size) << 2U);
}

}  // namespace canproof::sdo
