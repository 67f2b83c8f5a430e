// SPDX-License-Identifier: Apache-2.0
// The documents of one device that are generated from the requirements register.
#pragma once

#include <vector>

#include "host/assess/documents/analysis.hpp"
#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Returns the six documents: safety manual, hardware-software interface, interface control document, error matrix,
/// software FMEA and threats.
std::vector<Document> device_documents(const Register& content, const Part& part, const Analysis& analysis);

}  // namespace canproof::host
