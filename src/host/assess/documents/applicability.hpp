// SPDX-License-Identifier: Apache-2.0
// Decides by the services and objects of a device whether a shared requirement, a shared decision or a threat concerns
// this device. All generated documents take the shared rules from here.
#pragma once

#include <string>
#include <vector>

#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// A condition on the services and objects of a device. Objects are written as `1010h`, `1400h-15FFh`, or with a
/// sub-index as `1400h-15FFh:05`.
struct Condition {
    std::vector<std::string> objects{};  ///< the device has at least one of these objects; empty: no condition
    std::vector<std::string> without{};  ///< the device has none of these objects
    bool lss{false};                     ///< the device has LSS
    bool block{false};                   ///< the device has SDO block transfer
};

/// The condition under which shared items concern a device. Several records can name one item; all of them must hold.
struct SharedCondition {
    std::vector<std::string> items;  ///< ids such as `CO-SYNC-003`, or groups of ids such as `CO-SYNC`
    Condition condition;
    std::string elsewhere;  ///< reason why the items concern no device of the documents; empty: the condition decides
    Place place;
};

/// Returns whether the text names objects in the form that Condition describes.
bool names_objects(const std::string& text);
bool holds(const Condition& condition, const Part& device);

/// Returns whether a record names the item with this id, or its group.
bool is_named(const std::vector<SharedCondition>& shared, const std::string& id);
/// Returns whether the item with this id concerns the device. An item that no record names concerns every device.
bool concerns(const std::vector<SharedCondition>& shared, const std::string& id, const Part& device);

/// Returns the shared rules (spec/canopen) with only those requirements and decisions that concern the device. Returns
/// an empty part when the register has no shared rules.
Part shared_rules_of(const Register& content, const std::vector<SharedCondition>& shared, const Part& device);

/// Checks that a document of the device names no shared item that does not concern the device. Throws InputError.
void check_shared_items(const Document& document, const Register& content, const std::vector<SharedCondition>& shared,
                        const Part& device);

}  // namespace canproof::host
