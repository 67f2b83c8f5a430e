// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/simulation/converter_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include "devices/ax130751/firmware/ax130751.hpp"
#include "generated/ax130751/index.hpp"
#include "host/sim/devices/memory.hpp"

namespace canproof::ax130751 {

using namespace host;

namespace {

namespace index = generated::ax130751::index;

constexpr std::size_t memory_size = 8192;
constexpr int points_of_a_table = 11;
constexpr int lookup_source = 3;
constexpr int canopen_source = 1;
constexpr int extra_number = 3;  // extra received value n has number n + 3 (Table 4B)

struct Point {
    int x;
    int y;
};

/// Returns the index of an object of lookup table `table`, from the index of the same object of table 1.
constexpr std::uint32_t of_table(int table, std::uint32_t of_table_1) {
    constexpr std::uint32_t distance = index::lt2_input_x_axis_source - index::lt1_input_x_axis_source;
    return of_table_1 + distance * static_cast<std::uint32_t>(table - 1);
}

/// An AX130751 alone on a bus in operational; the functions read and write its objects over SDO.
class Converter {
  public:
    Converter() {
        device_.power_on({}, now_);
        Frame start = data_frame(0x000, 2);  // start all nodes: outputs run in operational only
        start.data[0] = 0x01;
        device_.receive(start, now_);
    }

    void put8(std::uint32_t index, int sub, int value) { put(0x2F, index, sub, value); }
    void put16(std::uint32_t index, int sub, int value) { put(0x2B, index, sub, value); }
    void put32(std::uint32_t index, int sub, int value) { put(0x23, index, sub, value); }
    int get16(std::uint32_t index, int sub) {
        return static_cast<std::int16_t>(static_cast<std::uint16_t>(ask(0x40, index, sub, 0) & 0xFFFFU));
    }
    int get8(std::uint32_t index, int sub) { return static_cast<int>(ask(0x40, index, sub, 0) & 0xFFU); }

    /// Sets extra received value `number`, in tenths, and waits until the blocks have processed it.
    void receive(int number, int tenths) {
        put16(index::ec_extra_received_process_value, number, tenths);
        const Instant end = now_ + milliseconds(20);
        while (device_.next_deadline() <= end) {
            now_ = std::max(now_, device_.next_deadline());
            device_.advance(now_);
        }
        now_ = end;
    }
    double volts(int output) const {
        return static_cast<double>(device_.outputs().out_voltage.at(static_cast<std::size_t>(output - 1)));
    }

    /// Sets the points of lookup table `table`. Its X axis is extra received value 1.
    /// X is written from point 11 down to point 1, as 1.5.1 advises. If fewer than eleven points are
    /// given, the remaining points get the X of the last given one. The first remaining point has the response
    /// `ignore`, which ends the table.
    void set_table(int table, const std::vector<Point>& points) {
        put8(of_table(table, index::lt1_input_x_axis_source), 0, canopen_source);
        put8(of_table(table, index::lt1_input_x_axis_number), 0, extra_number + 1);
        const int count = static_cast<int>(points.size());
        for (int number = points_of_a_table; number >= 1; --number) {
            put32(of_table(table, index::lt1_point_x_axis_pv), number,
                  points[static_cast<std::size_t>(std::min(number, count) - 1)].x);
        }
        for (int number = 1; number <= count; ++number) {
            put16(of_table(table, index::lt1_point_y_axis_pv), number, points[static_cast<std::size_t>(number - 1)].y);
        }
        if (count < points_of_a_table) {
            put8(of_table(table, index::lt1_point_response), count + 1, 0);
        }
    }

  private:
    void put(int specifier, std::uint32_t index, int sub, int value) {
        static_cast<void>(ask(specifier, index, sub, static_cast<std::uint32_t>(value)));
    }
    std::uint32_t ask(int specifier, std::uint32_t index, int sub, std::uint32_t value) {
        Frame request = data_frame(0x600U + device_.node_id(), max_frame_length);
        request.data[0] = static_cast<std::uint8_t>(specifier);
        write_le(MutableBytes{request.data}, 1, 2, index);
        request.data[3] = static_cast<std::uint8_t>(sub);
        write_le(MutableBytes{request.data}, 4, 4, value);
        device_.receive(request, now_);
        Frame answer{};
        while (!queue_.empty()) {
            answer = queue_.pop();
        }
        if (answer.data[0] == 0x80U) {
            throw std::logic_error{
                fmt::format("the AX130751 refuses {:04X}h:{} with {:08X}h", index, sub, read_u32(answer.payload(), 4))};
        }
        return read_u32(answer.payload(), 4);
    }

    Memory memory_{memory_size};
    TransmitQueue queue_;
    ax130751::Device device_{memory_, queue_, {}};
    Instant now_{};
};

/// Configures an output to show the percentage of a table as 0 to 10 V, without ramps.
void drive_by_table(Converter& converter, int output, int table) {
    converter.put8(index::ao_control_input_source, output, lookup_source);
    converter.put8(index::ao_control_input_number, output, table);
    converter.put8(index::ao_control_response, output, 0);  // single output profile
    converter.put8(index::ao_decimal_digits_pv, output, 0);
    converter.put16(index::ao_output_scaling_2_pv, output, 100);
    converter.put16(index::ao_output_scaling_2_fv, output, 10000);
    converter.put16(index::ao_ramp_up, output, 0);
    converter.put16(index::ao_ramp_down, output, 0);
}

/// Sets a condition of a logic block: extra received value 1 is less than extra received value `border`.
void ask_below(Converter& converter, std::uint32_t condition, int border) {
    constexpr int less_than = 4;
    converter.put8(condition, 1, canopen_source);
    converter.put8(condition, 2, extra_number + 1);
    converter.put8(condition, 3, canopen_source);
    converter.put8(condition, 4, extra_number + border);
    converter.put8(condition, 5, less_than);
}

}  // namespace

LinePlot joystick_plot() {
    Converter converter;
    converter.put16(index::ec_scaling_2_pv, 1, 1000);  // 0.0 to 100.0 %
    converter.set_table(1, {{0, 0}, {55, 0}, {75, 30}, {100, 100}});
    converter.set_table(2, {{0, 100}, {25, 30}, {45, 0}, {100, 0}});
    drive_by_table(converter, 1, 1);
    drive_by_table(converter, 2, 2);
    LinePlot plot{"AX130751, 1.5.3: joystick with a deadband, two outputs",
                  "joystick / %",
                  "output / V",
                  {{"output 1, table 1", {}}, {"output 2, table 2", {}}},
                  {{45.0, "deadband"}, {55.0, ""}}};
    for (int tenths = 0; tenths <= 1000; tenths += 5) {
        converter.receive(1, tenths);
        for (const int output : {1, 2}) {
            plot.curves[static_cast<std::size_t>(output - 1)].points.emplace_back(tenths / 10.0,
                                                                                  converter.volts(output));
        }
    }
    return plot;
}

LinePlot trimmed_joystick_plot() {
    Converter converter;
    converter.put8(index::math_function_enable, 1, 1);
    for (const int input : {1, 2}) {
        converter.put16(index::ec_scaling_2_pv, input, 1000);
        converter.put8(index::math_1_input_source, input, canopen_source);
        converter.put8(index::math_1_input_number, input, extra_number + input);
        converter.put8(index::math_1_input_decimal_digits_fv, input, 1);  // tenths
        converter.put16(index::math_1_input_scaling_2_fv, input, 1000);   // 100.0
    }
    converter.put8(index::math_1_input_gain, 1, 75);
    converter.put8(index::math_1_input_gain, 2, 25);
    converter.put8(index::math_1_operator, 1, 12);  // plus
    LinePlot plot{
        "AX130751, 1.7: 75 % of a joystick and 25 % of a potentiometer", "joystick / %", "math block 1 / %", {}, {}};
    for (const int potentiometer : {0, 500, 1000}) {
        Curve curve{fmt::format("potentiometer at {} %", potentiometer / 10), {}};
        converter.receive(2, potentiometer);
        for (int tenths = 0; tenths <= 1000; tenths += 50) {
            converter.receive(1, tenths);
            curve.points.emplace_back(tenths / 10.0, converter.get16(index::math_output_process_value, 1) / 100.0);
        }
        plot.curves.push_back(curve);
    }
    return plot;
}

LinePlot thirty_slopes_plot() {
    Converter converter;
    for (const int number : {1, 2, 3}) {
        converter.put16(index::ec_scaling_2_pv, number, 3000);
    }
    converter.receive(2, 1000);  // extra received values 2 and 3 are the borders between the three tables
    converter.receive(3, 2000);
    for (const int table : {1, 2, 3}) {
        converter.put8(of_table(table, index::lt1_x_axis_decimal_digits_pv), 0, 1);
        converter.put8(of_table(table, index::lt1_y_axis_decimal_digits_pv), 0, 1);
        std::vector<Point> points;
        for (int at = 10 * table - 10; at <= 10 * table; ++at) {
            // Every second point lies 5 % above the straight line through the other points.
            points.push_back({100 * at, 30 * at + (at % 2 == 1 ? 50 : 0)});
        }
        converter.set_table(table, points);
    }
    converter.put8(index::logic_block_enable, 1, 1);
    ask_below(converter, index::lb1_function_a_condition_1, 2);
    ask_below(converter, index::lb1_function_b_condition_1, 3);
    LinePlot plot{"AX130751, 1.6: 30 slopes from three tables", "input", "logic block 1 / %", {{"3320h:1", {}}}, {}};
    int selected = 0;
    for (int tenths = 0; tenths <= 3000; tenths += 10) {
        converter.receive(1, tenths);
        plot.curves[0].points.emplace_back(tenths / 10.0, converter.get16(index::logic_block_output_pv, 1) / 10.0);
        const int table = converter.get8(index::logic_block_selected_table, 1);
        if (table != selected) {
            plot.marks.push_back({tenths / 10.0, fmt::format("table {}", table)});
            selected = table;
        }
    }
    return plot;
}

}  // namespace canproof::ax130751
