// The panel over HTTP on the loopback.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "host/panel/panel.hpp"

namespace canproof::host {

class PanelServer {
  public:
    /// Listens from here on, in threads of its own. Port 0: any that is free. Throws InputError when the port cannot be
    /// had.
    PanelServer(Panel& panel, std::uint16_t port);
    ~PanelServer();
    PanelServer(const PanelServer&) = delete;
    PanelServer& operator=(const PanelServer&) = delete;

    std::uint16_t port() const { return port_; }
    /// `http://127.0.0.1:8404/`
    std::string address() const;

  private:
    struct Listener;
    std::unique_ptr<Listener> listener_;
    std::uint16_t port_{0};
};

}  // namespace canproof::host
