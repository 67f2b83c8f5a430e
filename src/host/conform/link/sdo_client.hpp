// SPDX-License-Identifier: Apache-2.0
// The client of the default SDO server: performs whole transfers and checks each frame of the server.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/conform/language/object_reference.hpp"
#include "host/conform/link/link.hpp"
#include "host/conform/link/verdict.hpp"

namespace canproof::host::conform {

struct SdoOutcome {
    std::uint32_t abort{0};  ///< 0: done
    Bytes data;              ///< of a read
    bool switched{false};    ///< the server switched a block upload to a normal one
    std::uint32_t blocks{0};
};

enum class Transfer { automatic, expedited, segments, block };

struct BlockRead {
    std::vector<std::uint8_t> block_sizes{127};  ///< block sizes in their order; the last one is repeated
    bool crc{false};
    std::uint8_t switch_size{0};               ///< pst
    std::optional<std::uint8_t> short_ack{};   ///< only this many segments of the first block are acknowledged
    std::optional<std::size_t> break_after{};  ///< segments
};

struct BlockWrite {
    bool crc{false};
    bool wrong_crc{false};
    bool without_size{false};
    std::optional<std::uint32_t> size{};  ///< a size that differs from the data
    std::optional<unsigned> lose{};       ///< loses the last segment of the first block
    bool lose_last{false};                ///< loses the last segment of the first block
    std::optional<unsigned> repeat{};     ///< segment of the first block that is sent twice
    std::uint8_t padding{0};
    std::optional<std::size_t> break_after{};
};

class SdoClient {
  public:
    /// The abort code of an outcome without an abort frame: the client broke off, or the slave did not answer.
    static constexpr std::uint32_t timed_out = 0x05040000U;

    /// `timeout`: time-out of each answer.
    SdoClient(Link& link, Journal& journal, std::uint8_t node_id, Duration timeout)
        : link_{link}, journal_{journal}, node_id_{node_id}, timeout_{timeout} {}

    FrameKey answer_key() const { return {0x580U + node_id_, false, false}; }
    Duration timeout() const { return timeout_; }
    /// Permits unsolicited frames: they no longer fail a step.
    void allow_unasked(bool allowed) { allows_unasked_ = allowed; }

    /// Sends the bytes, padded with zeros to eight. Throws SlaveFailed when the server sent an unsolicited frame
    /// before.
    void send(const Bytes& bytes);
    /// Returns the server's next frame: eight bytes. Throws NoAnswer and SlaveFailed.
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

/// Returns the code of an abort frame; nothing for another frame.
std::optional<std::uint32_t> abort_code(const Bytes& answer);
/// Returns `abort 06090011h (sub-index does not exist)`.
std::string abort_words(std::uint32_t code);
/// Throws SlaveFailed when the frame names another object.
void want_object(const Bytes& answer, const ObjectPlace& place, const char* what);

}  // namespace canproof::host::conform
