// SPDX-License-Identifier: Apache-2.0
// A naive (simple) LSS slave: it stores all received requests and evaluates them again for each answer.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace canproof::naive {

using Bytes = std::vector<std::uint8_t>;

// The values in 1018h (identity object) of the conformance slave.
inline const std::array<std::uint32_t, 4> address{0x0000005F, 0xAA020301, 0x00010002, 0x20261121};

inline std::string frame_text(std::uint32_t id, const Bytes& bytes) {
    std::string text = fmt::format("{:03X}#", id);
    for (const auto byte : bytes) {
        text += fmt::format("{:02X}", byte);
    }
    return text;
}

inline std::uint32_t number_in(const Bytes& bytes) {
    return bytes[1] + 0x100U * bytes[2] + 0x10000U * bytes[3] + 0x1000000U * bytes[4];
}

inline Bytes with_number(std::uint8_t specifier, std::uint32_t number) {
    return {specifier, static_cast<std::uint8_t>(number), static_cast<std::uint8_t>(number >> 8U),
            static_cast<std::uint8_t>(number >> 16U), static_cast<std::uint8_t>(number >> 24U)};
}

/// The settings that LSS configures.
struct LssSettings {
    std::uint8_t node_id{255};  ///< 1 to 127, or 255 for none
    std::uint32_t bit_rate{0};  ///< bit/s
};

/// An LSS slave as CiA 305 describes it, without limits of memory or time.
class LssSlave {
  public:
    enum class Nmt { initialising, pre_operational, operational, stopped };

    LssSlave(bool resets_itself, LssSettings kept) : resets_itself_{resets_itself} { power_on(kept); }

    std::vector<std::string> power_on(LssSettings kept) {
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
    /// Uploads 1000h (device type) from the node-ID `node`. Returns the answer, or nothing when the slave has another
    /// node-ID.
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

    LssSettings stored;
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
    /// Returns whether the last four requests of switch state selective contain the four numbers of this slave's LSS
    /// address.
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
    /// Returns whether the last six requests of identify remote slave match the LSS address of this slave.
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
    LssSettings pending_{};
    std::deque<Bytes> selecting_;
    std::deque<Bytes> identifying_;
    std::deque<Bytes> scanning_;  ///< the Fastscan requests that confirmed a number of this slave
};

}  // namespace canproof::naive
