// The client of the default SDO server: whole transfers, each frame of the server judged.
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
    bool switched{false};    ///< a block upload became a normal one
    std::uint32_t blocks{0};
};

enum class Transfer { automatic, expedited, segments, block };

struct BlockRead {
    std::vector<std::uint8_t> block_sizes{127};  ///< the last one holds on
    bool crc{false};
    std::uint8_t switch_size{0};               ///< pst
    std::optional<std::uint8_t> short_ack{};   ///< only so many segments of the first block are acknowledged
    std::optional<std::size_t> break_after{};  ///< segments
};

struct BlockWrite {
    bool crc{false};
    bool wrong_crc{false};
    bool without_size{false};
    std::optional<std::uint32_t> size{};  ///< other than the data have
    std::optional<unsigned> lose{};       ///< segment of the first block, from 1
    bool lose_last{false};                ///< of the first block
    std::optional<unsigned> repeat{};     ///< segment of the first block that is sent twice
    std::uint8_t padding{0};
    std::optional<std::size_t> break_after{};
};

class SdoClient {
  public:
    /// The whole exchange of a block that is broken off, or where the slave says nothing.
    static constexpr std::uint32_t timed_out = 0x05040000U;

    /// `timeout`: for each answer.
    SdoClient(Link& link, Journal& journal, std::uint8_t node_id, Duration timeout)
        : link_{link}, journal_{journal}, node_id_{node_id}, timeout_{timeout} {}

    FrameKey answer_key() const { return {0x580U + node_id_, false, false}; }
    Duration timeout() const { return timeout_; }
    /// Frames that nobody asked for fail no step.
    void allow_unasked(bool allowed) { allows_unasked_ = allowed; }

    /// Fills up with zeros to eight bytes. Throws SlaveFailed when a frame of the server came unasked for before.
    void send(const Bytes& bytes);
    /// The server's next frame; eight bytes. Throws NoAnswer and SlaveFailed.
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

/// The code of an abort frame; nothing from another frame.
std::optional<std::uint32_t> abort_code(const Bytes& answer);
/// `abort 06090011h (sub-index does not exist)`
std::string abort_words(std::uint32_t code);
/// Throws SlaveFailed when the frame is not about that object.
void want_object(const Bytes& answer, const ObjectPlace& place, const char* what);

}  // namespace canproof::host::conform
