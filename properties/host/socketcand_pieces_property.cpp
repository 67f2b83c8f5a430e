// SPDX-License-Identifier: Apache-2.0
// Checks that TCP may cut the text of a socketcand connection at any byte. Server and client must treat the pieces like
// the whole text.
#include <fmt/format.h>
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

#include "host/sim/bus/candump.hpp"
#include "host/sim/bus/socketcand_client.hpp"
#include "host/sim/bus/socketcand_session.hpp"

namespace canproof::host {

namespace {

/// Returns text that is no command: some of it contains brackets.
std::string any_noise() {
    return *rc::gen::element<std::string>("", "", "", " ", "\r\n", "x", "> ", " >> ", "frame 123 0 >");
}

/// Returns a text that a peer may send: commands of server and client, broken commands, and commands of about the
/// greatest allowed length.
std::string any_text() {
    static const std::vector<std::string> commands{"hi",
                                                   "ok",
                                                   "open can0",
                                                   "open",
                                                   "rawmode",
                                                   "bcmmode",
                                                   "controlmode",
                                                   "echo",
                                                   "send 123 2 01 02",
                                                   "send 00000123 1 5",
                                                   "send 123 2 01",
                                                   "subscribe 0 0 123",
                                                   "subscribe 0 0 00000123",
                                                   "unsubscribe 123",
                                                   "statistics 0",
                                                   "error no room",
                                                   "frame 123 1.5 0102",
                                                   "frame 00000123 1.5 AA BB",
                                                   "frame 080 0.0 ",
                                                   "",
                                                   "frame"};
    std::string text;
    for (int i = *rc::gen::inRange(0, 25); i > 0; --i) {
        const std::string command = *rc::gen::inRange(0, 20) == 0
                                        ? std::string(*rc::gen::inRange<std::size_t>(250, 262), 'x')
                                        : *rc::gen::elementOf(commands);
        text += any_noise() + "<" + *rc::gen::element<std::string>("", " ") + command + " >";
    }
    return text + any_noise() + *rc::gen::element<std::string>("", "<", "< send 12");
}

/// Returns the text in pieces: single bytes, or pieces of any length.
std::vector<std::string> any_pieces(const std::string& text) {
    const bool bytes = *rc::gen::inRange(0, 3) == 0;
    std::vector<std::string> pieces;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t size = bytes ? 1U : *rc::gen::inRange<std::size_t>(1, 40);
        pieces.push_back(text.substr(at, size));
        at += pieces.back().size();
    }
    return pieces;
}

/// The answers of a session, and its frames in their order.
struct Deeds {
    std::string said;
    std::vector<std::string> frames;
};

class Server {
  public:
    void take(const std::string& text) {
        session_.receive(text, Instant{});
        // takes one frame after the other for the bus; the session continues after each
        while (session_.gateway().next_frame() != nullptr) {
            deeds_.frames.push_back(format_frame(*session_.gateway().next_frame()));
            session_.gateway().take_frame();
            session_.receive({}, Instant{});
        }
    }
    /// Gives frames of the bus to the session. Its output shows the mode and the subscriptions of the client.
    Deeds look() {
        for (const char* const frame : {"123#05", "00000123#06", "080#"}) {
            session_.gateway().receive(parse_frame(frame, "law"), Instant{1500000});
        }
        deeds_.said = session_.output();
        return deeds_;
    }

  private:
    SocketcandSession session_{"client", 0};
    Deeds deeds_;
};

}  // namespace

RC_GTEST_PROP(SocketcandPiecesLaw, ServerBehavesTheSameWhereverTheTextOfAClientIsSplit, ()) {
    const std::string text = (*rc::gen::arbitrary<bool>() ? "< open can0 >< rawmode >" : "") + any_text();
    Server whole;
    whole.take(text);
    Server cut;
    for (const std::string& piece : any_pieces(text)) {
        cut.take(piece);
    }
    const Deeds expected = whole.look();
    const Deeds found = cut.look();
    RC_ASSERT(found.said == expected.said);
    RC_ASSERT(found.frames == expected.frames);
}

RC_GTEST_PROP(SocketcandPiecesLaw, ClientBehavesTheSameWhereverTheTextOfAServerIsSplit, ()) {
    const std::string text = (*rc::gen::arbitrary<bool>() ? "< hi >< ok >< ok >" : "") + any_text();
    std::vector<std::string> expected;
    SocketcandClient whole{"can0", [&](const Frame& frame) { expected.push_back(format_frame(frame)); }};
    whole.take(text);
    std::vector<std::string> found;
    SocketcandClient cut{"can0", [&](const Frame& frame) { found.push_back(format_frame(frame)); }};
    for (const std::string& piece : any_pieces(text)) {
        cut.take(piece);
    }
    RC_ASSERT(found == expected);
    RC_ASSERT(cut.output() == whole.output());
    RC_ASSERT(cut.complaint() == whole.complaint());
    RC_ASSERT(cut.has_joined() == whole.has_joined());
}

}  // namespace canproof::host
