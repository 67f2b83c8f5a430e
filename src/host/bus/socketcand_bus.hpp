// The in-process bus with a socketcand server: machines and tools without SocketCAN join over TCP.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/bus/arbitrated_bus.hpp"
#include "host/bus/socketcand_session.hpp"

namespace canproof::host {

/// Host and port to listen at. Port 0: any that is free.
struct ListenAddress {
    std::string host{"127.0.0.1"};
    std::uint16_t port{29536};
};

/// `127.0.0.1:29536`, `[::1]:29536`, `:0`; what is left out is as in ListenAddress. Throws InputError.
ListenAddress parse_listen_address(const std::string& text);

class SocketcandBus final : public Bus {
  public:
    static constexpr std::size_t most_clients = 32;

    /// Listens from here on. Throws InputError when the address cannot be had. `epoch_us`: real time at the run's time
    /// 0.
    SocketcandBus(const ListenAddress& address, std::uint32_t bit_rate, const BusFaultRates& faults,
                  std::uint64_t epoch_us);
    ~SocketcandBus() override;
    SocketcandBus(const SocketcandBus&) = delete;
    SocketcandBus& operator=(const SocketcandBus&) = delete;

    void attach(BusNode& node) override { bus_.attach(node); }
    bool put(const Frame& frame, Instant now) override { return bus_.put(frame, now); }
    std::vector<Watch> watches() const override;
    Instant poll(Instant now) override;
    void advance(Instant now) override;
    Instant next_deadline() const override;
    BusReport report(Instant now) const override { return bus_.report(now); }
    const std::string& interface() const override { return bus_.interface(); }

    /// The port that it listens at.
    std::uint16_t port() const { return port_; }
    std::size_t clients() const { return clients_.size(); }

  private:
    struct Client {
        int descriptor{-1};
        std::string name;
        std::unique_ptr<SocketcandSession> session;
        bool ended{false};  ///< sends no more; what it has sent still goes onto the bus
        bool gone{false};
    };

    void accept_clients();
    void read_client(Client& client, Instant now);
    void write_client(Client& client);
    void drop_gone_clients();

    ArbitratedBus bus_;
    std::uint64_t epoch_us_;
    int listener_{-1};
    std::uint16_t port_{0};
    std::vector<Client> clients_;
};

}  // namespace canproof::host
