// SPDX-License-Identifier: Apache-2.0
// Compares the SDO server with a naive server: for any requests in any order, both must give the same answers. Also
// checks properties of block transfer without a naive server. RapidCheck shrinks a failure to a short log of frames.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <fmt/format.h>
#include <rapidcheck/gtest.h>
#include <rapidcheck/state.h>

#include "generated/canopen/requirements.hpp"
#include "host/sim/bus/candump.hpp"
#include "properties/support/naive_sdo_client.hpp"
#include "properties/support/sdo_pair.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::naive {

namespace {

using test::verifies;

std::string text(const std::string& id, const Message& message) {
    std::string line = id + "#";
    for (const auto byte : message) {
        line += fmt::format("{:02X}", byte);
    }
    return line;
}

std::string text(const std::vector<Message>& messages) {
    std::string all;
    for (const auto& message : messages) {
        all += text("585", message) + " ";
    }
    return all;
}

/// The naive server, and the present time in ms.
struct Model {
    Server server{pair_model()};
    std::uint64_t now{0};
    std::uint8_t next_data{1};  ///< next data byte to send; the data bytes count up
};

using SdoCommand = rc::state::Command<Model, Ours>;

/// Sends `request` to both servers; their answers and their values of the DOMAIN must be equal.
void compare(Model& model, Ours& ours, const Message& request) {
    const auto expected = model.server.ask(request, model.now);
    const auto answered = ours.ask(request);
    if (answered != expected) {
        RC_FAIL(text("605", request) + " is answered " + text(answered) + ", by the naive server " + text(expected));
    }
    const auto& value = model.server.objects().at(pair_domain).at(0).value;
    const ByteView held = ours.device.held(pair_domain, 0);
    RC_ASSERT(Bytes(held.data(), held.data() + held.size()) == value.value_or(Bytes{}));
}

// -- requests ---------------------------------------------------------------------------------------------------------

unsigned any_of(std::initializer_list<unsigned> values) {
    return *rc::gen::elementOf(std::vector<unsigned>(values));
}

unsigned any_byte() {
    return *rc::gen::arbitrary<std::uint8_t>();
}

/// Returns a request that initiates any kind of transfer. Its object exists, or its index is near that of an existing
/// object.
Message initiate() {
    const unsigned index = any_of({0x2007, 0x2007, 0x2007, 0x2004, 0x2001, 0x2000, 0x2003, 0x1000, 0x2002, 0x2005,
                                   0x2006, 0x2008, 0x200A, 0x2009});
    const unsigned subindex = index == 0x200A ? any_of({0, 1, 2, 3, 4, 255}) : any_of({0, 0, 0, 0, 0, 0, 1});
    const unsigned command =
        any_of({0x40, 0x40, 0x20, 0x21, 0x22, 0x23, 0x27, 0x2B, 0x2F, 0xA0, 0xA4, 0xA4, 0xC0, 0xC2, 0xC4, 0xC6});
    Message m = message(command, {index % 256, index / 256, subindex});
    if (command >= 0xA0 && command < 0xC0) {
        m[4] = static_cast<std::uint8_t>(any_of({0, 1, 2, 3, 7, 100, 127, 128, 255}));
        m[5] = static_cast<std::uint8_t>(any_of({0, 0, 0, 1, 3, 40, 255}));
    } else {
        const unsigned size = any_of({0, 1, 2, 3, 4, 7, 8, 9, 14, 40, 41, 72, 100, 250, 1999, 2000, 2001, 65535});
        m[4] = static_cast<std::uint8_t>(size % 256);
        m[5] = static_cast<std::uint8_t>(size / 256);
        m[6] = static_cast<std::uint8_t>(any_of({0, 0, 0, 0, 0, 1}));
    }
    return m;
}

/// Returns a request of any eight bytes. Command bytes that control a transfer are more frequent.
Message anything() {
    const unsigned command =
        *rc::gen::oneOf(rc::gen::arbitrary<std::uint8_t>(),
                        rc::gen::element<std::uint8_t>(0x00, 0x01, 0x0F, 0x10, 0x1D, 0x60, 0x70, 0x7F, 0x80, 0x81, 0xA1,
                                                       0xA2, 0xA3, 0xC1, 0xD5, 0xDD, 0xE0, 0xFF));
    return message(command, {any_of({0, 1, 2, 126, 127, 128, 255}), any_of({0, 1, 127, 128}), any_byte(), any_byte()});
}

// -- commands ---------------------------------------------------------------------------------------------------------

/// One request.
struct Ask : SdoCommand {
    Message request{};

    explicit Ask(const Model& model) {
        std::uint8_t next = model.next_data;
        const unsigned kind = *rc::gen::inRange<unsigned>(0, 10);
        if (kind < 4) {
            request = initiate();
        } else if (kind < 8) {
            request = obedient(model.server, next, any_of({0, 1}) != 0, *rc::gen::inRange<unsigned>(0, 8));
        } else if (kind < 9) {
            request = obedient(model.server, next, false, 0);
            const auto at = *rc::gen::inRange<std::size_t>(0, 3);
            request[at] = static_cast<std::uint8_t>(any_of({0, 128, 255, request[at] + 1U, request[at] ^ 0x10U}));
        } else {
            request = anything();
        }
    }
    void apply(Model& model) const override { model.server.ask(request, model.now); }
    void run(const Model& before, Ours& ours) const override {
        Model model = before;
        compare(model, ours, request);
    }
    void show(std::ostream& os) const override { os << text("605", request); }
};

/// Sends up to 290 valid requests in a row, enough to transfer the whole DOMAIN. Some of them may be lost.
struct Stream : SdoCommand {
    unsigned count{0};
    unsigned lost_every{0};  ///< every n-th request is lost; 0: none is lost

    explicit Stream(const Model&)
        : count{*rc::gen::element<unsigned>(1, 2, 5, 6, 7, 20, 126, 127, 128, 290)},
          lost_every{*rc::gen::element<unsigned>(0, 0, 2, 3, 50)} {}

    template <typename Deliver>
    void play(Model& model, Deliver deliver) const {
        for (unsigned i = 1; i <= count; ++i) {
            const Message request = obedient(model.server, model.next_data, i == count, 3);
            const bool lost = lost_every != 0 && i % lost_every == 0;
            if (!lost) {
                deliver(model, request);
            }
        }
    }
    void apply(Model& model) const override {
        play(model, [](Model& m, const Message& request) { m.server.ask(request, m.now); });
    }
    void run(const Model& before, Ours& ours) const override {
        Model model = before;
        play(model, [&](Model& m, const Message& request) { compare(m, ours, request); });
    }
    void show(std::ostream& os) const override { os << count << " obedient requests, lost every " << lost_every; }
};

/// A pause without requests.
struct Wait : SdoCommand {
    std::uint64_t ms{0};

    explicit Wait(const Model&) : ms{*rc::gen::element<std::uint64_t>(1, 400, 600, 999, 1000, 1001, 5000)} {}
    void apply(Model& model) const override {
        model.now += ms;
        model.server.pass(model.now);
    }
    void run(const Model& before, Ours& ours) const override {
        Model model = before;
        const auto expected = model.server.pass(model.now + ms);
        const auto heard = ours.pass(ms);
        if (heard != expected) {
            RC_FAIL("silence brings " + text(heard) + ", from the naive server " + text(expected));
        }
    }
    void show(std::ostream& os) const override { os << ms << " ms"; }
};

}  // namespace

RC_GTEST_PROP(SdoModel, ServerAnswersLikeTheNaiveModel, ()) {
    verifies<req::CO_SDO_011, req::CO_SDO_015, req::CO_SDO_044, req::CO_SDO_021, req::CO_SDO_048, req::CO_SDO_022,
             req::CO_SDO_025, req::CO_SDO_049, req::CO_SDO_026, req::CO_SDO_050, req::CO_SDO_028, req::CO_SDO_051,
             req::CO_SDO_029, req::CO_SDO_052, req::CO_SDO_032, req::CO_SDO_046, req::CO_SDO_033, req::CO_SDO_047,
             req::CO_SDO_036>("property");
    Ours ours;
    rc::state::check(Model{}, ours, [](const Model& model) {
        return rc::gen::oneOf(rc::state::gen::execOneOfWithArgs<Ask>()(model),
                              rc::state::gen::execOneOfWithArgs<Ask>()(model),
                              rc::state::gen::execOneOfWithArgs<Stream, Wait>()(model));
    });
}

// -- properties that a client observes
// -------------------------------------------------------------------------------------------------

namespace {

Bytes arbitrary_value() {
    const auto size = *rc::gen::oneOf(
        rc::gen::inRange<std::size_t>(0, pair_domain_size + 1),
        rc::gen::element<std::size_t>(0, 1, 4, 5, 6, 7, 8, 14, 64, 65, 127 * 7, 127 * 7 + 1, pair_domain_size));
    Bytes value;
    std::uint32_t state = *rc::gen::arbitrary<std::uint32_t>();
    for (std::size_t i = 0; i < size; ++i) {
        state = state * 1664525U + 1013904223U;
        value.push_back(static_cast<std::uint8_t>(state >> 24));
    }
    return value;
}

Message sized(unsigned command, std::size_t size) {
    Message m = message(command, {pair_domain % 256, pair_domain / 256});
    m[4] = static_cast<std::uint8_t>(size);
    m[5] = static_cast<std::uint8_t>(size >> 8);
    return m;
}

Message segment(unsigned number, const std::vector<Bytes>& pieces, std::size_t at) {
    Message m = message(number + (at + 1 == pieces.size() ? 0x80U : 0U));
    std::copy(pieces[at].begin(), pieces[at].end(), m.begin() + 1);
    return m;
}

Message end_of(const Bytes& value, std::uint16_t crc) {
    const unsigned unused = 7U - static_cast<unsigned>(pieces_of_seven(value).back().size());
    return message(0xC1 + 4 * unused, {crc % 256U, crc / 256U});
}

/// Decides for each segment whether it is lost. The number of losses is limited, so that a transfer ends.
class Loss {
  public:
    bool now() {
        if (budget_ == 0 || *rc::gen::inRange(0, 20) != 0) {
            return false;
        }
        --budget_;
        return true;
    }

  private:
    int budget_{30};
};

/// Sends the segments of `value` until the server has received all; segments that are lost are sent again. Returns
/// false if the server aborts the transfer.
bool send_blocks(Ours& ours, const Bytes& value, Loss& loss) {
    const auto pieces = pieces_of_seven(value);
    std::size_t done = 0;
    while (done < pieces.size()) {
        const std::size_t count = std::min<std::size_t>(127, pieces.size() - done);
        std::vector<Message> answers;
        for (std::size_t i = 0; i < count; ++i) {
            const bool ends_sub_block =
                i + 1 == count;  // never lost: without the last segment the transfer would time out
            if (ends_sub_block || !loss.now()) {
                answers = ours.ask(segment(static_cast<unsigned>(i + 1), pieces, done + i));
            }
        }
        if (answers.size() != 1 || answers[0][0] != 0xA2 || answers[0][1] > count) {
            return false;
        }
        done += answers[0][1];
    }
    return true;
}

bool block_download(Ours& ours, const Bytes& value, Loss& loss) {
    return ours.ask(sized(0xC6, value.size())).at(0)[0] == 0xA4 && send_blocks(ours, value, loss) &&
           ours.ask(end_of(value, crc16(value))) == std::vector<Message>{message(0xA1)};
}

bool segmented_download(Ours& ours, const Bytes& value) {
    bool well = ours.ask(sized(0x21, value.size())).at(0)[0] == 0x60;
    const auto pieces = pieces_of_seven(value);
    for (std::size_t i = 0; i < pieces.size() && well; ++i) {
        const unsigned toggle = (i % 2) * 0x10;
        Message m = segment(0, pieces, i);
        m[0] = static_cast<std::uint8_t>(toggle + 2 * (7 - pieces[i].size()) + (i + 1 == pieces.size() ? 1 : 0));
        well = ours.ask(m) == std::vector<Message>{message(0x20 + toggle)};
    }
    return well;
}

Bytes block_upload(Ours& ours, Loss& loss) {
    const unsigned block_size = *rc::gen::element<unsigned>(1, 2, 3, 50, 127);
    Message request = message(0xA4, {pair_domain % 256, pair_domain / 256, 0, block_size});
    RC_ASSERT(ours.ask(request).at(0)[0] == 0xC6);
    Bytes value;
    auto segments = ours.ask(message(0xA3));
    while (!segments.empty() && (segments[0][0] & 0x7F) == 1) {
        unsigned taken = 0;
        for (const auto& one : segments) {
            if (!loss.now() && (one[0] & 0x7FU) == taken + 1) {
                ++taken;
                value.insert(value.end(), one.begin() + 1, one.end());
            }
        }
        segments = ours.ask(message(0xA2, {taken, *rc::gen::element<unsigned>(1, 2, 127)}));
    }
    RC_ASSERT(segments.size() == 1U);
    RC_ASSERT((segments[0][0] & 0xE3) == 0xC1);
    value.resize(value.size() - (segments[0][0] / 4) % 8);
    RC_ASSERT(segments[0][1] + 256 * segments[0][2] == crc16(value));
    RC_ASSERT(ours.ask(message(0xA1)).empty());
    return value;
}

Bytes plain_upload(Ours& ours) {
    const Message first = ours.ask(message(0x40, {pair_domain % 256, pair_domain / 256})).at(0);
    if ((first[0] & 0x02) != 0) {
        return {first.begin() + 4, first.begin() + 8 - (first[0] / 4) % 4};
    }
    Bytes value;
    for (unsigned toggle = 0;; toggle ^= 0x10) {
        const Message m = ours.ask(message(0x60 + toggle)).at(0);
        RC_ASSERT((m[0] & 0xF0) == toggle);
        value.insert(value.end(), m.begin() + 1, m.end() - (m[0] / 2) % 8);
        if ((m[0] & 1) != 0) {
            return value;
        }
    }
}

Bytes held(const Ours& ours) {
    const ByteView view = ours.device.held(pair_domain, 0);
    return {view.data(), view.data() + view.size()};
}

}  // namespace

RC_GTEST_PROP(SdoBlockLaw, DownloadedValueIsUploadedDespiteLostSegments, ()) {
    verifies<req::CO_SDO_016, req::CO_SDO_021, req::CO_SDO_048, req::CO_SDO_022, req::CO_SDO_025, req::CO_SDO_026,
             req::CO_SDO_050, req::CO_SDO_029, req::CO_SDO_052, req::CO_SDO_032, req::CO_SDO_033>("property");
    Ours ours;
    const Bytes value = arbitrary_value();
    Loss loss;
    const bool in_blocks = *rc::gen::arbitrary<bool>();
    RC_ASSERT((in_blocks ? block_download(ours, value, loss) : segmented_download(ours, value)));
    RC_ASSERT(held(ours) == value);
    RC_ASSERT(plain_upload(ours) == value);
    RC_ASSERT(block_upload(ours, loss) == value);
}

RC_GTEST_PROP(SdoBlockLaw, DownloadWithAFlippedBitIsNeverAccepted, ()) {
    verifies<req::CO_SDO_028, req::CO_SDO_047>("property");
    Ours ours;
    ours.device.fill(pair_domain, 0, {1, 2, 3});
    Bytes value = arbitrary_value();
    RC_PRE(!value.empty());
    const std::uint16_t crc = crc16(value);
    value[*rc::gen::inRange<std::size_t>(0, value.size())] ^= static_cast<std::uint8_t>(1U << *rc::gen::inRange(0, 8));
    Loss loss;
    ours.ask(sized(0xC6, value.size()));
    RC_ASSERT(send_blocks(ours, value, loss));
    RC_ASSERT(ours.ask(end_of(value, crc)) ==
              std::vector<Message>{message(0x80, {pair_domain % 256, pair_domain / 256, 0, 0x04, 0x00, 0x04, 0x05})});
    RC_ASSERT(held(ours) == (Bytes{1, 2, 3}));
}

RC_GTEST_PROP(SdoBlockLaw, InterruptedDownloadLeavesTheOldValue, ()) {
    verifies<req::CO_SDO_011, req::CO_SDO_047>("property");
    Ours ours;
    ours.device.fill(pair_domain, 0, {1, 2, 3});
    const Bytes value = arbitrary_value();
    const auto pieces = pieces_of_seven(value);
    const auto sent = *rc::gen::inRange<std::size_t>(0, pieces.size() + 1);
    ours.ask(sized(0xC6, value.size()));
    for (std::size_t i = 0; i < sent; ++i) {
        ours.ask(segment(static_cast<unsigned>(i % 127 + 1), pieces, i));
    }
    switch (*rc::gen::inRange(0, 4)) {
        case 0:
            RC_ASSERT(ours.ask(message(0x80)).empty());
            break;
        case 1:
            RC_ASSERT(ours.pass(1000).size() == 1U);  // after 1 s, the time-out, the server aborts the transfer
            break;
        case 2:
            ours.device.receive(host::parse_frame("000#8205", "property"), ours.now);
            break;
        default:
            ours.device.receive(host::parse_frame("000#0205", "property"), ours.now);
            ours.device.receive(host::parse_frame("000#8005", "property"), ours.now);
            break;
    }
    ours.answers();
    // the end request of the interrupted transfer comes too late and must not set the value
    RC_ASSERT(ours.ask(end_of(value, crc16(value))).at(0)[0] == 0x80);
    RC_ASSERT(held(ours) == (Bytes{1, 2, 3}));
}

}  // namespace canproof::naive
