// `--factory KEY=VALUE`: what belongs to one unit and left the factory with it. The keys are the entries that the
// register marks so, with their types and ranges, and what a unit of the AX060805 has that no object shows.
#pragma once

#include <string>
#include <vector>

#include "host/register/register.hpp"
#include "host/sim/devices/factory_key.hpp"
#include "host/sim/devices/factory_values.hpp"

namespace canproof::host {

/// The part number that a device is named by, NAME or NAME@NODE; empty where it is the device's own name, which stands
/// for all of them.
std::string part_number_of(const std::string& name, const Part& part);

/// Those of a unit of that part number; of the device's own name without one.
std::vector<FactoryKey> factory_keys(const Part& part, const std::string& part_number = {});

/// What the user gave: KEY=VALUE for every device that has the key, DEVICE.KEY=VALUE for one by its name.
class FactoryOptions {
  public:
    FactoryOptions() = default;
    /// Throws InputError for what is no KEY=VALUE.
    explicit FactoryOptions(const std::vector<std::string>& given);

    /// Those of a device: `name` as the user wrote it, NAME or NAME@NODE. Throws InputError for a value out of range.
    FactoryValues for_device(const std::string& name, const Part& part);
    /// Throws InputError when one of them was for none of the devices asked for.
    void check_used() const;

  private:
    struct Given {
        std::string whole;
        std::string device;  ///< empty: every device
        std::string key;
        std::string value;
        bool used{false};
        std::vector<std::string> others;  ///< keys of devices that it could have been for
    };
    std::vector<Given> given_;
};

}  // namespace canproof::host
