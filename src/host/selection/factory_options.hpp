// SPDX-License-Identifier: Apache-2.0
// The option `--factory KEY=VALUE`: values that the factory sets in one unit. The keys are the entries that the
// requirements register marks as factory data, with their types and ranges. The AX060805 has more keys, for values that
// no object contains.
#pragma once

#include <string>
#include <vector>

#include "host/register/register.hpp"
#include "host/sim/devices/factory_key.hpp"
#include "host/sim/devices/factory_values.hpp"

namespace canproof::host {

/// Returns the part number in NAME or NAME@NODE. Returns an empty text for the device's own name, which stands for all
/// part numbers.
std::string part_number_of(const std::string& name, const Part& part);

/// Returns the keys of `--factory` for a unit with this part number. For an empty part number, returns the keys of the
/// device.
std::vector<FactoryKey> factory_keys(const Part& part, const std::string& part_number = {});

/// The factory values on the command line: KEY=VALUE applies to every device that has the key, DEVICE.KEY=VALUE to one
/// device.
class FactoryOptions {
  public:
    FactoryOptions() = default;
    /// Parses the options. Throws InputError for a text that is not KEY=VALUE.
    explicit FactoryOptions(const std::vector<std::string>& given);

    /// Returns the values for a device; `name` is what the user wrote, NAME or NAME@NODE. Throws InputError for a value
    /// out of range.
    FactoryValues for_device(const std::string& name, const Part& part);
    /// Throws InputError when an option applied to none of the devices.
    void check_used() const;

  private:
    struct Given {
        std::string whole;
        std::string device;  ///< DEVICE of DEVICE.KEY=VALUE; empty: every device
        std::string key;
        std::string value;
        bool used{false};
        /// keys of the devices to which for_device() was applied; an error message lists them
        std::vector<std::string> others;
    };
    std::vector<Given> given_;
};

}  // namespace canproof::host
