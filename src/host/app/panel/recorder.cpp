// SPDX-License-Identifier: Apache-2.0
#include "host/app/panel/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "generated/canopen/constants.hpp"
#include "generated/canopen/index.hpp"
#include "host/base/cia301.hpp"

namespace canproof::host {

namespace {

using generated::canopen::index::error_register;

/// Returns the unit of a sub-index. In a list such as `0.1 degC; 0.1 V`, the first unit is that of sub-index 1. A text
/// without `;` is the unit of every sub-index.
std::string own_unit(const std::string& units, std::uint8_t subindex) {
    std::istringstream parts{units};
    std::string one = units;
    for (int n = 0; n < subindex && units.find(';') != std::string::npos && std::getline(parts, one, ';'); ++n) {
        one.erase(0, one.find_first_not_of(' '));
    }
    return one;
}

/// Splits `0.1 degC` into the scale 0.1 and the unit `degC`; a unit without a number has the scale 1.
void split_unit(const std::string& text, Channel& channel) {
    const auto space = text.find(' ');
    const bool counted = space != std::string::npos && text.find_first_not_of("0123456789.") == space;
    channel.scale = counted ? std::stod(text.substr(0, space)) : 1.0;
    channel.unit = counted ? text.substr(space + 1) : text;
}

std::vector<Channel> output_channels(const SimulatedDevice& device, const Part* part) {
    std::vector<Channel> channels;
    for (const std::string& name : device.output_names()) {
        Channel channel;
        channel.name = name;
        for (std::size_t i = 0; part != nullptr && i < part->signals.size(); ++i) {
            const Signal& signal = part->signals[i];
            const auto names = signal.names();
            if (!signal.input && std::find(names.begin(), names.end(), name) != names.end()) {
                channel.text = signal.text;
                channel.unit = signal.unit;
                channel.minimum = signal.minimum;
                channel.maximum = signal.maximum;
                channel.truth = signal.type == "BOOLEAN";
                channel.whole = signal.type.rfind("REAL", 0) != 0;
            }
        }
        channels.push_back(std::move(channel));
    }
    return channels;
}

Channel lent_lamp(const char* name, const char* text) {
    Channel channel;
    channel.kind = Channel::Kind::lamp;
    channel.name = name;
    channel.text = text;
    channel.truth = true;
    return channel;
}

void add_entries(const SimulatedDevice& device, const Part* part, const DeviceFace& face,
                 std::vector<Channel>& channels) {
    if (part == nullptr || device.objects() == nullptr) {
        return;
    }
    for (const Object& object : part->objects) {
        for (const Entry& entry : object.entries) {
            const bool setting =
                std::find(face.settings.begin(), face.settings.end(), entry.name) != face.settings.end();
            const bool measured =
                entry.live && object.index >= cia301::first_manufacturer_object && type_size(entry.type) != 0U;
            const auto found = device.objects()->find(object.index, entry.subindex);
            if ((!setting && !measured) || !found.ok()) {
                continue;
            }
            Channel channel;
            channel.kind = setting ? Channel::Kind::setting : Channel::Kind::measured;
            channel.name = entry.name;
            channel.text = object.text;
            split_unit(own_unit(object.unit, entry.subindex), channel);
            channel.whole = channel.scale == 1.0 && entry.type.rfind("REAL", 0) != 0;
            channel.entry = &entry;
            channel.place = found.value();
            channels.push_back(std::move(channel));
        }
    }
}

double number_of(const Channel& channel, const ObjectDictionary& objects) {
    const std::uint64_t bits = objects.bits(*channel.place.row);
    const std::string& type = channel.entry->type;
    if (type == "REAL32") {
        return static_cast<double>(bit_cast<float>(static_cast<std::uint32_t>(bits))) * channel.scale;
    }
    if (type == "REAL64") {
        return bit_cast<double>(bits) * channel.scale;
    }
    const unsigned spare = 64U - 8U * static_cast<unsigned>(type_size(type));
    const bool is_signed = type.rfind("INTEGER", 0) == 0;
    const auto value =
        is_signed ? static_cast<double>(static_cast<std::int64_t>(bits << spare) >> spare) : static_cast<double>(bits);
    return value * channel.scale;
}

bool same(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

void Recorder::add(const std::string& name, const SimulatedDevice& device, const Part* part, const DeviceFace& face) {
    Device one;
    one.name = name;
    one.device = &device;
    one.part = part;
    one.channels = output_channels(device, part);
    for (std::size_t i = 0; i < one.channels.size(); ++i) {
        if (std::find(face.leds.begin(), face.leds.end(), one.channels[i].name) != face.leds.end()) {
            one.lamps[i] = {};
        }
    }
    if (face.leds.empty()) {
        one.lamps[one.channels.size()] = {};
        one.channels.push_back(lent_lamp("run", "Added by the panel: the NMT state, by CiA 303-3."));
        one.lamps[one.channels.size()] = {};
        one.channels.push_back(
            lent_lamp("error", "Added by the panel: lit while the error register 1001h is not zero."));
    }
    add_entries(device, part, face, one.channels);
    // NaN differs from every number, so the first number is recorded as a change
    one.values.assign(one.channels.size(), std::nan(""));
    one.first_channel = devices_.empty() ? 0U : devices_.back().first_channel + devices_.back().channels.size();
    devices_.push_back(std::move(one));
}

std::vector<KnownNode> Recorder::known_nodes() const {
    std::vector<KnownNode> nodes;
    for (const Device& one : devices_) {
        nodes.push_back({one.name, one.device->node_id(), one.part, one.device->objects()});
    }
    return nodes;
}

void Recorder::on_frame(const BusFrame& frame) {
    RecordedFrame recorded;
    recorded.time = frame.time;
    recorded.frame = frame.frame;
    recorded.sender = frame.sender == nullptr ? "" : frame.sender->name();
    recorded.words = decoder_.decode(frame.frame, known_nodes());
    for (Device& one : devices_) {
        if (recorded.words.service == FrameService::emcy && one.name == recorded.sender) {
            const bool error = frame.frame.data[0] != 0U || frame.frame.data[1] != 0U;
            one.emergency = LastEmergency{frame.time, recorded.words.text, error};
        }
    }
    frames_.push(std::move(recorded));
}

void Recorder::on_step(Instant at) {
    const bool measures = next_measuring_ <= at;
    next_measuring_ = measures ? at + measuring_period : next_measuring_;
    for (Device& one : devices_) {
        const auto outputs = one.device->outputs();
        for (std::size_t i = 0; i < outputs.size(); ++i) {
            put(one, i, outputs[i], at);
        }
        follow_lamps(one, at);
        if (measures) {
            measure(one, at);
        }
    }
    last_step_ = at;
}

/// Records the changes of the LEDs that the panel adds, for the time since the last step. The NMT state and the error
/// register do not change between two steps, so the LED changes can be computed afterwards.
void Recorder::follow_lamps(Device& device, Instant at) {
    for (std::size_t i = 0; i < device.channels.size(); ++i) {
        if (device.channels[i].kind != Channel::Kind::lamp) {
            continue;
        }
        if (device.channels[i].name == "error") {
            const ObjectDictionary* const objects = device.device->objects();
            put(device, i, objects != nullptr && objects->read(error_register, 0U) != 0U ? 1.0 : 0.0, at);
            continue;
        }
        const IndicatorPattern pattern = run_lamp(device.device->state());
        Instant time = last_step_;
        while (time <= at) {
            const IndicatorPhase phase = indicator_phase(pattern, time, Duration{});
            put(device, i, phase.lit ? 1.0 : 0.0, time);
            time = phase.next_change;
        }
    }
}

void Recorder::measure(Device& device, Instant at) {
    for (std::size_t i = 0; i < device.channels.size(); ++i) {
        if (device.channels[i].entry != nullptr) {
            put(device, i, number_of(device.channels[i], *device.device->objects()), at);
        }
    }
}

void Recorder::put(Device& device, std::size_t channel, double value, Instant at) {
    if (const auto lamp = device.lamps.find(channel); lamp != device.lamps.end()) {
        lamp->second.show(value != 0.0, at);
    }
    if (!same(device.values[channel], value)) {
        device.values[channel] = value;
        changes_.push({at, device.first_channel + channel, value});
    }
}

}  // namespace canproof::host
