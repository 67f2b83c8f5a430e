// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <fstream>  // flagged
void both(std::fstream& stream);  // flagged
