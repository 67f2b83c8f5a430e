// SPDX-License-Identifier: Apache-2.0
// Runs the naive model of the AX188001 (a second, simple implementation) beside the device. Compares values of
// channels, mean and cold junction, gain and filter of the converters, all frames including the contents of TPDOs,
// 1001h (error register) and 1003h (error list).
#include "fuzz/devices/ax188001/ax188001_unit.hpp"
#include "fuzz/support/beside_model.hpp"
#include "fuzz/support/expedited_write.hpp"
#include "properties/devices/ax188001/naive_comparison.hpp"

namespace {

using namespace canproof;

constexpr unsigned node = 127;

class Model {
  public:
    static constexpr std::uint64_t longest_wait_ms = 1000;
    static constexpr unsigned further_events = 30;
    static constexpr std::uint64_t longest_run_ms = 4000;

    explicit Model(const ax188001::Device& device) : device_{device} {}

    /// Maps all values to the four TPDOs, gives the channels different limits, delays and scalings, and starts the
    /// node.
    template <typename Run>
    void begin(Run& run, fuzz::Choices& choices) {
        const std::array<std::vector<std::uint32_t>, 4> mapped{{{0x71300110, 0x71300210},
                                                                {0x21300010, 0x31300010},
                                                                {0x61000120, 0x61000220},
                                                                {0x61500108, 0x61500208, 0x50400120}}};
        constexpr std::array<unsigned, 4> event_ms{450, 1000, 330, 275};
        const auto write = [&](unsigned index, unsigned sub, unsigned size, std::uint32_t bits) {
            run.receive(fuzz::write_request(node, index, sub, size, bits));
        };
        for (unsigned i = 0; i < 4; ++i) {
            write(0x1800 + i, 1, 4, 0x80000000U | cob_id(i));
            write(0x1A00 + i, 0, 1, 0);
            for (unsigned sub = 1; sub <= mapped[i].size(); ++sub) {
                write(0x1A00 + i, sub, 4, mapped[i][sub - 1]);
            }
            write(0x1A00 + i, 0, 1, static_cast<std::uint32_t>(mapped[i].size()));
            write(0x1800 + i, 5, 2, event_ms[i]);
            write(0x1800 + i, 1, 4, cob_id(i));
        }
        for (unsigned sub = 1; sub <= 2; ++sub) {
            write(0x6110, sub, 2, choices.one_of(std::array<unsigned, 8>{1, 2, 4, 5, 6, 7, 9, 10}));
            write(0x4010, sub, 2, 300 + 300 * sub + choices.below(200));
            write(0x4020, sub, 2, 800 + 300 * sub + choices.below(200));
            write(0x4000, sub, 2, 100 * sub + choices.below(100));
            write(0x4030, sub, 2, 100 + 300 * sub);
            write(0x5051, sub, 2, 100 + 200 * sub);
            write(0x6126, sub, 4, bit_cast<std::uint32_t>(10.0F + static_cast<float>(sub)));
            write(0x6127, sub, 4, bit_cast<std::uint32_t>(100.0F * static_cast<float>(sub)));
        }
        for (unsigned sub = 1; sub <= 3; ++sub) {
            write(0x1029, sub, 1, choices.below(3));
        }
        Frame start = data_frame(0, 2);
        start.data[0] = 1;
        run.receive(start);
        may_map_ = false;
    }
    /// Returns an NMT command.
    static Frame usual_frame(unsigned, unsigned which, const std::uint8_t*) {
        constexpr std::array<std::uint8_t, 8> commands{0x01, 0x01, 0x01, 0x80, 0x02, 0x81, 0x82, 0x81};
        Frame frame = data_frame(0, 2);
        frame.data[0] = commands[which % commands.size()];
        return frame;
    }
    static const char* ends() { return nullptr; }

    static void finish(const ax188001::Device&) {}
    void power_on(const ax188001::Inputs& inputs, std::uint64_t now_ms) {
        model_.power_on(naive_tcs::terminals_of(inputs), now_ms);
    }
    void set_inputs(const ax188001::Inputs& inputs) { model_.set_terminals(naive_tcs::terminals_of(inputs)); }
    void pass(std::uint64_t ms) { model_.pass(ms); }

    /// Sets an input to a value near one of the limits that begin() has set, or near the limits of microcontroller
    /// temperature and supply (faults FD1 to FD3).
    static void put_usual_input(ax188001::Inputs& inputs, unsigned which, const std::uint8_t* data) {
        const std::size_t channel = data[2] % 2U;
        const auto number = static_cast<float>(data[0] + 256U * (data[1] % 4U));
        switch (which % 10U) {
            case 0:
                inputs.tc_open[channel] = (data[0] & 1U) != 0;
                return;
            case 1:
                inputs.cold_junction = number / 10.0F - 20.0F;
                return;
            case 2:
                inputs.cpu_temperature = 80.0F + number / 32.0F;
                return;
            case 3:
                inputs.supply = (data[2] & 2U) != 0 ? 8.5F + number / 256.0F : 47.0F + number / 256.0F;
                return;
            case 4:
                inputs.tc_hum[channel] = number * 3.0F;
                inputs.mains_frequency = (data[2] & 4U) != 0 ? 50 : 60;
                return;
            default:
                inputs.tc_microvolts[channel] = number * 10.0F - 2000.0F;
                return;
        }
    }
    static const char* unknown(const ax188001::Inputs& inputs) {
        bool usual = fuzz::is_usual(inputs.cold_junction, -60.0F, 140.0F) &&
                     fuzz::is_usual(inputs.cpu_temperature, -60.0F, 150.0F) &&
                     fuzz::is_usual(inputs.supply, 0.0F, 80.0F);
        for (std::size_t i = 0; i < 2; ++i) {
            usual = usual && fuzz::is_usual(inputs.tc_microvolts[i], -100000.0F, 100000.0F) &&
                    fuzz::is_usual(inputs.tc_hum[i], 0.0F, 5000.0F);
        }
        return !usual                                                         ? "no unit has such an input"
               : inputs.mains_frequency != 50 && inputs.mains_frequency != 60 ? "no mains have this frequency"
               : inputs.can_state > 3                                         ? "no CAN controller has this state"
                                                                              : nullptr;
    }
    const char* unknown(const Frame& frame, const ax188001::Device& device) const {
        if (frame.extended) {
            return nullptr;
        }
        if (const char* const why = fuzz::compared_elsewhere(frame)) {
            return why;
        }
        if (frame.id == 0x600U + node) {
            const auto write = fuzz::expedited_write(device.objects(), frame);
            return write ? unknown_write(*write) : "sdo_server compares other SDO requests";
        }
        return frame.id == 0 && frame.length != 2 ? "the model knows no NMT command of another length" : nullptr;
    }
    void receive(const Frame& frame) {
        if (frame.extended) {
            return;  // the device has identifiers of 11 bits only
        }
        if (frame.id == 0) {
            model_.command(frame.data[0], frame.data[1]);
        } else if (frame.id == 0x600U + node) {
            const auto write = fuzz::expedited_write(device_.objects(), frame);
            model_.write(write->index(), write->sub(), write->bits);
        }
    }

    void compare(const ax188001::Device& device, const std::vector<Frame>& said, std::uint64_t now_ms) {
        fuzz::require_frames(naive_tcs::in_order(fuzz::timed(said, now_ms)), naive_tcs::in_order(model_.take_sent()));
        naive_tcs::compare_values(
            device, model_, [](bool holds, const char* what, unsigned index) { fuzz::require(holds, what, index); });
        naive_tcs::compare_errors(
            device, model_, [](bool holds, const char* what, unsigned index) { fuzz::require(holds, what, index); });
        naive_tcs::compare_outputs(
            device, model_, [](bool holds, const char* what, unsigned index) { fuzz::require(holds, what, index); });
    }

  private:
    static constexpr std::uint32_t cob_id(unsigned i) { return 0x40000180U + 0x100U * i + node; }

    const char* unknown_write(const fuzz::ExpeditedWrite& write) const {
        const std::uint32_t bits = write.bits;
        const auto known_if = [](bool known, const char* why) { return known ? nullptr : why; };
        const unsigned index = write.index();
        if (index >= 0x2000) {
            return nullptr;
        }
        if (index >= 0x1800 && index <= 0x1803) {
            const bool is_default = write.sub() == 1 && (bits & 0x7FFFFFFFU) == cob_id(index & 3U);
            return known_if(write.sub() == 5 || is_default, "pdo compares other parameters of PDOs");
        }
        if (index >= 0x1A00 && index <= 0x1A03) {
            return known_if(may_map_, "pdo compares other mappings");
        }
        switch (write.address()) {
            case 0x100300:
                return known_if(bits == 0, "emcy compares other values in 1003h");
            case 0x101001:
                return known_if(bits == 0x65766173, "parameter_store compares other signatures");
            case 0x101101:
                return known_if(bits == 0x64616F6C, "parameter_store compares other signatures");
            case 0x102901:
            case 0x102902:
            case 0x102903:
                return nullptr;
            default:
                return "the model has no such parameter";
        }
    }

    const ax188001::Device& device_;
    naive_tcs::Ax188001 model_{[this](unsigned channel) { return naive_tcs::shown_celsius(device_, channel); }};
    bool may_map_{true};
};

[[maybe_unused]] const bool is_set = fuzz::set_beside_model(fuzz::run_beside_model<fuzz::Ax188001Unit, Model>);

}  // namespace
