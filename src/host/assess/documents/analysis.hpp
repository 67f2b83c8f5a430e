// SPDX-License-Identifier: Apache-2.0
// Reads the analyses that people write in reports/analysis: the requirements that detect each failure, what the lamps
// (LEDs) show, and the threats to each service. The generated documents use them and print `missing` for everything
// that no analysis contains.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/assess/documents/applicability.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// One failure mode of a signal or a message.
struct FailureMode {
    std::vector<std::string> devices;
    std::vector<std::string> signals;  ///< ids of the signals that fail; empty: `at` names the failing element
    std::string at;
    std::string mode;
    std::vector<std::string> detected;  ///< ids of the requirements that detect the failure
    std::vector<std::string> reaction;  ///< ids of the requirements that react to the failure
    std::vector<std::string> errors;    ///< names of errors in the device's tables of errors
    std::string note;
    Place place;
};

/// The indication of a lamp (LED) of a device during an error.
struct Lamp {
    std::string device;
    std::string error;
    std::string shows;
    std::vector<std::string> by;  ///< ids of the requirements for this indication
    Place place;
};

/// Input signals that describe the simulated world around a device. No sensor of the device measures them.
struct SimulatedInputs {
    std::string device;
    std::vector<std::string> signals;  ///< ids of the signals
    Place place;
};

/// A message of one device that its object dictionary does not show.
struct DeviceMessage {
    std::string device;
    std::string message;
    std::string direction;
    std::string cob_id;
    std::string bytes;
    std::string object;           ///< the object that controls the message: `5555h`
    std::vector<std::string> by;  ///< ids of the requirements for this message
    Place place;
};

/// A threat to a service of the devices for which the condition holds.
struct Threat {
    std::string service;
    Condition condition;
    std::string requirement;  ///< the foundational requirement of IEC 62443 to which the threat belongs
    std::string text;
    std::vector<std::string> by;  ///< ids of requirements that limit the threat; empty: the device does not limit it
    std::string rest;             ///< the part of the threat that remains, or a measure for the integrator
    Place place;
};

/// A communication error in the classification of IEC 61784-3, and its detection.
struct CommunicationError {
    std::string error;
    std::vector<std::string> by;
    std::string rest;
    Place place;
};

struct Analysis {
    std::vector<FailureMode> failure_modes{};
    std::vector<Lamp> lamps{};
    std::vector<Threat> threats{};
    std::vector<CommunicationError> communication{};
    std::vector<SharedCondition> shared{};  ///< the devices that the shared requirements and decisions concern
    std::vector<SimulatedInputs> simulated{};
    std::vector<DeviceMessage> messages{};
};

/// Reads all TOML files of the folder; returns an empty analysis when the folder does not exist. Throws InputError with
/// file, line and fix for unreadable content, and for an id, device, signal, failure mode or error that the register
/// does not have. Also throws it for a record that names a shared requirement which does not concern its device. If the
/// analysis has conditions for shared items, each shared requirement and decision needs one.
Analysis read_analysis(const std::filesystem::path& folder, const Register& content);

/// Returns the failure modes that the analysis must contain for an input signal, according to its type, such as `too
/// low`. Returns none for an output.
std::vector<std::string> modes_of(const Signal& signal);

/// Returns whether this input signal only describes the simulated world around the device.
bool is_simulated(const Analysis& analysis, const Part& part, const std::string& signal);

/// Returns the emergency code of an error of the device, such as `8130h`; empty when no table of errors contains the
/// error or its code.
std::string emergency_code(const Register& content, const Part& part, const std::string& error);

}  // namespace canproof::host
