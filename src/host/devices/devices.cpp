#include "host/devices/devices.hpp"

namespace canproof::host {

std::unique_ptr<SimulatedDevice> make_device(const std::string& name, const FactoryValues& factory) {
    struct Maker {
        const char* name;
        std::unique_ptr<SimulatedDevice> (*make)(const FactoryValues& factory);
    };
    constexpr Maker makers[]{
        {"ax060805", make_ax060805}, {"ax130751", make_ax130751},   {"ax130771", make_ax130751},
        {"ax188001", make_ax188001}, {"cbx-ao412", make_cbx_ao412},
    };
    for (const Maker& maker : makers) {
        if (name == maker.name) {
            return maker.make(factory);
        }
    }
    return nullptr;
}

}  // namespace canproof::host
