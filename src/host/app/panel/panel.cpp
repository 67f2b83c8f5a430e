// SPDX-License-Identifier: Apache-2.0
#include "host/app/panel/panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "generated/canopen/index.hpp"
#include "host/app/panel/assets.hpp"
#include "host/base/input_error.hpp"
#include "host/base/time_text.hpp"
#include "host/base/utf8.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/run/device_names.hpp"
#include "host/sim/run/live_table.hpp"

namespace canproof::host {

namespace {

using nlohmann::json;

using generated::canopen::index::error_register;

/// Returns the device's panel.json, which describes how the page draws the device; an empty object for a device without
/// this file.
json view_of(const Part* part) {
    const auto found = panel_assets().find("views/" + (part == nullptr ? "" : part->name) + ".json");
    return found == panel_assets().end() ? json::object() : json::parse(found->second);
}

DeviceFace face_of(const json& view) {
    DeviceFace face;
    for (const json& lamp : view.value("lamps", json::array())) {
        face.leds.push_back(lamp.at("signal").get<std::string>());
    }
    const json all_marks = view.value("marks", json::object());
    for (const auto& [signal, marks] : all_marks.items()) {
        for (const json& mark : marks) {
            face.settings.push_back(mark.at("entry").get<std::string>());
        }
    }
    return face;
}

json optional_number(const std::optional<double>& number) {
    return number ? json(*number) : json();
}

const Signal* input_signal(const Part* part, const std::string& name) {
    for (std::size_t i = 0; part != nullptr && i < part->signals.size(); ++i) {
        const auto names = part->signals[i].names();
        if (part->signals[i].input && std::find(names.begin(), names.end(), name) != names.end()) {
            return &part->signals[i];
        }
    }
    return nullptr;
}

json described_inputs(const SimulatedDevice& device, const Part* part) {
    json inputs = json::array();
    for (const std::string& name : device.input_names()) {
        json input{{"name", name}};
        if (const Signal* const signal = input_signal(part, name); signal != nullptr) {
            input["type"] = signal->type;
            input["unit"] = signal->unit;
            input["min"] = optional_number(signal->minimum);
            input["max"] = optional_number(signal->maximum);
            input["text"] = signal->text;
        }
        inputs.push_back(std::move(input));
    }
    return inputs;
}

const char* kind_word(Channel::Kind kind) {
    switch (kind) {
        case Channel::Kind::lamp:
            return "lamp";
        case Channel::Kind::measured:
            return "measured";
        case Channel::Kind::setting:
            return "setting";
        case Channel::Kind::output:
        default:
            return "output";
    }
}

json described_channels(const Recorder::Device& device) {
    json channels = json::array();
    for (std::size_t i = 0; i < device.channels.size(); ++i) {
        const Channel& one = device.channels[i];
        channels.push_back({{"name", one.name},
                            {"kind", kind_word(one.kind)},
                            {"led", device.lamps.count(i) != 0},
                            {"text", one.text},
                            {"unit", one.unit},
                            {"truth", one.truth},
                            {"whole", one.whole},
                            {"min", optional_number(one.minimum)},
                            {"max", optional_number(one.maximum)}});
    }
    return channels;
}

json described_enumerations(const Part* part) {
    json all = json::object();
    for (std::size_t i = 0; part != nullptr && i < part->enumerations.size(); ++i) {
        json values = json::object();
        for (const auto& [word, value] : part->enumerations[i].values) {
            values[word] = value;
        }
        all[part->enumerations[i].name] = std::move(values);
    }
    return all;
}

json described_frame(std::uint64_t number, const RecordedFrame& one) {
    const std::string text = format_frame(one.frame);
    const auto hash = text.find('#');
    return {{"n", number},
            {"t", one.time.us},
            {"id", text.substr(0, hash)},
            {"data", text.substr(hash + 1)},
            {"from", one.sender},
            {"service", service_word(one.words.service)},
            {"node", one.words.node},
            {"text", one.words.text}};
}

PanelResponse ok(const json& body) {
    return {200, "application/json", body.dump(-1, ' ', false, json::error_handler_t::replace)};
}

/// Returns the media type of a file of the page by its extension: text/html for any other than .js, .css and .svg.
const char* asset_type(const std::string& path) {
    if (path.size() > 3 && path.substr(path.size() - 3) == ".js") {
        return "text/javascript; charset=utf-8";
    }
    if (path.size() > 4 && path.substr(path.size() - 4) == ".css") {
        return "text/css; charset=utf-8";
    }
    return path.size() > 4 && path.substr(path.size() - 4) == ".svg" ? "image/svg+xml" : "text/html; charset=utf-8";
}

/// Returns the name of the embedded file for a path of the page.
std::string asset_of(const std::string& path) {
    return "page" + (path == "/" ? "/index.html" : path);
}

/// Returns the methods that a path has, as in the header Allow; an empty text for an unknown path.
std::string methods_of(const std::string& path) {
    if (path == "/api/stimulus" || path == "/api/frame") {
        return "POST";
    }
    const bool known = path == "/api/panel" || path == "/api/state" || path == "/stimuli.csv" ||
                       panel_assets().count(asset_of(path)) != 0;
    return known ? "GET, HEAD" : "";
}

}  // namespace

Panel::Panel(const Register& content, Clock clock)
    : clock_{std::move(clock)}, pace_{clock_, [this](const std::string& text) { notice(text); }}, recorder_{content} {}

void Panel::take(RunSession& session, std::vector<const Part*> parts) {
    session_ = &session;
    session.bus().use_clock(clock_);
    parts_ = std::move(parts);
    for (std::size_t i = 0; i < session.nodes().size(); ++i) {
        views_.push_back(view_of(parts_[i]));
        const DeviceNode& node = *session.nodes()[i];
        recorder_.add(node.name(), node.device(), parts_[i], face_of(views_.back()));
    }
}

void Panel::power_on() {
    session_->power_on();
}

void Panel::advance_to(Instant now) {
    pace_.advance(*session_, now);
    recorder_.on_step(session_->now());
}

Instant Panel::next_deadline() const {
    return session_->next_deadline();
}

std::vector<Watch> Panel::watches() const {
    return session_->bus().watches();
}

void Panel::notice(const std::string& text) {
    notices_.push(text);
}

PanelResponse Panel::answer(const PanelRequest& request) {
    auto refusal = refuse(request);
    const std::string allowed = methods_of(request.path);
    const bool may_know = !refusal || refusal->status == 405 || refusal->status == 415;
    if (may_know && !allowed.empty() && allowed.find(request.method) == std::string::npos) {
        return wrong_method(allowed);
    }
    if (refusal) {
        return *std::move(refusal);
    }
    return request.method == "POST" ? post(request) : get(request);
}

PanelResponse Panel::get(const PanelRequest& request) const {
    const std::string file = asset_of(request.path);
    if (const auto found = panel_assets().find(file); found != panel_assets().end()) {
        return {200, asset_type(file), found->second};
    }
    if (request.path == "/api/panel") {
        return ok(description());
    }
    if (request.path == "/api/state") {
        return ok(state(request.changes_from, request.frames_from));
    }
    if (request.path == "/stimuli.csv") {
        return {200, "text/csv; charset=utf-8", stimuli_csv()};
    }
    return error_response(404, "there is no such page; use /, /api/panel, /api/state or /stimuli.csv");
}

PanelResponse Panel::post(const PanelRequest& request) {
    const json body = json::parse(request.body, nullptr, false);
    if (!body.is_object()) {
        return error_response(
            400, "the body of the request is no JSON object, or a number in it is too large; send a JSON object");
    }
    if (request.path == "/api/stimulus") {
        return stimulate(body);
    }
    if (request.path == "/api/frame") {
        return send(body);
    }
    return error_response(404, "there is no such request; use /api/stimulus or /api/frame");
}

nlohmann::json Panel::description() const {
    json devices = json::array();
    for (std::size_t i = 0; i < recorder_.devices().size(); ++i) {
        const Recorder::Device& one = recorder_.devices()[i];
        const Part* const part = parts_[i];
        devices.push_back({{"name", one.name},
                           {"part", part == nullptr ? "" : part->name},
                           {"title", part == nullptr ? "" : part->info.title},
                           {"vendor", part == nullptr ? "" : part->info.vendor},
                           {"manual", part == nullptr ? "" : part->info.manual},
                           {"inputs", described_inputs(*one.device, part)},
                           {"channels", described_channels(one)},
                           {"enumerations", described_enumerations(part)},
                           {"view", views_[i]}});
    }
    return {{"devices", std::move(devices)}, {"interface", session_->bus().interface()}};
}

nlohmann::json Panel::device_state(const Recorder::Device& device) const {
    const ObjectDictionary* const objects = device.device->objects();
    json state{{"node", device.device->node_id()},
               {"state", state_word(device.device->state())},
               {"bit_rate", device.device->bit_rate()},
               {"inputs", device.device->inputs()},
               {"values", device.values},
               {"error_register", objects == nullptr ? 0U : objects->read(error_register, 0U)}};
    for (const auto& [channel, lamp] : device.lamps) {
        state["lamps"][device.channels[channel].name] = lamp.words(session_->now());
    }
    if (device.emergency) {
        state["emcy"] = {
            {"t", device.emergency->time.us}, {"text", device.emergency->text}, {"error", device.emergency->error}};
    }
    return state;
}

nlohmann::json Panel::state(std::uint64_t changes_from, std::uint64_t frames_from) const {
    const BusReport report = session_->bus().report(session_->now());
    json devices = json::array();
    for (const Recorder::Device& one : recorder_.devices()) {
        devices.push_back(device_state(one));
    }
    json changes = json::array();
    recorder_.changes().for_each_from(changes_from, changes_at_once, [&](std::uint64_t, const ChannelChange& one) {
        changes.push_back({one.time.us, one.channel, one.value});
    });
    json frames = json::array();
    recorder_.frames().for_each_from(frames_from, frames_at_once, [&](std::uint64_t number, const RecordedFrame& one) {
        frames.push_back(described_frame(number, one));
    });
    return {{"now", session_->now().us},
            {"bus",
             {{"load", report.load},
              {"bit_rate", report.bit_rate},
              {"frames", report.frames},
              {"errors", report.errors},
              {"lost", report.lost},
              {"missed", report.missed},
              {"lag_us", pace_.lag().us},
              {"latency_us", report.worst_latency.us}}},
            {"devices", std::move(devices)},
            {"next_change", recorder_.changes().next()},
            {"changes", std::move(changes)},
            {"next_frame", recorder_.frames().next()},
            {"frames", std::move(frames)},
            {"notices", notices_.items()},
            {"next_notice", notices_.next()},
            {"stimuli", stimuli_.next()}};
}

/// Returns the stimuli as CSV for `run` and `replay`. If there is only one device, leaves out the name of the device,
/// because `replay` accepts no device names.
std::string Panel::stimuli_csv() const {
    std::string text = "seconds,signal,value\n";
    const bool single = session_->nodes().size() == 1U;
    for (const Stimulus& one : stimuli_.items()) {
        const std::string signal = single ? one.signal.substr(one.signal.rfind('.') + 1) : one.signal;
        text += fmt::format("{},{},{}\n", format_seconds(one.time), signal, one.value);
    }
    return text;
}

PanelResponse Panel::stimulate(const nlohmann::json& body) {
    const auto device = body.find("device");
    const auto signal = body.find("signal");
    const auto value = body.find("value");
    if (device == body.end() || !device->is_string() || signal == body.end() || !signal->is_string() ||
        value == body.end() || !value->is_number()) {
        return error_response(
            400,
            R"(the request needs the texts `device` and `signal` and the number `value`; send {"device": "ax188001", "signal": "tc1_celsius", "value": 25.0})");
    }
    std::vector<std::string> names;
    for (const Recorder::Device& one : recorder_.devices()) {
        names.push_back(one.name);
    }
    const Recorder::Device* found = nullptr;
    try {
        found = &recorder_.devices()[find_device(names, shown_text(device->get<std::string>()))];
    } catch (const InputError& error) {
        return error_response(404, error.what());
    }
    const Instant now = std::max(clock_(), session_->now());
    Stimulus one{"stimulus", now + microseconds(1), shown_text(signal->get<std::string>()), value->get<double>()};
    try {
        check_stimuli({one}, {found->part});
    } catch (const InputError& error) {
        return error_response(422, error.what());
    }
    one.signal = found->name + "." + one.signal;
    stimuli_.push(one);
    session_->schedule(one);
    return ok({{"seconds", static_cast<double>(one.time.us) / 1.0e6}});
}

PanelResponse Panel::send(const nlohmann::json& body) {
    const auto text = body.find("frame");
    if (text == body.end() || !text->is_string()) {
        return error_response(400, R"(the request contains no frame; send {"frame": "000#0105"})");
    }
    Frame frame;
    try {
        frame = parse_frame(text->get<std::string>(), "frame");
    } catch (const InputError& error) {
        return error_response(422, error.what());
    }
    pace_.advance(*session_, std::max(clock_(), session_->now()));
    if (!session_->put(frame)) {
        return error_response(503, "the bus cannot take a frame now; try again later");
    }
    return ok({{"sent", format_frame(frame)}});
}

}  // namespace canproof::host
