// SPDX-License-Identifier: Apache-2.0
// Runs the naive model of the AX130751 (a second, simple implementation) beside the device. Compares outputs and relay,
// values of all blocks, all frames including the contents of TPDOs, 1001h (error register) and 1003h (error list); at
// the end all parameters.
#include "fuzz/devices/ax130751/ax130751_unit.hpp"
#include "fuzz/support/beside_model.hpp"
#include "fuzz/support/expedited_write.hpp"
#include "host/sim/bus/candump.hpp"
#include "properties/devices/ax130751/naive_comparison.hpp"

namespace {

using namespace canproof;

constexpr unsigned node = 127;
constexpr std::uint32_t no_rtr = 0x40000000;

class Model {
  public:
    static constexpr std::uint64_t longest_wait_ms = 25;
    static constexpr unsigned further_events = 30;
    static constexpr std::uint64_t longest_run_ms = 200;

    explicit Model(const ax130751::Device& device) : device_{device} {}

    /// Connects the blocks, switches all PDOs on, monitors three heartbeats, and starts the node.
    template <typename Run>
    void begin(Run& run, fuzz::Choices& choices) {
        const auto write = [&run](unsigned index, unsigned sub, unsigned size, std::uint32_t bits) {
            run.receive(fuzz::write_request(node, index, sub, size, bits));
        };
        connect(write, choices);
        constexpr std::array<std::uint32_t, 4> mapped{0x40300110, 0x33200110, 0x33100108, 0x40300410};
        for (unsigned i = 1; i <= 4; ++i) {
            write(0x1A02, i, 4, mapped[i - 1]);
        }
        write(0x1A02, 0, 1, 4);
        for (unsigned n = 0; n < 4; ++n) {
            write(0x1800 + n, 5, 2, 5 + 2 * n);
            write(0x1800 + n, 1, 4, no_rtr + 0x180 + 0x100 * n + node);
            write(0x1400 + n, 1, 4, no_rtr + 0x200 + 0x100 * n + node);
            model_.parameters.communication.transmit[n].valid = true;
            model_.parameters.communication.receive[n].valid = true;
        }
        for (unsigned n = 0; n < 3; ++n) {
            write(0x1016, n + 1, 4, ((5 + n) << 16U) + 15 + 5 * n);
            model_.parameters.communication.heartbeat_ms[n] = static_cast<int>(15 + 5 * n);
        }
        Frame start = data_frame(0, 2);
        start.data[0] = 1;
        run.receive(start);
        is_set_up_ = true;
    }
    /// Returns an NMT command, an RPDO, or a heartbeat.
    static Frame usual_frame(unsigned, unsigned which, const std::uint8_t* data) {
        constexpr std::array<std::uint8_t, 8> commands{0x01, 0x01, 0x01, 0x01, 0x01, 0x80, 0x81, 0x82};
        constexpr std::array<std::uint8_t, 4> lengths{5, 6, 6, 2};
        Frame frame = data_frame(0, 2);
        frame.data[0] = commands[data[0] % commands.size()];
        if (which % 8U < 5U) {
            const unsigned n = which / 8U % 4U;
            frame = data_frame(0x200U + 0x100U * n + node, lengths[n]);
            std::copy_n(data, frame.length, frame.data.begin());
            for (std::size_t i = 1; i < 6; i += 2) {
                frame.data[i] = n == 3 ? frame.data[i] : frame.data[i] % 4U;  // a 16-bit value below 1024
            }
        } else if (which % 8U < 7U) {
            frame = data_frame(0x705U + which / 8U % 3U, 1);
            frame.data[0] = 5;
        }
        return frame;
    }
    static const char* ends() { return nullptr; }
    void finish(const ax130751::Device& device) const { Comparison{device, model_, check_}.parameters(); }

    void power_on(const ax130751::Inputs& inputs, std::uint64_t now_ms) {
        begun_ms_ = now_ms - model_.now;
        set_inputs(inputs);
        model_.start_up();
    }
    void set_inputs(const ax130751::Inputs& inputs) {
        model_.inputs = {inputs.supply, inputs.cpu_temperature, inputs.load};
    }
    void pass(std::uint64_t ms) {
        for (; ms > 0; --ms) {
            model_.pass();
        }
    }

    /// Sets the supply or the temperature to a value near its limits, or connects another load.
    static void put_usual_input(ax130751::Inputs& inputs, unsigned which, const std::uint8_t* data) {
        constexpr std::array<float, 8> volts{24.0F, 24.3F, 12.0F, 7.9F, 8.0F, 6.9F, 35.1F, 39.1F};
        constexpr std::array<float, 8> celsius{35.0F, 35.0F, 35.0F, 60.0F, 85.0F, 85.1F, 50.0F, 90.0F};
        constexpr std::array<float, 4> ohms{250.0F, 500.0F, 2000.0F, 1.0e6F};
        switch (which % 4U) {
            case 0:
                inputs.supply = volts[data[0] % volts.size()];
                return;
            case 1:
                inputs.cpu_temperature = celsius[data[0] % celsius.size()];
                return;
            default:
                inputs.load[which % 2U] = ohms[data[0] % ohms.size()];
                return;
        }
    }
    static const char* unknown(const ax130751::Inputs& inputs) {
        const bool usual = fuzz::is_usual(inputs.supply, 0.0F, 80.0F) &&
                           fuzz::is_usual(inputs.cpu_temperature, -60.0F, 150.0F) &&
                           fuzz::is_usual(inputs.load[0], 1.0F, 1.0e6F) && fuzz::is_usual(inputs.load[1], 1.0F, 1.0e6F);
        return !usual                                        ? "no unit has such an input"
               : inputs.can_state != 0 || inputs.can_overrun ? "the model knows no errors of the CAN controller"
                                                             : nullptr;
    }
    const char* unknown(const Frame& frame, const ax130751::Device& device) const {
        if (frame.extended) {
            return nullptr;
        }
        if (const char* const why = fuzz::compared_elsewhere(frame)) {
            return why;
        }
        if (frame.id == 0x080) {
            return "pdo and emcy compare SYNC";
        }
        if (frame.id == 0x600U + node) {
            const auto write = fuzz::expedited_write(device.objects(), frame);
            return write ? unknown_write(*write, device.objects()) : "sdo_server compares other SDO requests";
        }
        const unsigned first = frame.data[0];
        if (is_heartbeat(frame)) {
            const bool is_known = frame.length == 1 && (first == 4 || first == 5 || first == 127);
            return is_known ? nullptr : "error_control compares other heartbeats";
        }
        const bool is_known = frame.length == 2 && (first == 1 || (first >= 0x80 && first <= 0x82));
        return frame.id == 0 && !is_known ? "the model does not know the state stopped" : nullptr;
    }
    void receive(const Frame& frame) {
        if (frame.extended) {
            return;  // the device has identifiers of 11 bits only
        }
        if (frame.id == 0 && (frame.data[1] == 0 || frame.data[1] == node)) {
            model_.command(frame.data[0]);
        } else if (is_heartbeat(frame)) {
            model_.heartbeat(frame.id - 0x700U);
        } else if (frame.id >= 0x200U && frame.id < 0x600U && frame.id % 0x100U == node) {
            model_.receive(static_cast<int>(frame.id / 0x100U) - 1,
                           {frame.data.begin(), frame.data.begin() + frame.length});
        } else if (frame.id == 0x600U + node) {
            answer_ = answer_to(*fuzz::expedited_write(device_.objects(), frame));
        }
    }

    void compare(const ax130751::Device& device, const std::vector<Frame>& frames, std::uint64_t now_ms) {
        fuzz::TimedFrames said;
        for (const Frame& frame : frames) {
            if (frame.id == 0x580U + node) {
                fuzz::require(answer_of(frame) == answer_, "the answer to a write",
                              frame.data[1] + 256U * frame.data[2]);
            } else {
                said.emplace_back(now_ms - begun_ms_, host::format_frame(frame));
            }
        }
        fuzz::require_frames(by_identifier(said), by_identifier(told(model_.said)));
        model_.said.clear();
        const Comparison comparison{device, model_, check_};
        comparison.outputs();
        comparison.values();
        comparison.errors();
    }

  private:
    /// Connects outputs, relay, two tables, a logic block and a math block to extra received values (source type 1,
    /// source numbers 4 to 9). Gives each of them different parameters.
    template <typename Write>
    static void connect(const Write& write, fuzz::Choices& choices) {
        using Some = std::array<unsigned, 4>;
        for (unsigned n = 1; n <= 6; ++n) {
            write(0x2502, n, 1, n % 3);
            write(0x2522, n, 2, choices.one_of(Some{100, 200, 50 * n, 1000}));
        }
        for (unsigned n = 1; n <= 2; ++n) {
            write(0x6310, n, 2, choices.one_of(std::array<unsigned, 7>{10, 20, 40, 500, 1000, 1020, 1020}));
            const unsigned own = 3 * n + 1;
            for (const unsigned index : {0x2340U, 0x2350U, 0x2360U}) {
                write(index, n, 1, index == 0x2340 ? 1 : choices.one_of(Some{0, 1, 1, 3}));
                write(index + 1, n, 1, own + (index - 0x2340) / 0x10);
                write(index + 2, n, 1, choices.below(index == 0x2350 ? 6 : 2));
            }
            write(0x2330, n, 2, choices.one_of(Some{0, 3, 10, 40}));
            write(0x2331, n, 2, choices.one_of(Some{0, 5, 20, 50}));
            write(0x2223, n, 2, choices.one_of(Some{4, 6, 10, 30}));
            write(0x2240, n, 1, n % 2);
            write(0x2241, n, 1, choices.below(4));
            write(0x6340, n, 1, choices.below(2));
            write(0x6250, n, 1, choices.below(2));
            write(0x6260, n, 1, n % 2);
        }
        write(0x2242, 1, 1, choices.below(6));
        write(0x2250, 1, 2, choices.one_of(Some{4, 6, 10, 30}));
        for (const unsigned index : {0x2260U, 0x2270U, 0x2280U, 0x2290U}) {
            write(index, 1, 1, index == 0x2260 ? 1 : choices.one_of(Some{0, 0, 1, 3}));
            write(index + 1, 1, 1, 4 + choices.below(6));
        }
        write(0x22A0, 1, 1, choices.below(2));
        write(0x22A1, 1, 4, choices.below(20));
        write(0x22A2, 1, 4, choices.below(20));
        for (unsigned n = 1; n <= 2; ++n) {
            write(0x3000 + 0x10 * n, 0, 1, 1);
            write(0x3001 + 0x10 * n, 0, 1, 3 + n);
            write(0x3005 + 0x10 * n, 1, 1, choices.below(2));
            write(0x3007 + 0x10 * n, 2, 2, 60 * n + choices.below(40));
        }
        write(0x3300, 1, 1, 1);
        for (unsigned function = 1; function <= 3; ++function) {
            write(0x3401, function, 1, function);
            write(0x3402, function, 1, choices.below(5));
            write(0x3401 + 0x10 * function, 1, 1, 1);
            write(0x3401 + 0x10 * function, 2, 1, 4 + choices.below(6));
            write(0x3401 + 0x10 * function, 3, 1, 1);
            write(0x3401 + 0x10 * function, 4, 1, 4 + choices.below(6));
            write(0x3401 + 0x10 * function, 5, 1, choices.below(6));
        }
        write(0x4000, 1, 1, 1);
        for (unsigned input = 1; input <= 4; ++input) {
            write(0x4100, input, 1, choices.one_of(Some{1, 1, 3, 4}));
            write(0x4101, input, 1, input == 4 ? 1 : 3 + input);
            write(0x4140, input, 1, choices.one_of(Some{100, 50, 10, 0x9C}));
        }
        for (unsigned function = 1; function <= 3; ++function) {
            write(0x4150, function, 1, choices.below(18));
        }
    }
    using Check = void (*)(bool, const char*, unsigned);
    using Comparison = naive_ax130751::Comparison<Check>;

    static fuzz::TimedFrames told(const std::vector<naive_ax130751::Said>& said) {
        fuzz::TimedFrames all;
        for (const naive_ax130751::Said& one : said) {
            Frame frame = data_frame(one.id, static_cast<std::uint8_t>(one.data.size()));
            std::transform(one.data.begin(), one.data.end(), frame.data.begin(),
                           [](int byte) { return static_cast<std::uint8_t>(byte); });
            all.emplace_back(one.at, host::format_frame(frame));
        }
        return all;
    }
    /// Sorts frames by identifier. Frames with the same identifier keep their order.
    static fuzz::TimedFrames by_identifier(const fuzz::TimedFrames& frames) {
        std::multimap<std::string, fuzz::TimedFrames::value_type> sorted;
        for (const auto& frame : frames) {
            sorted.emplace(frame.second.substr(0, 3), frame);
        }
        fuzz::TimedFrames all;
        for (const auto& one : sorted) {
            all.push_back(one.second);
        }
        return all;
    }
    /// Returns whether a frame has the identifier of a heartbeat that begin() monitors, or of node 8.
    static bool is_heartbeat(const Frame& frame) { return frame.id >= 0x705 && frame.id <= 0x708; }
    static std::uint32_t answer_of(const Frame& answer) {
        return answer.data[0] == 0x80 ? read_u32(answer.payload(), 4) : 0U;
    }
    const char* unknown_write(const fuzz::ExpeditedWrite& write, const ObjectDictionary& objects) const {
        const auto known_if = [](bool known, const char* why) { return known ? nullptr : why; };
        if (!is_set_up_) {
            return nullptr;
        }
        if (write.address() == 0x100300) {
            return known_if(write.bits == 0, "emcy compares other values in 1003h");
        }
        if (write.address() == 0x101001) {
            return known_if(write.bits == 0x65766173, "parameter_store compares other signatures");
        }
        if (model_.entries().count({write.index(), write.sub()}) == 0) {
            return "the model has no such parameter";
        }
        if (write.address() == 0x102901) {
            return known_if(write.bits <= 1, "the model does not know the state stopped");
        }
        return known_if(!fuzz::is_beyond_fixed_range(objects, write), "the model knows no fixed ranges");
    }
    /// Performs a write on the model. Returns 0 or the abort code.
    std::uint32_t answer_to(const fuzz::ExpeditedWrite& write) {
        if (write.address() == 0x100300) {
            model_.errors.empty_list();
            return 0;
        }
        if (write.address() == 0x101001) {
            model_.store();
            return 0;
        }
        if (model_.entries().count({write.index(), write.sub()}) == 0) {
            return 0;  // a write of begin(), which has already set this parameter in the model
        }
        return model_.write(write.index(), write.sub(), static_cast<int>(write.value()));
    }

    const ax130751::Device& device_;
    naive_ax130751::Device model_{node};
    const Check check_{fuzz::check_model};
    std::uint64_t begun_ms_{0};
    std::uint32_t answer_{0};
    bool is_set_up_{false};
};

[[maybe_unused]] const bool is_set = fuzz::set_beside_model(fuzz::run_beside_model<fuzz::Ax130751Unit, Model>);

}  // namespace
