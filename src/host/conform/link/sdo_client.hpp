// SPDX-License-Identifier: Apache-2.0
// The client of the default SDO server. It performs complete transfers and checks each frame of the server.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/conform/language/object_reference.hpp"
#include "host/conform/link/link.hpp"
#include "host/conform/link/verdict.hpp"

namespace canproof::host::conform {

struct SdoOutcome {
    std::uint32_t abort{0};  ///< abort code; 0: the transfer was completed
    Bytes data;              ///< bytes that a read has received
    bool switched{false};    ///< whether the server switched a block upload to a normal upload
    std::uint32_t blocks{0};
};

enum class Transfer { automatic, expedited, segments, block };

struct BlockRead {
    /// requested size of each block in segments, in order; the last size applies to all further blocks
    std::vector<std::uint8_t> block_sizes{127};
    bool crc{false};
    std::uint8_t switch_size{0};  ///< protocol switch threshold (pst) of the request, in bytes
    /// number of segments of the first block that are acknowledged; without a value: all
    std::optional<std::uint8_t> short_ack{};
    /// number of segments after which the client stops; without a value, it completes the transfer
    std::optional<std::size_t> break_after{};
};

struct BlockWrite {
    bool crc{false};
    bool wrong_crc{false};
    bool without_size{false};
    std::optional<std::uint32_t> size{};  ///< announced size, if it differs from the size of the data
    std::optional<unsigned> lose{};  ///< number of the segment of the first block that is lost; without a value: none
    bool lose_last{false};           ///< whether the last segment of the first block is lost
    /// number of the segment of the first block that is sent twice; without a value: none
    std::optional<unsigned> repeat{};
    std::uint8_t padding{0};
    std::optional<std::size_t> break_after{};
};

class SdoClient {
  public:
    /// The abort code (time-out) of a transfer that ended without an abort frame: the client stopped on purpose, or the
    /// slave did not answer.
    static constexpr std::uint32_t timed_out = 0x05040000U;

    /// Makes a client. `timeout` is the longest wait for each answer.
    SdoClient(Link& link, Journal& journal, std::uint8_t node_id, Duration timeout)
        : link_{link}, journal_{journal}, node_id_{node_id}, timeout_{timeout} {}

    FrameKey answer_key() const { return {0x580U + node_id_, false, false}; }
    Duration timeout() const { return timeout_; }
    /// Sets whether the server may send frames without a request. If it may not, such a frame fails the step.
    void allow_unasked(bool allowed) { allows_unasked_ = allowed; }

    /// Sends the bytes, padded with zeros to eight. Throws SlaveFailed when an unsolicited frame of the server waits
    /// and is not allowed.
    void send(const Bytes& bytes);
    /// Returns the server's next frame, which has eight bytes, with its time. Throws NoAnswer when none comes in time,
    /// and SlaveFailed when it has another length.
    FrameRecord answer_frame(Duration within);
    /// Returns the data of answer_frame().
    Bytes answer(Duration within);
    Bytes answer() { return answer(timeout_); }

    SdoOutcome read(const ObjectPlace& place);
    SdoOutcome write(const ObjectPlace& place, const Bytes& data, Transfer transfer);
    SdoOutcome block_read(const ObjectPlace& place, const BlockRead& how);
    SdoOutcome block_write(const ObjectPlace& place, const Bytes& data, const BlockWrite& how);

  private:
    SdoOutcome read_segments(const Bytes& first);
    SdoOutcome take_upload(const ObjectPlace& place, const Bytes& first);
    SdoOutcome give_up(const ObjectPlace& place);
    SdoOutcome write_segments(const ObjectPlace& place, const Bytes& data);

    Link& link_;
    Journal& journal_;
    std::uint8_t node_id_;
    Duration timeout_;
    bool allows_unasked_{false};
};

/// Returns the abort code if the frame is an abort; otherwise returns nothing.
std::optional<std::uint32_t> abort_code(const Bytes& answer);
/// Returns an abort code as text: `abort 06090011h`.
std::string abort_words(std::uint32_t code);
/// Throws SlaveFailed when the frame names another object than `place`. `what` names the frame in the message.
void want_object(const Bytes& answer, const ObjectPlace& place, const char* what);

}  // namespace canproof::host::conform
