// SPDX-License-Identifier: Apache-2.0
// Analog pins of a board. The inputs are read in turn through ADC1. The outputs are the two channels of the DAC, and
// timers whose filtered pulses make a voltage (RM0090 13.13, 14.5 and 18.4).
#pragma once

#include "target/stm32f405/time_base.hpp"

namespace canproof::stm32f405 {

struct AdcRegisters {
    Register status;                       ///< 00h ADC_SR (13.13.1)
    Register control_1;                    ///< 04h ADC_CR1 (13.13.2)
    Register control_2;                    ///< 08h ADC_CR2 (13.13.3)
    std::array<Register, 2U> sample_time;  ///< 0Ch ADC_SMPR1, ADC_SMPR2 (13.13.4, 13.13.5)
    Reserved<6U> reserved_14{};
    std::array<Register, 3U> sequence;  ///< 2Ch ADC_SQR1 to ADC_SQR3 (13.13.9 to 13.13.11)
    Reserved<5U> reserved_38{};
    Register data;  ///< 4Ch ADC_DR (13.13.14)
    Reserved<173U> reserved_50{};
    Register common;  ///< 304h ADC_CCR (13.13.16)
};

static_assert(sizeof(AdcRegisters) == 0x308U, "ADC_CCR lies at 304h of ADC1");

struct DacRegisters {
    Register control;  ///< 00h DAC_CR (14.5)
    Register trigger;  ///< 04h DAC_SWTRIGR (14.5)
    Register data_1;   ///< 08h DAC_DHR12R1 (14.5)
    Reserved<2U> reserved_0c{};
    Register data_2;  ///< 14h DAC_DHR12R2 (14.5)
};

/// The greatest code of a 12-bit converter, for a share of 1.
constexpr float full_scale_12_bit = 4095.0F;

class AnalogInputs {
  public:
    /// Channel of the temperature sensor in the chip.
    static constexpr std::size_t temperature_channel = 16U;
    static constexpr std::size_t channel_count = 17U;

    explicit AnalogInputs(AdcRegisters& registers) noexcept : registers_{registers} {}

    /// Starts the converter. `channels`: one bit for each channel to read. Waits for the first value of each channel,
    /// but at most a fixed number of polls.
    void start(std::uint32_t channels) noexcept;
    /// Stores the result of a finished conversion and starts the conversion of the next channel.
    void advance() noexcept;
    /// Returns the channel's last conversion as a share, 0 to 1, of the reference voltage; 0 before the first
    /// conversion.
    float share(const std::size_t channel) const noexcept {
        return static_cast<float>(values_[channel]) / full_scale_12_bit;
    }
    /// Returns the temperature of the chip in degrees Celsius, for a reference of 3.3 V (RM0090 13.10, data sheet).
    float chip_temperature() const noexcept;

  private:
    void convert() noexcept;

    AdcRegisters& registers_;
    std::array<std::uint16_t, channel_count> values_{};
    std::uint32_t channels_{0U};
    std::uint32_t unread_{0U};  ///< one bit for each channel that has no value yet
    std::size_t current_{0U};
};

class AnalogOutputs {
  public:
    explicit AnalogOutputs(DacRegisters& registers) noexcept : registers_{registers} {}

    void start() noexcept;
    /// Sets channel 0 or 1. A share outside 0 to 1 is clamped; NaN counts as 0.
    void set(std::size_t channel, float share) noexcept;

  private:
    DacRegisters& registers_;
};

/// Two outputs with the same frequency: channels 1 and 2 of TIM3 or TIM4.
class PulseOutputs {
  public:
    PulseOutputs(TimerRegisters& timer, const std::uint32_t timer_mhz) noexcept
        : timer_{timer}, timer_mhz_{timer_mhz} {}

    void start() noexcept;
    /// Sets the frequency in Hz, clamped to 1…1,000,000.
    void set_frequency(float hertz) noexcept;
    /// Sets the duty of channel 0 or 1; the share is clamped as in AnalogOutputs::set().
    void set_duty(std::size_t channel, float share) noexcept;

  private:
    TimerRegisters& timer_;
    std::uint32_t timer_mhz_;
    std::uint32_t period_{1U};  ///< counts
};

}  // namespace canproof::stm32f405
