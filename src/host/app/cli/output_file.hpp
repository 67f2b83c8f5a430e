// SPDX-License-Identifier: Apache-2.0
// A file that a command writes during its run. The command empties the file only after all checks have passed; finish()
// checks that the file is complete.
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace canproof::host {

class OutputFile {
  public:
    /// Prepares the file. An empty path means that the user asked for no file.
    explicit OutputFile(std::string path) : path_{std::move(path)} {}

    bool is_wanted() const { return !path_.empty(); }
    /// Returns the stream to write to; nullptr when the user requested no file.
    std::ostream* stream() { return is_wanted() ? &out_ : nullptr; }
    /// Writes the buffered text to the file.
    void flush();
    /// Flushes the file. Throws InputError when not everything could be written.
    void finish();

    /// Opens all files of a command. First checks that each file can be written and is neither an input nor another of
    /// the files, and then empties the files. Throws InputError.
    static void open(const std::vector<OutputFile*>& files, const std::vector<std::string>& inputs);

  private:
    std::string path_;
    std::ofstream out_;
};

}  // namespace canproof::host
