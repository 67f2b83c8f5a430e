// SPDX-License-Identifier: Apache-2.0
#include "target/stm32f405/analog.hpp"

#include "firmware/base/requirement.hpp"
#include "generated/canopen/requirements.hpp"

namespace canproof::stm32f405 {

namespace {

// Bits of the ADC registers (RM0090 13.13, 13.13.16).
constexpr std::uint32_t conversion_done = bit(1U);     // EOC
constexpr std::uint32_t converter_on = bit(0U);        // ADON
constexpr std::uint32_t start_conversion = bit(30U);   // SWSTART
constexpr std::uint32_t longest_sample = 0x07FFFFFFU;  // sampling time: 480 cycles for each of nine channels
constexpr std::uint32_t clock_by_4 = bit(16U);         // ADCPRE: APB2 / 4, at most 21 MHz; 36 MHz are allowed
/// The limit of polls for a conversion. A conversion takes 24 us; a poll takes at least six cycles of 168 MHz, so this
/// number of polls takes at least 0.7 ms.
constexpr std::uint32_t most_polls = 20000U;
constexpr std::uint32_t chip_sensor = bit(23U);  // TSVREFE
// The chip's temperature sensor gives 0.76 V at 25 °C and 2.5 mV per degree.
constexpr float reference_v = 3.3F;
constexpr float sensor_at_25_v = 0.76F;
constexpr float sensor_v_a_degree = 0.0025F;
constexpr float sensor_offset = 25.0F;

constexpr std::uint32_t both_dac_channels = bit(0U) | bit(16U);  // EN1, EN2 (RM0090 14.5.1)

// Timers (RM0090 18.4): PWM mode 1 with preload on channels 1 and 2.
constexpr std::uint32_t pwm_mode = 0x68U;
constexpr std::uint32_t second_channel_shift = 8U;
constexpr std::uint32_t outputs_on = bit(0U) | bit(4U);  // CC1E, CC2E
constexpr std::uint32_t buffered = bit(7U);              // ARPE
constexpr float most_counts = 65535.0F;

constexpr float between(const float value, const float least, const float most) noexcept {
    if (!(value > least)) {
        return least;  // NaN gives the lowest value too
    }
    return (value < most) ? value : most;
}

}  // namespace

void AnalogInputs::start(const std::uint32_t channels) noexcept {
    channels_ = channels;
    registers_.common.write(clock_by_4 | chip_sensor);
    registers_.sample_time[0U].write(longest_sample);
    registers_.sample_time[1U].write(longest_sample | (longest_sample << 3U));
    registers_.sequence[0U].write(0U);  // one conversion
    registers_.control_2.write(converter_on);
    convert();
    unread_ = channels;
    for (std::uint32_t poll = 0U; poll < most_polls; ++poll) {
        if (unread_ != 0U) {
            advance();
        }
    }
}

void AnalogInputs::convert() noexcept {
    for (std::size_t tried = 0U; tried < channel_count; ++tried) {
        current_ = (current_ + 1U) % channel_count;
        if ((channels_ & bit(static_cast<std::uint32_t>(current_))) != 0U) {
            break;
        }
    }
    registers_.sequence[2U].write(static_cast<std::uint32_t>(current_));
    registers_.control_2.write(converter_on | start_conversion);
}

static_assert(implements<req::CO_IMAGE_002>);
void AnalogInputs::advance() noexcept {
    if (registers_.status.has(conversion_done)) {
        values_[current_] = static_cast<std::uint16_t>(registers_.data.read() & 0xFFFU);  // clears EOC
        unread_ &= ~bit(static_cast<std::uint32_t>(current_));
        convert();
    }
}

float AnalogInputs::chip_temperature() const noexcept {
    const float volts = share(temperature_channel) * reference_v;
    return ((volts - sensor_at_25_v) / sensor_v_a_degree) + sensor_offset;
}

void AnalogOutputs::start() noexcept {
    registers_.control.write(both_dac_channels);
}

static_assert(implements<req::CO_IMAGE_003>);
void AnalogOutputs::set(const std::size_t channel, const float share) noexcept {
    const auto code = static_cast<std::uint32_t>((between(share, 0.0F, 1.0F) * full_scale_12_bit) + 0.5F);
    Register& data = (channel == 0U) ? registers_.data_1 : registers_.data_2;
    data.write(code);
}

void PulseOutputs::start() noexcept {
    timer_.compare_mode[0U].write(pwm_mode | (pwm_mode << second_channel_shift));
    timer_.compare_enable.write(outputs_on);
    set_frequency(1000.0F);
    set_duty(0U, 0.0F);
    set_duty(1U, 0.0F);
    timer_.events.write(tim::update);
    timer_.control.write(tim::enable | buffered);
}

/// Sets the frequency with the smallest prescaler for which the period fits into 16 bits.
void PulseOutputs::set_frequency(const float hertz) noexcept {
    const float clocks = (static_cast<float>(timer_mhz_) * 1000000.0F) / between(hertz, 1.0F, 1000000.0F);
    const auto divider = static_cast<std::uint32_t>(clocks / most_counts) + 1U;
    period_ = static_cast<std::uint32_t>(clocks / static_cast<float>(divider));
    timer_.prescaler.write(divider - 1U);
    timer_.reload.write(period_ - 1U);
}

static_assert(implements<req::CO_IMAGE_003>);
void PulseOutputs::set_duty(const std::size_t channel, const float share) noexcept {
    timer_.compare[channel].write(static_cast<std::uint32_t>(between(share, 0.0F, 1.0F) * static_cast<float>(period_)));
}

}  // namespace canproof::stm32f405
