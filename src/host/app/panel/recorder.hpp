// SPDX-License-Identifier: Apache-2.0
// Records a session for the panel's page: changes of outputs and LEDs with their times, measured values, decoded
// frames, and each device's last emergency message. Its memory is bounded: old records are dropped, even if a slow
// reader has not read them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/app/panel/lamp.hpp"
#include "host/app/panel/ring.hpp"
#include "host/sim/decode/decode_frame.hpp"
#include "host/sim/run/run_session.hpp"

namespace canproof::host {

/// A value of a device that the page can show.
struct Channel {
    enum class Kind {
        output,    ///< a physical output, with exact times of change
        lamp,      ///< an LED that the panel adds for a device without LEDs
        measured,  ///< a dictionary entry whose value the device updates
        setting    ///< a dictionary entry that the page marks on a scale, such as a limit
    } kind{Kind::output};
    std::string name;
    std::string text;
    std::string unit;
    double scale{1.0};  ///< factor from the raw value to the value in `unit`: 0.1 for `0.1 degC`
    std::optional<double> minimum;
    std::optional<double> maximum;
    const Entry* entry{nullptr};  ///< dictionary entry of a measured value or setting; nullptr for others
    EntryRef place{};
    bool truth{false};
    bool whole{false};  ///< whether the value is an integer, shown without decimals
};

/// Data for drawing a device. The requirements register does not contain these data.
struct DeviceFace {
    std::vector<std::string> leds;      ///< outputs that are LEDs; empty: the panel adds `run` and `error`
    std::vector<std::string> settings;  ///< names of the entries that the page marks on a scale
};

struct ChannelChange {
    Instant time{};
    std::size_t channel{0};  ///< number of the channel, counted over all devices
    double value{0.0};
};

struct RecordedFrame {
    Instant time{};
    Frame frame{};
    std::string sender;  ///< name of the sending device; empty: no device of this program sent the frame
    FrameWords words;
};

struct LastEmergency {
    Instant time{};
    std::string text;
    bool error{false};  ///< false: the emergency code reports that an error has ended
};

class Recorder final : public SessionObserver {
  public:
    static constexpr std::size_t changes_kept = 16384;
    static constexpr std::size_t frames_kept = 2000;
    /// Period at which the measured values are read.
    static constexpr Duration measuring_period = milliseconds(50);

    struct Device {
        std::string name;
        const SimulatedDevice* device{nullptr};
        const Part* part{nullptr};
        std::vector<Channel> channels;
        std::vector<double> values;  ///< last recorded value of each element of `channels`
        std::map<std::size_t, LampHistory> lamps;
        std::optional<LastEmergency> emergency;
        std::size_t first_channel{0};
    };

    explicit Recorder(const Register& content) : decoder_{content} {}

    /// Adds a device before power-on. `part` may be nullptr; `device` and `part` must outlive the recorder.
    void add(const std::string& name, const SimulatedDevice& device, const Part* part, const DeviceFace& face);

    void on_frame(const BusFrame& frame) override;
    void on_step(Instant at) override;

    const std::vector<Device>& devices() const { return devices_; }
    const Ring<ChannelChange>& changes() const { return changes_; }
    const Ring<RecordedFrame>& frames() const { return frames_; }

  private:
    std::vector<KnownNode> known_nodes() const;
    void put(Device& device, std::size_t channel, double value, Instant at);
    void follow_lamps(Device& device, Instant at);
    void measure(Device& device, Instant at);

    FrameDecoder decoder_;
    std::vector<Device> devices_;
    Ring<ChannelChange> changes_{changes_kept};
    Ring<RecordedFrame> frames_{frames_kept};
    Instant last_step_{};
    Instant next_measuring_{};
};

}  // namespace canproof::host
