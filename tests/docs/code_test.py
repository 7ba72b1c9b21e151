"""code_test.py CXX FLAG...: every cpp block of the documents compiles, as C++17 and without warnings. A block is a whole
file, or what stands in a function that has the host's own things, as wrapped here."""
import subprocess
import sys
import tempfile

from blocks import all_blocks

# What the host has, under the names that the documents give it.
HOST = """
#include <vulkan/vulkan.h>
#include <seaglass/water.h>
#include <seaglass/water_type.h>
extern VkInstance instance;
extern VkPhysicalDevice physicalDevice;
extern VkDevice vkDevice;
extern VkCommandBuffer commands;
extern seaglass::Context* context;
extern seaglass::Target* target;
extern seaglass::ViewDesc view;
extern seaglass::LightingDesc lighting;
extern uint32_t slot;
extern seaglass::DeviceDesc device;
extern seaglass::TargetDesc attachments;
extern seaglass::BodyDesc desc;
extern seaglass::Body* body;
extern seaglass::Status status;
extern double timeInSeconds;
void host();
void host() {
"""


def wrapped(block):
    lines = block.text.splitlines()
    if any(line.startswith("int main(") or line.startswith("void ") for line in lines):
        return block.text
    includes = [line for line in lines if line.startswith("#include")]
    rest = ["" if line.startswith("#include") else line for line in lines]
    return "\n".join(includes) + HOST + f'#line {block.line} "{block.document}"\n' + "\n".join(rest) + "\n}\n"


def main():
    compiler, problems, count = sys.argv[1:], [], 0
    for block in all_blocks("cpp"):
        with tempfile.NamedTemporaryFile("w", suffix=".cpp") as file:
            file.write(wrapped(block))
            file.flush()
            done = subprocess.run([*compiler, "-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion",
                                   "-Wno-unused-but-set-variable", "-Werror", file.name], capture_output=True, text=True)
        count += 1
        if done.returncode != 0:
            problems.append(f"{block}: does not compile\n{done.stderr}")
    print("\n".join(problems))
    return 1 if problems or count == 0 else 0


sys.exit(main())
