// prove: theorems about the firmware, by the program canproof-prove beside this one.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

/// Starts it with these words and waits. Its exit status. Throws InputError when it is not there.
int prove(const std::vector<std::string>& words);

}  // namespace canproof::host
