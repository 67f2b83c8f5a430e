// A file that a command writes as it goes: emptied only when nothing can refuse any more, and checked at its end.
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace canproof::host {

class OutputFile {
  public:
    /// An empty path: no file is asked for.
    explicit OutputFile(std::string path) : path_{std::move(path)} {}

    bool is_wanted() const { return !path_.empty(); }
    /// Where the command writes; nullptr when no file is asked for.
    std::ostream* stream() { return is_wanted() ? &out_ : nullptr; }
    /// What has been written, to the file.
    void flush();
    /// Throws InputError when not everything could be written.
    void finish();

    /// All files of a command. Each is found writable, no input and no other of them before the first is emptied.
    /// Throws InputError.
    static void open(const std::vector<OutputFile*>& files, const std::vector<std::string>& inputs);

  private:
    std::string path_;
    std::ofstream out_;
};

}  // namespace canproof::host
