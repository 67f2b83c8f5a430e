// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#pragma once  // flagged
int now();
