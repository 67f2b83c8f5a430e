// SPDX-License-Identifier: Apache-2.0
// Sends SDO requests of any bytes, in any order and at any times: expedited, segmented and block transfer of numbers,
// strings and DOMAINs. Compares every answer with that of a naive server. Input: records of nine bytes. The first byte
// is a time step before the request, in units of 16 ms; the other eight are the request. A record whose first byte is
// E0h or more stands for several requests of a client that follows the protocol: see `Obedient`.
#include <cstdlib>
#include <iostream>

#include "fuzz/support/claims.hpp"
#include "fuzz/support/frame_probe.hpp"
#include "fuzz/support/record_mutator.hpp"
#include "fuzz/support/replays_as.hpp"
#include "fuzz/support/require_consistent.hpp"
#include "generated/canopen/requirements.hpp"
#include "properties/support/naive_sdo_client.hpp"
#include "properties/support/sdo_pair.hpp"

namespace {

using namespace canproof;

constexpr std::size_t record_size = 9;
constexpr std::uint8_t first_obedient = 0xE0;
constexpr unsigned most_obedient = 700;  ///< most requests in one input; two transfers of the whole DOMAIN need 580

/// Many requests of a client that follows the protocol. They come from one record, so a short input can run long
/// transfers.
struct Obedient {
    unsigned count;   ///< number of requests
    bool ends;        ///< whether the last request is a segment that is marked as the last
    unsigned unused;  ///< number of bytes without data in that segment
    unsigned lost;    ///< 0: none, otherwise every n-th request is lost

    explicit Obedient(const std::uint8_t* record)
        : count{1U + record[1]}, ends{(record[2] & 1U) != 0}, unused{record[3] % 8U}, lost{record[4]} {}
};

void require(bool holds, const naive::Message& request, int line = __builtin_LINE()) {
    if (!holds) {
        std::cerr << "requirement violated at " << __FILE__ << ':' << line << " by ";
        for (const auto byte : request) {
            std::cerr << std::hex << unsigned{byte} << ' ';
        }
        std::cerr << '\n';
        std::abort();
    }
}

/// The server under test and the naive server, side by side.
class Both {
  public:
    /// Restarts both servers.
    void restart() {
        ours_.restart(fuzz::begin_input());
        naive_.restart();
        obedient_ = 0;
        now_ms_ = 0;
        next_data_ = 1;
    }

    void ask(const naive::Message& request) {
        Frame frame = data_frame(0x600U + naive::pair_node_id, 8);
        frame.data = request;
        fuzz::deliver(ours_.device, frame, ours_.now);
        fuzz::require_consistent(ours_.device);
        answers_.clear();
        ours_.answers(answers_);
        const auto& expected = naive_.ask(request, now_ms_);
        if (naive_.doing() == naive::Server::Doing::block_upload) {
            // During a block upload, one request makes the server send all segments of a block. These lines collect the
            // segments that are not sent yet. Outside a block upload, a frame that the server should not send is
            // collected in the next step, and the comparison there fails.
            ours_.pass(0, answers_);
        }
        require(answers_ == expected, request);
    }
    void pass(std::uint64_t ms) {
        now_ms_ += ms;
        answers_.clear();
        ours_.pass(ms, answers_);
        fuzz::require_consistent(ours_.device);
        require(answers_ == naive_.pass(now_ms_), naive::Message{});
    }
    /// Sends up to `wish.count` requests, until the transfer is over; starts a transfer when none is running.
    void obey(const Obedient& wish) {
        bool goes_on = true;
        for (unsigned i = 1; goes_on && i <= wish.count && obedient_ < most_obedient; ++i, ++obedient_) {
            const auto request = naive::obedient(naive_, next_data_, wish.ends && i == wish.count, wish.unused);
            if (wish.lost == 0 || i % wish.lost != 0) {
                ask(request);
            }
            goes_on = naive_.doing() != naive::Server::Doing::nothing;
        }
    }
    /// Compares the objects' values in both servers after the transfers.
    void compare_values() {
        static const naive::Bytes nothing;
        const auto& domain = naive_.objects().at(naive::pair_domain).at(0).value;
        require(equal(ours_.device.held(naive::pair_domain, 0), domain ? *domain : nothing), naive::Message{});
        for (const auto& [index, entries] : naive_.objects()) {
            for (const auto& [subindex, entry] : entries) {
                const auto found = ours_.device.objects().find(index, subindex);
                const bool in_image = entry.kind != naive::Entry::Kind::domain;
                require(found.ok(), naive::Message{});
                require(!in_image || equal(ours_.device.objects().value(found.value()), *entry.value),
                        naive::Message{});
            }
        }
    }

  private:
    static bool equal(ByteView ours, const naive::Bytes& theirs) {
        return ours.size() == theirs.size() && std::equal(theirs.begin(), theirs.end(), ours.data());
    }

    naive::Ours ours_;
    naive::Server naive_{naive::pair_model()};
    std::vector<naive::Message> answers_;  ///< answers of the server under test; kept to reuse the memory
    unsigned obedient_{0};
    std::uint64_t now_ms_{0};
    std::uint8_t next_data_{1};
};

}  // namespace

CANPROOF_FUZZ_REPLAYS_AS_PART(naive::pair_part(), "--node 5")
CANPROOF_FUZZ_CLAIMS(req::CO_SDO_015, req::CO_SDO_044, req::CO_SDO_036)
CANPROOF_FUZZ_RECORDS(record_size)

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Both both;
    fuzz::begin_checks(data, size);
    both.restart();
    for (; size >= record_size; data += record_size, size -= record_size) {
        if (data[0] >= first_obedient) {
            both.obey(Obedient{data});
            continue;
        }
        if (data[0] != 0) {
            both.pass(16U * data[0]);
        }
        naive::Message request{};
        std::copy(data + 1, data + record_size, request.begin());
        both.ask(request);
    }
    both.pass(0);
    both.compare_values();
    return 0;
}
