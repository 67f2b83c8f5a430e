// SPDX-License-Identifier: Apache-2.0
// Feeds the socketcand server with any bytes of a client, in pieces of any size. Checks that only valid CAN frames go
// onto the bus and that memory stays bounded. The socketcand client gets the same bytes, as if a server had sent them.
// Input: pieces, each a byte with its size and then that many bytes.
#include <algorithm>
#include <string_view>

#include "fuzz/support/claims.hpp"
#include "fuzz/support/require.hpp"
#include "host/sim/bus/socketcand_client.hpp"
#include "host/sim/bus/socketcand_session.hpp"

CANPROOF_FUZZ_CLAIMS()

namespace {

using namespace canproof;
using fuzz::require;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    host::SocketcandSession session{"fuzz", 0};
    host::SocketcandClient client{"can0", [](const Frame& frame) {
                                      require(frame.length <= max_frame_length && !frame.remote);
                                      require(frame.id <= (frame.extended ? 0x1FFFFFFFU : 0x7FFU));
                                  }};
    const std::string text{data, data + size};
    Instant now{};
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = std::min<std::size_t>(data[at], text.size() - at - 1);
        now = now + milliseconds(1);
        if (session.wants_input()) {
            session.receive(std::string_view{text}.substr(at + 1, length), now);
        }
        session.advance(now);
        client.take(std::string_view{text}.substr(at + 1, length));
        require(client.held() <= host::SocketcandClient::longest_command + 1);
        client.sent(client.output().size());
        require(session.output().size() <= host::SocketcandSession::output_limit);
        // Takes a waiting frame from the gateway only after every second piece of input, so that the gateway's queue is
        // full at times.
        if (const Frame* frame = session.gateway().next_frame(); frame != nullptr && at % 2 == 0) {
            require(frame->length <= max_frame_length && frame->id <= (frame->extended ? 0x1FFFFFFFU : 0x7FFU));
            session.gateway().take_frame();
            session.gateway().receive(data_frame(0x703, 1), now);
        }
        at += length + 1;
    }
    return 0;
}
