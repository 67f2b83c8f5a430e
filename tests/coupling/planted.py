# SPDX-License-Identifier: Apache-2.0
"""An invented firmware with planted faults, on which tests/coupling/run tries itself."""
import pathlib
import tempfile

from ast_of_units import Reader

FILES = {
    "src/firmware/base/sum.hpp": """#pragma once
namespace canproof { struct Sum { int value{0}; void add(int); int get() const; }; int count();
template <typename T> struct Kept { T value; explicit Kept(const T& from) : value{from} {} }; }""",
    "src/firmware/base/sum.cpp": """#include "firmware/base/sum.hpp"
#include "firmware/canopen/node.hpp"
namespace canproof { int calls{0};
void Sum::add(int more) { value += more + next(); } int Sum::get() const { return value; } }""",
    "src/firmware/canopen/node.hpp": """#pragma once
#include "firmware/base/sum.hpp"
namespace canproof { int next(); struct Node { Sum sum; void run(); }; }""",
    "src/firmware/canopen/node.cpp": """#include "firmware/canopen/node.hpp"
namespace canproof { int next() { return 1; }
void Node::run() { sum.add(2); sum.value = sum.get(); Kept<Node> kept{*this}; } }""",
    "generated/toy/signals.hpp": """#pragma once
namespace canproof::toy { struct Inputs { int level{0}; int state{0}; }; struct Outputs { bool on{false}; };
template <typename Group, typename Visit> void for_each_input(Group& group, const Visit& visit) { visit(group.level); } }""",
    "src/devices/other/firmware/filter.hpp": """#pragma once
namespace canproof { inline int filtered(int value) { return value; } }""",
    "src/devices/toy/firmware/toy.hpp": """#pragma once
#include "devices/other/firmware/filter.hpp"
#include "generated/toy/signals.hpp"
namespace canproof::toy { struct Device { int seen{0}; Outputs outputs() const { return Outputs{seen > 0}; }
void act(const Inputs& inputs) { seen = filtered(inputs.level); } void rest() {} }; }""",
    "src/target/stm32f405/pin.hpp": """#pragma once
namespace canproof::toy { struct Device; }
namespace canproof { struct Pin { bool on{false}; void set(bool to) { on = to; } bool get() const { return on; } void tell(toy::Device&); };
template <typename Target> struct Relay { Target& target; void pass() { target.rest(); } void (*hooks[1])() {};
void hook() { hooks[0](); } };
struct Pins { Pin pins[2]; Pin* begin() { return pins; } Pin* end() { return pins + 2; } }; }""",
    "src/target/stm32f405/pin.cpp": """#include "target/stm32f405/pin.hpp"
#include "devices/toy/firmware/toy.hpp"
namespace canproof { void Pin::tell(toy::Device& device) {
device.rest();
device.seen = 1; } }""",
    "src/target/stm32f405/device_loop.hpp": """#pragma once
#include "target/stm32f405/pin.hpp"
namespace canproof { template <typename Device, typename Board> struct Loop { Device& device; Board& board;
typename Board::Inputs inputs{Board::first()};
Loop(Device& its_device, Board& its_board) : device{its_device}, board{its_board} {}
void pass() { board.read(inputs); inputs.state = 1; step(); }
void step() { device.act(inputs); board.drive(device.outputs()); } };
template <typename Device> void idle(Device& device) {
device.rest(); } }""",
    "src/devices/toy/target/wiring.hpp": """#pragma once
#include "devices/toy/firmware/toy.hpp"
#include "target/stm32f405/pin.hpp"
namespace canproof::toy { struct Wiring { using Inputs = toy::Inputs; Pins pins{}; static Inputs first() { return Inputs{}; }
void read(Inputs& inputs) { for (Pin& pin : pins) { inputs.level = pin.get() ? 1 : 0; } }
void drive(const Outputs& outputs) { pins.begin()->set(outputs.on); } }; }""",
    "src/target/image/image.hpp": """#pragma once
#include "target/stm32f405/device_loop.hpp"
extern "C" void received();
namespace canproof { template <typename Device, typename Wiring> struct Image { Device device{}; Wiring wiring{};
Relay<Device> relay{device};
void run() { Loop<Device, Wiring> loop{device, wiring}; loop.pass(); relay.pass(); relay.hook(); } }; }""",
    "src/target/image/interrupts.cpp": """#include "target/image/image.hpp"
void (*const handler)() = received;""",
    "src/devices/toy/target/device.cpp": """#include "devices/toy/target/wiring.hpp"
#include "target/image/image.hpp"
namespace { canproof::Image<canproof::toy::Device, canproof::toy::Wiring> image;
int spare{0}; }
void received() {} void start() { image.run(); }""",
}
FAULTS = [
    "src/devices/toy/target/device.cpp:4: spare can change and stands outside of objects",
    "src/firmware/base/sum.cpp:3: calls can change and stands outside of objects",
    "src/devices/toy/firmware/toy.hpp:5: src/devices/toy/firmware/toy calls filtered of src/devices/other/firmware/filter, which is no lower "
    "layer",
    "src/firmware/base/sum.cpp:4: src/firmware/base/sum calls next of src/firmware/canopen/node, which is no lower layer",
    "src/target/stm32f405/device_loop.hpp:9: calls a function that is unknown",
    "src/target/stm32f405/pin writes Device of src/devices/toy/firmware/toy, which is no lower layer",
    "src/target/stm32f405/pin writes Device::seen of src/devices/toy/firmware/toy, which is no lower layer",
    "src/target/stm32f405/pin.cpp:4: src/target/stm32f405/pin calls Device::rest of src/devices/toy/firmware/toy, which is no lower layer",
    "src/target/stm32f405/pin.hpp:5: calls a function that is unknown",
    "src/target/stm32f405/pin.hpp:4: src/target/stm32f405/pin calls Device::rest of src/devices/toy/firmware/toy, which is no lower layer",
]
BASE, NODE, SIGNALS = "src/firmware/base/sum", "src/firmware/canopen/node", "generated/toy/signals"
TOY, OTHER = "src/devices/toy/firmware/toy", "src/devices/other/firmware/filter"
PIN, LOOP, IMAGE = "src/target/stm32f405/pin", "src/target/stm32f405/device_loop", "src/target/image/image"
WIRING, DEVICE, INTERRUPTS = "src/devices/toy/target/wiring", "src/devices/toy/target/device", "src/target/image/interrupts"
CALLS = {
    (BASE, NODE): {"next"},
    (NODE, BASE): {"Sum::add", "Sum::get", "Kept::Kept"},
    (TOY, OTHER): {"filtered"},
    (PIN, TOY): {"Device::rest"},
    (LOOP, TOY): {"Device::act", "Device::outputs"},
    (LOOP, WIRING): {"Wiring::first", "Wiring::read", "Wiring::drive"},
    (WIRING, PIN): {"Pin::get", "Pin::set", "Pins::begin", "Pins::end"},
    (IMAGE, LOOP): {"Loop::Loop", "Loop::pass"},
    (IMAGE, PIN): {"Relay::pass", "Relay::hook"},
    (DEVICE, IMAGE): {"Image::Image", "Image::run"},
    (INTERRUPTS, IMAGE): {"received"},
}
WRITTEN = {
    ("Sum", BASE): {NODE}, ("Sum::value", BASE): {NODE}, ("Device", TOY): {PIN, LOOP}, ("Device::seen", TOY): {PIN},
    ("Inputs::level", SIGNALS): {WIRING}, ("Inputs::state", SIGNALS): {LOOP}, ("Wiring", WIRING): {LOOP},
    ("Pin", PIN): {WIRING}, ("Pins", PIN): {WIRING}, ("Relay", PIN): {IMAGE}, ("Loop", LOOP): {IMAGE}, ("Image", IMAGE): {DEVICE},
}
READ = {
    ("Sum", BASE): {NODE}, ("Device", TOY): {LOOP}, ("Inputs::level", SIGNALS): {TOY}, ("Outputs::on", SIGNALS): {WIRING},
    ("Pin", PIN): {WIRING},
}


def try_on_planted_faults(faults_of):
    """Checks that exactly the faults and couplings of the invented firmware are found: its calls in templates, between the main loop,
    a device, its wiring and a driver, are among them."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in FILES.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        reader = Reader(root, root)
        for name in FILES:
            if name.endswith(".cpp"):
                reader.read(root / name, ["-std=c++17", f"-I{root}/src", f"-I{root}"])
        faults = sorted(faults_of(reader))
    found = reader.coupling
    calls = {pair: {what for what, _ in calls} for pair, calls in found.calls.items()}
    for planted, seen in ((sorted(FAULTS), faults), (CALLS, calls), (WRITTEN, dict(found.written)), (READ, dict(found.read))):
        assert planted == seen, f"planted: {planted}\nfound: {seen}"
