// SPDX-License-Identifier: Apache-2.0
// Terms that the requirements register defines once for all services: NMT states and commands, SDO abort codes (CiA
// 301, 7.2.4.3.17; `AbortCode::none` means success), states of the CAN controller (ISO 11898-1, fault confinement).
#pragma once

#include "generated/canopen/enumerations.hpp"

namespace canproof {

using generated::canopen::AbortCode;
using generated::canopen::CanState;
using generated::canopen::NmtCommand;
using generated::canopen::NmtState;

}  // namespace canproof
