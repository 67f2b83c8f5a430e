// The LSS slave beside a naive one that keeps whole histories of frames and looks at them again for each answer.
#include <gtest/gtest.h>
// rapidcheck's GoogleTest support needs gtest first
#include <fmt/format.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <set>

#include "generated/canopen/requirements.hpp"
#include "tests/support/lss_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using Bytes = std::vector<std::uint8_t>;

// 1018h of the conformance slave
const std::array<std::uint32_t, 4> address{0x0000005F, 0xAA020301, 0x00010002, 0x20261121};

std::string frame_text(std::uint32_t id, const Bytes& bytes) {
    std::string text = fmt::format("{:03X}#", id);
    for (const auto byte : bytes) {
        text += fmt::format("{:02X}", byte);
    }
    return text;
}

std::uint32_t number_in(const Bytes& bytes) {
    return bytes[1] + 0x100U * bytes[2] + 0x10000U * bytes[3] + 0x1000000U * bytes[4];
}

Bytes with_number(std::uint8_t specifier, std::uint32_t number) {
    return {specifier, static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8U),
            static_cast<std::uint8_t>(number >> 16U), static_cast<std::uint8_t>(number >> 24U)};
}

/// A slave as CiA 305 tells it, without thought for memory or time.
class NaiveSlave {
  public:
    enum class Nmt { initialising, pre_operational, operational, stopped };

    NaiveSlave(bool resets_itself, LssConfiguration kept) : resets_itself_{resets_itself} { power_on(kept); }

    std::vector<std::string> power_on(LssConfiguration kept) {
        stored = kept;
        rate = kept.bit_rate;
        silent_from_ = silent_to_ = now_;
        return reset_node();
    }
    void pass(std::uint64_t ms) {
        if (is_silent() && now_ + ms >= silent_from_ + delay_) {
            rate = pending_.bit_rate;
        }
        now_ += ms;
    }
    std::vector<std::string> nmt(std::uint8_t command) {
        if (is_silent() || state_ == Nmt::initialising) {
            return {};
        }
        switch (command) {
            case 0x01:
                state_ = Nmt::operational;
                return {};
            case 0x02:
                state_ = Nmt::stopped;
                return {};
            case 0x80:
                state_ = Nmt::pre_operational;
                return {};
            case 0x81:
                return reset_node();
            default:
                return reset_communication();
        }
    }
    /// An upload of 1000h from that node.
    std::vector<std::string> read_device_type(std::uint8_t node) const {
        const bool works = state_ == Nmt::pre_operational || state_ == Nmt::operational;
        if (is_silent() || !works || node != active) {
            return {};
        }
        return {fmt::format("{:03X}#4300100078563412", 0x580 + node)};
    }
    std::vector<std::string> lss(const Bytes& request) {
        if (is_silent() || request.empty() || request.size() < shortest(request[0])) {
            return {};
        }
        const bool was_configuring = configuring_;
        const Bytes answer = answer_to(request);
        std::vector<std::string> sent;
        if (!answer.empty()) {
            Bytes padded = answer;
            padded.resize(request.size() == 8 ? 8 : answer.size());
            sent.push_back(frame_text(0x7E4, padded));
        }
        if (was_configuring && !configuring_ && (resets_itself_ || (active == 255 && pending_.node_id != 255))) {
            return reset_communication();
        }
        return sent;
    }

    LssConfiguration stored;
    std::uint32_t rate{0};
    std::uint8_t active{255};
    std::uint8_t store_result{0};
    int selections{0};
    int scans{0};

  private:
    static std::size_t shortest(std::uint8_t specifier) {
        static const std::map<std::uint8_t, std::size_t> lengths{
            {0x04, 2}, {0x11, 2}, {0x13, 3}, {0x15, 3}, {0x17, 1}, {0x40, 5}, {0x41, 5}, {0x42, 5},
            {0x43, 5}, {0x46, 5}, {0x47, 5}, {0x48, 5}, {0x49, 5}, {0x4A, 5}, {0x4B, 5}, {0x4C, 1},
            {0x51, 8}, {0x5A, 1}, {0x5B, 1}, {0x5C, 1}, {0x5D, 1}, {0x5E, 1}};
        const auto found = lengths.find(specifier);
        return found == lengths.end() ? 9 : found->second;
    }
    bool is_silent() const { return now_ < silent_to_; }

    std::vector<std::string> reset_node() {
        pending_ = stored;
        rate = stored.bit_rate;
        return reset_communication();
    }
    std::vector<std::string> reset_communication() {
        configuring_ = false;
        selecting_.clear();
        identifying_.clear();
        scanning_.clear();
        active = pending_.node_id;
        state_ = active == 255 ? Nmt::initialising : Nmt::pre_operational;
        return active == 255 ? std::vector<std::string>{}
                             : std::vector<std::string>{fmt::format("{:03X}#00", 0x700 + active)};
    }

    Bytes answer_to(const Bytes& request) {
        const std::uint8_t specifier = request[0];
        if (specifier == 0x04) {
            if (request[1] <= 1) {
                configuring_ = request[1] == 1;
            }
            return {};
        }
        if (specifier == 0x4C) {
            return is_new() ? Bytes{0x50} : Bytes{};
        }
        if (specifier >= 0x46 && specifier <= 0x4B) {
            identifying_.push_back(request);
            return specifier == 0x4B && is_identified() ? Bytes{0x4F} : Bytes{};
        }
        return configuring_ ? configuration_answer(request) : waiting_answer(request);
    }
    Bytes waiting_answer(const Bytes& request) {
        if (request[0] >= 0x40 && request[0] <= 0x43) {
            selecting_.push_back(request);
            if (request[0] == 0x43 && is_selected()) {
                configuring_ = true;
                ++selections;
                return {0x44};
            }
        }
        return request[0] == 0x51 && is_new() && scan(request) ? Bytes{0x4F} : Bytes{};
    }
    Bytes configuration_answer(const Bytes& request) {
        const std::uint8_t specifier = request[0];
        if (specifier >= 0x5A && specifier <= 0x5D) {
            return with_number(specifier, address[specifier - 0x5AU]);
        }
        if (specifier == 0x5E) {
            return {specifier, active};
        }
        if (state_ == Nmt::operational) {
            return {};
        }
        if (specifier == 0x11) {
            const bool fits = (request[1] >= 1 && request[1] <= 127) || request[1] == 255;
            pending_.node_id = fits ? request[1] : pending_.node_id;
            return {specifier, static_cast<std::uint8_t>(fits ? 0 : 1), 0};
        }
        if (specifier == 0x13) {
            const std::map<std::uint8_t, std::uint32_t> rates{{0, 1000000}, {1, resets_itself_ ? 666667U : 800000U},
                                                              {2, 500000},  {3, 250000},
                                                              {4, 125000},  {6, 50000},
                                                              {7, 20000},   {8, 10000}};
            const bool fits = request[1] == 0 && rates.count(request[2]) == 1;
            pending_.bit_rate = fits ? rates.at(request[2]) : pending_.bit_rate;
            return {specifier, static_cast<std::uint8_t>(fits ? 0 : 1), 0};
        }
        if (specifier == 0x15) {
            delay_ = request[1] + 256U * request[2];
            silent_from_ = now_;
            silent_to_ = now_ + 2 * delay_;
            rate = delay_ == 0 ? pending_.bit_rate : rate;
            return {};
        }
        if (specifier == 0x17) {
            stored = store_result == 0 ? pending_ : stored;
            return {specifier, store_result, 0};
        }
        return {};
    }

    bool is_new() const { return active == 255 && pending_.node_id == 255; }
    /// The last four frames are the four numbers of this slave.
    bool is_selected() const {
        if (selecting_.size() < 4) {
            return false;
        }
        bool all = true;
        for (std::size_t i = 0; i < 4; ++i) {
            const Bytes& frame = selecting_[selecting_.size() - 4 + i];
            all = all && frame[0] == 0x40 + i && number_in(frame) == address[i];
        }
        return all;
    }
    /// The last six frames are the numbers and bounds that this slave fits.
    bool is_identified() const {
        if (identifying_.size() < 6) {
            return false;
        }
        std::array<std::uint32_t, 6> asked{};
        for (std::size_t i = 0; i < 6; ++i) {
            const Bytes& frame = identifying_[identifying_.size() - 6 + i];
            if (frame[0] != 0x46 + i) {
                return false;
            }
            asked[i] = number_in(frame);
        }
        return asked[0] == address[0] && asked[1] == address[1] && asked[2] <= address[2] && address[2] <= asked[3] &&
               asked[4] <= address[3] && address[3] <= asked[5];
    }
    bool scan(const Bytes& request) {
        const std::uint8_t check = request[5];
        if (check == 128) {
            scanning_.clear();
            return true;
        }
        if (check > 31 || request[6] > 3 || request[7] > 3) {
            return false;
        }
        std::set<std::uint8_t> confirmed;
        std::uint8_t at = 0;
        for (const Bytes& earlier : scanning_) {
            confirmed.insert(earlier[6]);
            at = earlier[7];
        }
        if (request[6] != at) {
            return false;
        }
        for (unsigned bit = check; bit < 32; ++bit) {
            if (((number_in(request) >> bit) & 1U) != ((address[at] >> bit) & 1U)) {
                return false;
            }
        }
        if (check == 0 && request[7] != at) {
            scanning_.push_back(request);
            confirmed.insert(at);
            if (confirmed.size() == 4) {
                ++scans;
                scanning_.clear();
                configuring_ = true;
            }
        }
        return true;
    }

    bool resets_itself_;
    std::uint64_t now_{0};
    std::uint64_t silent_from_{0};
    std::uint64_t silent_to_{0};
    std::uint64_t delay_{0};
    bool configuring_{false};
    Nmt state_{Nmt::initialising};
    LssConfiguration pending_{};
    std::deque<Bytes> selecting_;
    std::deque<Bytes> identifying_;
    std::deque<Bytes> scanning_;  ///< requests that confirmed a number
};

/// One thing that happens on the bus or around the device.
struct Event {
    enum class Kind { lss, nmt, read, pass, store_result, power_cycle };
    Kind kind{Kind::lss};
    Bytes bytes;
    std::uint64_t value{0};
};

std::ostream& operator<<(std::ostream& out, const Event& event) {
    static const std::array<const char*, 6> names{"lss", "nmt", "read", "pass", "store", "power"};
    return out << names[static_cast<std::size_t>(event.kind)] << ' ' << event.value << ' '
               << frame_text(0x7E5, event.bytes);
}

using Events = std::vector<Event>;

std::uint64_t below(std::uint64_t limit) {
    return *rc::gen::inRange<std::uint64_t>(0, limit);
}
/// A number of the slave's address, or one beside it, or any.
std::uint32_t number_near(std::size_t which) {
    const std::uint64_t kind = below(10);
    return kind < 7    ? address[which]
           : kind == 7 ? address[which] + 1
           : kind == 8 ? address[which] - 1
                       : *rc::gen::arbitrary<std::uint32_t>();
}
/// Mostly of the length that CiA or the manuals use.
Event request(Bytes bytes) {
    const std::uint64_t kind = below(8);
    if (kind < 4) {
        bytes.resize(8);
    } else if (kind == 4) {
        bytes.resize(below(9));
    }
    return {Event::Kind::lss, std::move(bytes), 0};
}

Events selection() {
    Events events;
    for (std::uint8_t i = 0; i < 4; ++i) {
        events.push_back({Event::Kind::lss, with_number(static_cast<std::uint8_t>(0x40 + i), address[i]), 0});
    }
    if (below(3) == 0) {
        const std::size_t at = below(4);
        events[at] = request(with_number(static_cast<std::uint8_t>(0x40 + below(4)), number_near(at)));
    }
    return events;
}
Events identification() {
    Events events;
    for (std::uint8_t i = 0; i < 6; ++i) {
        const std::size_t which = i < 2 ? i : 2 + (i - 2U) / 2;
        const std::uint32_t slack = i < 2 ? 0U : static_cast<std::uint32_t>(below(3));
        const std::uint32_t number = i % 2 == 0 ? address[which] - slack : address[which] + slack;
        events.push_back({Event::Kind::lss, with_number(static_cast<std::uint8_t>(0x46 + i), number), 0});
    }
    if (below(3) == 0) {
        const std::size_t at = below(6);
        events[at] = request(with_number(static_cast<std::uint8_t>(0x46 + below(6)), number_near(below(4))));
    }
    return events;
}
Event scan_request(std::uint8_t which, std::uint8_t next, std::uint8_t check, std::uint32_t number) {
    Bytes bytes = with_number(0x51, number);
    bytes.insert(bytes.end(), {check, which, next});
    return {Event::Kind::lss, std::move(bytes), 0};
}
/// A walk through the numbers: complete, in another order, or with something wrong in it.
Events scan() {
    Events events;
    if (below(8) != 0) {
        events.push_back(scan_request(0, 0, 128, 0));
    }
    std::uint8_t which = 0;
    const std::uint64_t steps = 4 + below(4);
    const bool in_order = below(2) == 0;
    for (std::uint64_t i = 0; i < steps; ++i) {
        const auto next = static_cast<std::uint8_t>(in_order ? (which + 1U) % 4U : below(4));
        const auto check = static_cast<std::uint8_t>(below(12) == 0 ? below(34) : 0);
        const std::uint32_t number = below(24) == 0 ? number_near(which) : address[which];
        events.push_back(scan_request(which, next, check, number));
        which = check == 0 ? next : which;
    }
    return events;
}
Events configuration() {
    const auto byte = [](std::uint64_t value) { return static_cast<std::uint8_t>(value); };
    Events events;
    if (below(3) != 0) {
        events.push_back(request({0x04, 1}));
    }
    if (below(2) == 0) {
        events.push_back(request({0x11, byte(below(3) == 0 ? 255 : below(140))}));
    }
    if (below(2) == 0) {
        events.push_back(request({0x13, byte(below(8) == 0 ? 1 : 0), byte(below(11))}));
    }
    if (below(3) == 0) {
        events.push_back(request({0x15, byte(below(20)), 0}));
    }
    if (below(2) == 0) {
        events.push_back(request({0x17}));
    }
    events.push_back(request({byte(0x5A + below(5))}));
    if (below(3) != 0) {
        events.push_back(request({0x04, byte(below(8) == 0 ? 2 : 0)}));
    }
    return events;
}
Events single() {
    switch (below(6)) {
        case 0:
            return {{Event::Kind::nmt, {}, std::array<std::uint64_t, 5>{0x01, 0x02, 0x80, 0x81, 0x82}[below(5)]}};
        case 1:
            return {{Event::Kind::pass, {}, 1 + below(40)}};
        case 2:
            return {{Event::Kind::store_result, {}, below(3)}};
        case 3:
            return {{Event::Kind::power_cycle, {}, 0}};
        case 4:
            return {request({0x4C})};
        default:
            return {request(*rc::gen::container<Bytes>(8, rc::gen::arbitrary<std::uint8_t>()))};
    }
}
Events history() {
    Events events;
    const std::uint64_t phrases = 1 + below(14);
    for (std::uint64_t i = 0; i < phrases; ++i) {
        const std::array<Events (*)(), 6> makers{selection, identification, scan, configuration, scan, single};
        const Events phrase = makers[below(makers.size())]();
        events.insert(events.end(), phrase.begin(), phrase.end());
        events.push_back({Event::Kind::read, {}, 0});
    }
    return events;
}

/// What a start sends besides is the business of PDOs: 180h + node-ID.
Frames without_pdos(Frames frames) {
    frames.erase(std::remove_if(frames.begin(), frames.end(),
                                [](const std::string& frame) { return frame[0] == '1' || frame[0] == '2'; }),
                 frames.end());
    return frames;
}

/// The event happens to both; what they send and where they stand must agree.
void happen(const Event& event, LssBench& bench, NaiveSlave& naive) {
    switch (event.kind) {
        case Event::Kind::lss:
            RC_ASSERT(bench.send(frame_text(0x7E5, event.bytes)) == naive.lss(event.bytes));
            break;
        case Event::Kind::nmt:
            RC_ASSERT(without_pdos(bench.send(fmt::format("000#{:02X}00", event.value))) ==
                      naive.nmt(static_cast<std::uint8_t>(event.value)));
            break;
        case Event::Kind::read:
            for (const std::uint8_t node : {std::uint8_t{5}, naive.active}) {
                RC_ASSERT(bench.send(fmt::format("{:03X}#4000100000000000", 0x600 + node)) ==
                          naive.read_device_type(node));
            }
            RC_ASSERT(bench.send("7E5#5E") == naive.lss({0x5E}));
            break;
        case Event::Kind::pass:
            RC_ASSERT(bench.pass(event.value).empty());
            naive.pass(event.value);
            break;
        case Event::Kind::store_result:
            bench.device->answer_store_with(std::array<LssError, 3>{LssError::none, LssError::not_supported,
                                                                    LssError::storage_failed}[event.value]);
            naive.store_result = static_cast<std::uint8_t>(event.value);
            break;
        case Event::Kind::power_cycle:
            RC_ASSERT(bench.start(bench.device->stored()) == naive.power_on(naive.stored));
            naive.store_result = 0;
            break;
    }
    RC_ASSERT(bench.bit_rate() == naive.rate);
    RC_ASSERT(bench.device->stored().node_id == naive.stored.node_id);
    RC_ASSERT(bench.device->stored().bit_rate == naive.stored.bit_rate);
    RC_ASSERT(bench.device->node().node_id() == naive.active);
}

}  // namespace

RC_GTEST_PROP(LssLaw, TheSlaveDoesWhatANaiveOneDoes, ()) {
    verifies<req::CO_LSS_001, req::CO_LSS_002, req::CO_LSS_003, req::CO_LSS_005, req::CO_LSS_006, req::CO_LSS_010,
             req::CO_LSS_011, req::CO_LSS_012, req::CO_LSS_013, req::CO_LSS_014, req::CO_LSS_015, req::CO_LSS_016,
             req::CO_LSS_017, req::CO_LSS_018, req::CO_LSS_031, req::CO_LSS_040, req::CO_LSS_041, req::CO_LSS_042,
             req::CO_LSS_043, req::CO_LSS_044, req::CO_LSS_050, req::CO_LSS_051, req::CO_LSS_052, req::CO_LSS_053,
             req::CO_LSS_054, req::CO_LSS_055, req::CO_LSS_060, req::CO_LSS_061, req::CO_LSS_062, req::CO_LSS_063>(
        "property");
    const bool resets_itself = *rc::gen::arbitrary<bool>();
    const LssConfiguration first{static_cast<std::uint8_t>(below(3) == 0 ? 5 : 255), 125000};
    LssBench bench;
    bench.resets_itself = resets_itself;
    bench.start(first);
    NaiveSlave naive{resets_itself, first};
    for (const Event& event : *rc::gen::exec(history)) {
        happen(event, bench, naive);
    }
    RC_CLASSIFY(naive.selections > 0, "selected");
    RC_CLASSIFY(naive.scans > 0, "found by Fastscan");
}

}  // namespace canproof::test
