// SPDX-License-Identifier: Apache-2.0
// A file that a command writes during its run. The command empties the file only when it writes the first text, so that
// a run that cannot start leaves the file as it is. One process at a time writes the file.
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace canproof::host {

class OutputFile {
  public:
    /// Prepares the file. An empty path means that the user asked for no file.
    explicit OutputFile(std::string path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    bool is_wanted() const { return !path_.empty(); }
    /// Returns the stream to write to; nullptr when the user requested no file.
    std::ostream* stream() { return is_wanted() ? &out_ : nullptr; }
    /// Writes the buffered text to the file. Throws InputError when the file cannot be emptied for the first text.
    void flush();
    /// Flushes the file, which is then empty or has all text. Throws InputError when not everything could be written.
    void finish();

    /// Opens and locks all files of a command. First checks that none of them is an input or another of the files.
    /// Throws InputError. No file is emptied yet.
    static void open(const std::vector<OutputFile*>& files, const std::vector<std::string>& inputs);

  private:
    class Writer;

    std::string path_;
    std::unique_ptr<Writer> writer_;
    std::ostream out_;
};

}  // namespace canproof::host
