// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <streambuf>
#include <string_view>
#include <system_error>

#include "host/app/cli/same_file.hpp"
#include "host/base/descriptor.hpp"
#include "host/base/file_lock.hpp"
#include "host/base/input_error.hpp"
#include "host/base/write_all.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t buffer_size = 65536;

[[noreturn]] void refuse_to_write(const std::string& path, int error) {
    throw InputError{fmt::format("cannot write {} ({}); name another file", path, std::strerror(error))};
}

/// Locks a regular file. Throws InputError when another process writes it. Does nothing on a file system without locks.
void lock(const Descriptor& file, const std::string& path) {
    try {
        if (!try_lock(file.number())) {
            throw InputError{fmt::format("{} is in use by {}; end that process or name another file", path,
                                         lock_holder(file.number()))};
        }
    } catch (const std::system_error&) {
        return;
    }
}

}  // namespace

/// Buffers text for a file. Empties the file before it writes the first text.
class OutputFile::Writer : public std::streambuf {
  public:
    Writer() { setp(buffer_.data(), buffer_.data() + buffer_.size()); }

    /// Opens the file and creates it if necessary. Keeps its content.
    void open(const std::string& path) {
        file_ = Descriptor{::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666)};
        struct stat found {};
        if (!file_.is_open() || fstat(file_.number(), &found) != 0) {
            refuse_to_write(path, errno);
        }
        is_old_ = S_ISREG(found.st_mode);
        if (is_old_) {
            lock(file_, path);
        }
    }
    bool is_open() const { return file_.is_open(); }
    /// Empties the file unless it was emptied before. Returns false when the system refuses that.
    bool empty_once() {
        if (is_old_ && ftruncate(file_.number(), 0) != 0) {
            refusal_ = errno;
            return false;
        }
        is_old_ = false;
        return true;
    }
    /// Returns the number of the error because of which the file could not be emptied; 0 without such an error.
    int refusal() const { return refusal_; }

  protected:
    int_type overflow(int_type one) override {
        if (!write_out()) {
            return traits_type::eof();
        }
        if (!traits_type::eq_int_type(one, traits_type::eof())) {
            *pptr() = traits_type::to_char_type(one);
            pbump(1);
        }
        return traits_type::not_eof(one);
    }
    int sync() override { return write_out() ? 0 : -1; }

  private:
    bool write_out() {
        const std::string_view waiting{pbase(), static_cast<std::size_t>(pptr() - pbase())};
        if (waiting.empty()) {
            return true;
        }
        if (!is_open() || !empty_once() || !write_all(file_.number(), waiting)) {
            return false;
        }
        setp(buffer_.data(), buffer_.data() + buffer_.size());
        return true;
    }

    Descriptor file_;
    bool is_old_{false};  ///< the file still has the content that it had before the command
    int refusal_{0};
    std::array<char, buffer_size> buffer_{};
};

OutputFile::OutputFile(std::string path)
    : path_{std::move(path)}, writer_{std::make_unique<Writer>()}, out_{writer_.get()} {}

OutputFile::~OutputFile() = default;

void OutputFile::flush() {
    if (writer_->is_open()) {
        out_.flush();
    }
    if (writer_->refusal() != 0) {
        refuse_to_write(path_, writer_->refusal());
    }
}

void OutputFile::finish() {
    flush();
    if (writer_->is_open() && !writer_->empty_once()) {
        refuse_to_write(path_, writer_->refusal());
    }
    if (writer_->is_open() && !out_) {
        throw InputError{
            fmt::format("{} could not be written completely; free space on its disk, or name another file", path_)};
    }
}

void OutputFile::open(const std::vector<OutputFile*>& files, const std::vector<std::string>& inputs) {
    std::vector<std::string> outputs;
    for (const OutputFile* const file : files) {
        if (file->is_wanted()) {
            outputs.push_back(file->path_);
        }
    }
    refuse_same_file(outputs, inputs);
    for (OutputFile* const file : files) {
        if (file->is_wanted()) {
            file->writer_->open(file->path_);
        }
    }
}

}  // namespace canproof::host
