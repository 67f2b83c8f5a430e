// SPDX-License-Identifier: Apache-2.0
// Runs the naive model of the AX060805 (a second, simple implementation) beside the device. Compares angles,
// accelerations, results of the functions, latency, figure of merit, temperatures and supply, all frames including
// the contents of TPDOs, 1001h (error register) and 1003h (error list).
#include "fuzz/devices/ax060805/ax060805_unit.hpp"
#include "fuzz/support/beside_model.hpp"
#include "fuzz/support/expedited_write.hpp"
#include "properties/devices/ax060805/naive_comparison.hpp"

namespace {

using namespace canproof;

constexpr unsigned node = 127;

class Model {
  public:
    static constexpr std::uint64_t longest_wait_ms = 60;
    static constexpr unsigned further_events = 12;
    static constexpr std::uint64_t longest_run_ms = 600;

    explicit Model(const ax060805::Device& device) : device_{device} {}

    /// Sets different parameters for the three axes, for their additional filters and for the inputs of the functions.
    /// Then switches TPDO 2 and 3 on and starts the node.
    template <typename Run>
    static void begin(Run& run, fuzz::Choices& choices) {
        const auto write = [&run](unsigned index, unsigned sub, unsigned size, std::uint32_t bits) {
            run.receive(fuzz::write_request(node, index, sub, size, bits));
        };
        for (unsigned n = 0; n < 3; ++n) {
            write(0x1800 + n, 5, 2, 11 + 6 * n);
            write(0x2010, n + 1, 2, 1000 - 300 * n);
            write(0x2030, n + 1, 2, 100 + 300 * n);
            write(0x2040, n + 1, 4, bit_cast<std::uint32_t>(7.0F * static_cast<float>(n)));
            write(0x2031, n + 1, 1, n % 2);
            write(0x2050, n + 1, 1, n);
            write(0x2051, n + 1, 2, 3 + 2 * n);
            write(0x2502, n + 1, 4, bit_cast<std::uint32_t>(5.0F * static_cast<float>(n)));
        }
        write(0x2052, 0, 2, 7);
        write(0x1400, 5, 2, 20);
        constexpr std::array<std::array<unsigned, 2>, 3> sources{{{5, 6}, {1, 10}, {20, 21}}};
        for (unsigned n = 0; n < 3; ++n) {
            for (unsigned i = 0; i < 2; ++i) {
                write(0x3010 + 0x10 * n, i + 1, 1, sources[n][i]);
                write(0x3012 + 0x10 * n, i + 1, 4, bit_cast<std::uint32_t>(3.0F + static_cast<float>(i)));
            }
            write(0x300A, n + 1, 1, 1 + choices.below(20));
        }
        Frame start = data_frame(0, 2);
        start.data[0] = 1;
        run.receive(start);
    }
    /// Returns an NMT command or RPDO1.
    static Frame usual_frame(unsigned, unsigned which, const std::uint8_t* data) {
        constexpr std::array<std::uint8_t, 4> commands{0x01, 0x01, 0x80, 0x81};
        Frame frame = data_frame(0, 2);
        frame.data[0] = commands[data[0] % commands.size()];
        if (which % 2U == 0) {
            frame = data_frame(0x27F, which % 8U == 0 ? 5 : 6);
            std::copy_n(data, frame.length, frame.data.begin());
        }
        return frame;
    }
    const char* ends() const { return model_.is_certain() ? nullptr : "rounding in single precision may decide"; }

    static void finish(const ax060805::Device&) {}
    void power_on(const ax060805::Inputs& inputs, std::uint64_t) {
        set_inputs(inputs);
        if (std::exchange(is_on_, true)) {
            model_.restart();
        }
    }
    void set_inputs(const ax060805::Inputs& inputs) {
        model_.feel(test::felt_of(inputs));
        model_.lose_frames(inputs.can_overrun);
    }
    void pass(std::uint64_t ms) {
        for (; ms > 0; --ms) {
            model_.pass();
        }
    }

    /// Tilts the inclinometer, changes a temperature or the supply, or starts or ends a failure of the sensor.
    static void put_usual_input(ax060805::Inputs& inputs, unsigned which, const std::uint8_t* data) {
        const auto number = static_cast<float>(static_cast<std::int16_t>(data[0] | (unsigned{data[1]} << 8U)));
        switch (which % 8U) {
            case 0:
                inputs.accelerometer_fault = (data[0] & 1U) != 0;
                return;
            case 1:
                inputs.sensor_temperature = number / 256.0F;
                return;
            case 2:
                inputs.processor_temperature = number / 128.0F - 50.0F;
                return;
            case 3:
                inputs.supply_voltage = number / 400.0F;
                return;
            default: {
                const float pitch = number / 22000.0F;
                const float roll = static_cast<float>(static_cast<std::int8_t>(data[2])) / 41.0F + 0.0042F;
                inputs.acceleration_x = std::sin(pitch);
                inputs.acceleration_y = -std::sin(roll) * std::cos(pitch);
                inputs.acceleration_z = -std::cos(roll) * std::cos(pitch);
                const float size = data[3] == 0 ? 16.5F : 1.0F;  // 16.5 g is beyond the range of the sensor
                (data[4] % 2U == 0 ? inputs.acceleration_y : inputs.acceleration_x) *= size;
                return;
            }
        }
    }
    static const char* unknown(const ax060805::Inputs& inputs) {
        const bool has_acceleration = fuzz::is_usual(inputs.acceleration_x, -20.0F, 20.0F) &&
                                      fuzz::is_usual(inputs.acceleration_y, -20.0F, 20.0F) &&
                                      fuzz::is_usual(inputs.acceleration_z, -20.0F, 20.0F);
        const bool usual = fuzz::is_usual(inputs.sensor_temperature, -100.0F, 200.0F) &&
                           fuzz::is_usual(inputs.processor_temperature, -100.0F, 200.0F) &&
                           fuzz::is_usual(inputs.supply_voltage, -10.0F, 100.0F);
        return !has_acceleration || !usual ? "no unit has such an input"
               : inputs.can_state != 0     ? "the model knows no errors of the CAN controller"
                                           : nullptr;
    }
    static const char* unknown(const Frame& frame, const ax060805::Device& device) {
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
        const unsigned command = frame.data[0];
        const bool is_known = frame.length == 2 && (command == 0x01 || command == 0x80 || command == 0x81);
        return frame.id == 0 && !is_known ? "the model knows start, pre-operational and reset node only" : nullptr;
    }
    void receive(const Frame& frame) {
        if (frame.extended) {
            return;  // the device has identifiers of 11 bits only
        }
        if (frame.id == 0) {
            command(frame.data[0], frame.data[1]);
        } else if (frame.id == 0x27FU) {
            const auto word = [&frame](std::size_t at) {
                return int{static_cast<std::int16_t>(read_le(frame.payload(), at, 2))};
            };
            const bool is_whole = frame.length >= 6;
            model_.receive_values(is_whole ? std::array<int, 3>{word(0), word(2), word(4)} : std::array<int, 3>{},
                                  frame.length);
        } else if (frame.id == 0x600U + node) {
            const auto write = fuzz::expedited_write(device_.objects(), frame);
            if (write->index() == 0x1010) {
                model_.store();
            } else {
                model_.set(write->index(), write->sub(), write->value());
            }
        }
    }

    void compare(const ax060805::Device& device, const std::vector<Frame>& said, std::uint64_t) {
        const test::NaiveComparison<decltype(&fuzz::check_model)> comparison{device, model_, check_};
        comparison.frames(said, model_.take_said());
        comparison.values();
        comparison.errors();
    }

  private:
    void command(unsigned command, unsigned to) {
        if (to != 0 && to != node) {
            return;
        }
        if (command == 0x81) {
            model_.restart();
        } else {
            model_.command(command == 0x01);
        }
    }
    static const char* unknown_write(const fuzz::ExpeditedWrite& write, const ObjectDictionary& objects) {
        const auto known_if = [](bool known, const char* why) { return known ? nullptr : why; };
        if (fuzz::is_beyond_fixed_range(objects, write)) {
            return "the model knows no ranges";
        }
        switch (write.address()) {
            case 0x100300:
                return known_if(write.bits == 0, "emcy compares other values in 1003h");
            case 0x101001:
                return known_if(write.bits == 0x65766173, "parameter_store compares other signatures");
            case 0x102901:
            case 0x102902:
                return known_if(write.bits <= 1, "the model does not know the state stopped");
            case 0x102903:
            case 0x140005:
            case 0x180005:
            case 0x180105:
            case 0x180205:
                return nullptr;
            case 0x250001:
            case 0x250002:
            case 0x250003:
                return nullptr;
            default:
                break;
        }
        const unsigned index = write.index();
        if (index == 0x2051) {
            return known_if(write.bits <= 200, "a long window takes the model too long");
        }
        const bool is_other = index < 0x2002 || index == 0x5550 || index == 0x5555;
        return known_if(!is_other && std::fabs(write.value()) <= 1.0e5, "the model does not know the parameter");
    }

    const ax060805::Device& device_;
    test::NaiveNode model_{test::NaiveUnit{}, test::NaiveFelt{}};
    void (*const check_)(bool, const char*, unsigned){fuzz::check_model};
    bool is_on_{false};
};

[[maybe_unused]] const bool is_set = fuzz::set_beside_model(fuzz::run_beside_model<fuzz::Ax060805Unit, Model>);

}  // namespace
