// Analyses that people write beside the register, in reports/analysis: which requirement detects which failure, what
// a lamp shows, which threats a service meets. The documents take what stands here, and say `missing` of the rest.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// One way in which a signal or a message fails.
struct FailureMode {
    std::vector<std::string> devices;
    std::vector<std::string> signals;  ///< ids; empty: `at` names what fails
    std::string at;
    std::string mode;
    std::vector<std::string> detected;  ///< requirements
    std::vector<std::string> reaction;  ///< requirements
    std::vector<std::string> errors;    ///< words of the device's tables of errors
    std::string note;
    Place place;
};

/// What a lamp shows while an error lasts.
struct Lamp {
    std::string device;
    std::string error;
    std::string shows;
    std::vector<std::string> by;  ///< requirements
    Place place;
};

/// A threat to a service. It concerns a device that has one of the objects, or any device when there are none.
struct Threat {
    std::string service;
    std::vector<std::string> objects;  ///< `1010h`
    bool lss{false};                   ///< concerns devices with LSS only
    std::string requirement;           ///< foundational requirement of IEC 62443 that it is about
    std::string text;
    std::vector<std::string> by;  ///< requirements that limit it; empty: nothing in the device does
    std::string rest;             ///< what is left, or what the integrator must add
    Place place;
};

/// An error of communication as IEC 61784-3 sorts them, and what notices it.
struct CommunicationError {
    std::string error;
    std::vector<std::string> by;
    std::string rest;
    Place place;
};

struct Analysis {
    std::vector<FailureMode> failure_modes;
    std::vector<Lamp> lamps;
    std::vector<Threat> threats;
    std::vector<CommunicationError> communication;
};

/// All TOML files of the folder; nothing without it. Throws InputError with file, line and fix for what cannot be read,
/// and for an id, device, signal or error that the register does not have.
Analysis read_analysis(const std::filesystem::path& folder, const Register& content);

/// The modes that a signal is looked at for, by its type and direction.
std::vector<std::string> modes_of(const Signal& signal);

/// The emergency code of an error of the device, `8130h`; empty when no table of errors has it.
std::string emergency_code(const Register& content, const Part& part, const std::string& error);

}  // namespace canproof::host
