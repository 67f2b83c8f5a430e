// SPDX-License-Identifier: Apache-2.0
// TCP sockets that never wait: finds the address of a host, listens, accepts clients, connects, and sends text.
#pragma once

#include <sys/socket.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "host/base/descriptor.hpp"

namespace canproof::host {

/// The address of a socket, as the kernel needs it.
struct SocketAddress {
    sockaddr_storage bytes{};
    socklen_t size{0};
};

/// The words of an InputError when an address cannot be used: `cannot DEED (REASON); REMEDY`.
struct AddressUse {
    std::string deed;    ///< intention of the program, such as `listen at 127.0.0.1:29536`
    std::string remedy;  ///< advice to the user, such as `name another port`
};

/// Whether a host may be a name, which the system has to look up.
enum class HostForm { number, name_or_number };

/// A socket that listens, and its port.
struct Listener {
    Descriptor socket;
    std::uint16_t port{0};
};

/// A socket whose connection is under way; or a socket that is not open, and the errno that says why.
struct StartedConnection {
    Descriptor socket;
    int error{0};
};

/// The state of a connection that has been started: under way as long as `established` is false and
/// `error` is 0.
struct ConnectionState {
    bool established{false};
    int error{0};  ///< errno of a connection that has failed
};

/// Throws InputError with the words of `use` and with this reason.
[[noreturn]] void refuse_address(const AddressUse& use, const std::string& reason);

/// Returns the first address of a TCP server. Throws InputError for an unknown host.
SocketAddress find_address(const std::string& host, std::uint16_t port, HostForm form, const AddressUse& use);

/// Listens at a port of a host, which must be a number. Port 0 selects any free port. Up to `most_waiting` clients can
/// wait for accept_client(). Throws InputError with the address, the reason and this remedy.
Listener listen_at(const std::string& host, std::uint16_t port, int most_waiting, const std::string& remedy);

/// Returns the connection of the next client. The descriptor is not open when no client waits or when the system gives
/// no further descriptor.
Descriptor accept_client(const Descriptor& listener);

/// Starts to connect to a server.
StartedConnection start_connecting(const SocketAddress& server);
ConnectionState connection_state(const Descriptor& socket);

/// Sends the first part of a text, as much as the kernel takes at once. Returns the number of bytes sent, which is 0
/// when the kernel has no room. Returns nothing, with the reason in errno, when the connection is broken.
std::optional<std::size_t> send_some(const Descriptor& socket, std::string_view text);

/// Switches an option of a socket on. Returns false, with the reason in errno, when this fails.
bool switch_on(int descriptor, int level, int option);

}  // namespace canproof::host
